// SPDX-License-Identifier: MIT
using System;
using LangevinRigid;
using UnityEngine;

namespace LangevinUnity
{
    /// <summary>What lr_bake made of a mesh: an imported .lrb file. One asset may serve any number of batches and worlds.</summary>
    public sealed unsafe class LangevinAsset : ScriptableObject
    {
        [SerializeField, HideInInspector] private byte[] bytes = new byte[0];
        [SerializeField] private MeshMirror meshMirror = MeshMirror.Z;
        [SerializeField] private LangevinAssetNumbers numbers;

        /// <summary>The file as it is.</summary>
        public byte[] Bytes { get { return bytes; } }

        /// <summary>How the mesh that is drawn lies to the one that was baked.</summary>
        public MeshMirror Mirror { get { return meshMirror; } }

        /// <summary>Mass, sizes and the like, read when the file was imported.</summary>
        public LangevinAssetNumbers Numbers { get { return numbers; } }

        /// <summary>An asset from the bytes of a .lrb file, at run time: from a download or a bundle of your own.</summary>
        public static LangevinAsset FromBytes(byte[] fileBytes, MeshMirror mirror)
        {
            if (fileBytes == null) throw new ArgumentNullException("fileBytes");
            var asset = CreateInstance<LangevinAsset>();
            asset.bytes = fileBytes;
            asset.meshMirror = mirror;
            IntPtr handle = asset.Load();
            try { asset.numbers = LangevinAssetNumbers.Of(handle); }
            finally { Native.lr_asset_release(handle); }
            return asset;
        }

        /// <summary>The library's asset, with a reference that the caller releases. What is wrong with the bytes is in the exception.</summary>
        internal IntPtr Load()
        {
            LangevinLibrary.EnsureLoaded();
            IntPtr handle;
            Status status;
            byte none;
            fixed (byte* first = bytes) status = Native.lr_asset_load_memory(first == null ? &none : first, (ulong)bytes.Length, &handle);
            if (status != Status.Ok) throw new LangevinException(status, "lr_asset_load_memory", name, Asset.Check(bytes));
            return handle;
        }
    }

    /// <summary>The numbers of an asset that people look at.</summary>
    [Serializable]
    public unsafe struct LangevinAssetNumbers
    {
        /// <summary>Name in the file.</summary>
        public string bakedName;
        /// <summary>kg.</summary>
        public double mass;
        /// <summary>m^3.</summary>
        public double volume;
        /// <summary>kg/m^3.</summary>
        public double density;
        /// <summary>m, the largest extent.</summary>
        public double length;
        /// <summary>m.</summary>
        public double thickness;
        /// <summary>m/s, about how fast it falls.</summary>
        public double fallSpeed;
        /// <summary>Reynolds number at that speed.</summary>
        public double reynolds;
        /// <summary>kg/m^3 of the fluid that it was baked in.</summary>
        public double fluidDensity;
        /// <summary>m, in the frame of the baked mesh (right-handed).</summary>
        public Vector3 centerOfMass;
        /// <summary>Principal entries of the inertia, kg m^2.</summary>
        public Vector3 inertia;
        /// <summary>Principal entries of the added mass, kg.</summary>
        public Vector3 addedMass;
        /// <summary>Version of the file format.</summary>
        public int formatVersion;
        /// <summary>Equal for assets that move equally.</summary>
        public string contentHash;

        internal static LangevinAssetNumbers Of(IntPtr asset)
        {
            AssetInfo info = AssetInfo.Create();
            LangevinSimulation.Check(Native.lr_asset_get_info(asset, &info), "lr_asset_get_info");
            int length = 0;
            while (length < 64 && info.Name[length] != 0) ++length;
            return new LangevinAssetNumbers
            {
                bakedName = System.Text.Encoding.UTF8.GetString(info.Name, length),
                mass = info.Mass,
                volume = info.Volume,
                density = info.Density,
                length = info.LengthD,
                thickness = info.LengthB,
                fallSpeed = info.U0,
                reynolds = info.Reynolds,
                fluidDensity = info.FluidDensity,
                centerOfMass = new Vector3((float)info.CenterOfMass.X, (float)info.CenterOfMass.Y, (float)info.CenterOfMass.Z),
                inertia = new Vector3((float)info.Inertia[0], (float)info.Inertia[4], (float)info.Inertia[8]),
                addedMass = new Vector3((float)info.AddedMass[0], (float)info.AddedMass[7], (float)info.AddedMass[14]),
                formatVersion = (int)info.FormatVersion,
                contentHash = info.ContentHash.ToString("x16"),
            };
        }
    }
}
