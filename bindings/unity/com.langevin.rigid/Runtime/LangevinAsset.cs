// SPDX-License-Identifier: MIT
using System;
using LangevinRigid;
using UnityEngine;

namespace LangevinUnity
{
    /// <summary>An imported .lrb file, made by lr_bake from a mesh. Any number of batches and worlds can share it.</summary>
    public sealed unsafe class LangevinAsset : ScriptableObject
    {
        [SerializeField, HideInInspector] private byte[] bytes = new byte[0];
        [SerializeField] private MeshMirror meshMirror = MeshMirror.Z;
        [SerializeField] private LangevinAssetNumbers numbers;

        /// <summary>The contents of the .lrb file.</summary>
        public byte[] Bytes { get { return bytes; } }

        /// <summary>The mirror from the baked to the drawn mesh.</summary>
        public MeshMirror Mirror { get { return meshMirror; } }

        /// <summary>Mass, sizes and other properties, read at import.</summary>
        public LangevinAssetNumbers Numbers { get { return numbers; } }

        /// <summary>Creates an asset at run time from the bytes of a .lrb file, from a download or your own bundle.</summary>
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

        /// <summary>The library's asset; the caller releases its reference. Throws an exception that lists faults of the bytes.</summary>
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

    /// <summary>Properties of an asset, for inspectors.</summary>
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
        /// <summary>m/s, about the speed of its fall.</summary>
        public double fallSpeed;
        /// <summary>Reynolds number at that speed.</summary>
        public double reynolds;
        /// <summary>kg/m^3, of the fluid of the bake.</summary>
        public double fluidDensity;
        /// <summary>m, in the frame of the baked mesh (right-handed).</summary>
        public Vector3 centerOfMass;
        /// <summary>Principal entries of the inertia, kg m^2.</summary>
        public Vector3 inertia;
        /// <summary>Principal entries of the added mass, kg.</summary>
        public Vector3 addedMass;
        /// <summary>Version of the file format.</summary>
        public int formatVersion;
        /// <summary>Equal for assets that move alike.</summary>
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
