// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using System.IO;
using System.Runtime.InteropServices;

namespace LangevinRigid
{
    /// <summary>The baked properties of a shape: mass, added mass, hull, turbulence. Immutable; any number of worlds and threads can share
    /// it. Batches hold their own references, so that an asset can be disposed of once they exist. Any thread.</summary>
    public sealed unsafe partial class Asset : IDisposable
    {
        private static readonly FaultFn _onFault = OnFault;
        private static readonly IntPtr _onFaultPointer = Marshal.GetFunctionPointerForDelegate(_onFault);

        private readonly AssetHandle _handle;

        private Asset(IntPtr asset)
        {
            _handle = new AssetHandle(asset);
        }

        /// <summary>Loads an asset file made by <c>lr_bake</c>.</summary>
        /// <exception cref="LangevinException">With all <see cref="LangevinException.Faults"/> of the file.</exception>
        public static Asset LoadFile(string path)
        {
            if (path == null) throw new ArgumentNullException("path");
            LangevinLibrary.EnsureLoaded();
            IntPtr asset;
            Status status;
            fixed (byte* text = Utf8.Bytes(path)) status = Native.lr_asset_load_file(text, &asset);
            if (status == Status.Ok) return new Asset(asset);
            throw new LangevinException(status, "lr_asset_load_file", path, IsAboutBytes(status) ? FaultsOfFile(path) : null);
        }

        /// <summary>Loads an asset from bytes in memory, which it copies.</summary>
        public static Asset Load(byte[] bytes)
        {
            if (bytes == null) throw new ArgumentNullException("bytes");
            fixed (byte* first = bytes) return Load(first, (ulong)bytes.Length);
        }

        /// <summary>Loads an asset from <paramref name="size"/> bytes of any alignment, which it copies.</summary>
        public static Asset Load(void* bytes, ulong size)
        {
            byte none;
            if (bytes == null && size == 0) bytes = &none; // an empty array has no address, but must be refused as an invalid asset
            LangevinLibrary.EnsureLoaded();
            IntPtr asset;
            Status status = Native.lr_asset_load_memory(bytes, size, &asset);
            if (status == Status.Ok) return new Asset(asset);
            throw new LangevinException(status, "lr_asset_load_memory", null, IsAboutBytes(status) ? Check(bytes, size, out status) : null);
        }

        /// <summary>Creates a solid ellipsoid from closed forms: the quickest way to a first falling body.</summary>
        public static Asset CreateEllipsoid(EllipsoidDesc desc)
        {
            LangevinLibrary.EnsureLoaded();
            IntPtr asset;
            LangevinException.Check(Native.lr_asset_create_ellipsoid(&desc, &asset), "lr_asset_create_ellipsoid");
            return new Asset(asset);
        }

        /// <summary>Creates a body with given coefficients, without mesh or file.</summary>
        public static Asset CreateRigid(RigidDesc desc)
        {
            LangevinLibrary.EnsureLoaded();
            IntPtr asset;
            LangevinException.Check(Native.lr_asset_create_rigid(&desc, &asset), "lr_asset_create_rigid");
            return new Asset(asset);
        }

        /// <summary>Creates a body with given coefficients, also of its loads, instead of <see cref="RigidDesc.Aerodynamics"/>.</summary>
        public static Asset CreateRigid(RigidDesc desc, Aerodynamics aerodynamics)
        {
            desc.Aerodynamics = &aerodynamics;
            return CreateRigid(desc);
        }

        /// <summary>All faults of an asset's bytes; empty if they are valid.</summary>
        public static IReadOnlyList<AssetFault> Check(byte[] bytes)
        {
            if (bytes == null) throw new ArgumentNullException("bytes");
            Status status;
            byte none;
            fixed (byte* first = bytes) return Check(first == null ? &none : first, (ulong)bytes.Length, out status);
        }

        /// <summary>All faults of an asset's bytes, and the status of <see cref="Load(void*, ulong)"/>.</summary>
        public static IReadOnlyList<AssetFault> Check(void* bytes, ulong size, out Status status)
        {
            LangevinLibrary.EnsureLoaded();
            var faults = new List<AssetFault>();
            GCHandle user = GCHandle.Alloc(faults);
            try
            {
                status = Native.lr_asset_check_memory(bytes, size, _onFaultPointer, GCHandle.ToIntPtr(user));
            }
            finally
            {
                user.Free();
            }
            return faults;
        }

        /// <summary>Mass, inertia, added mass and other properties.</summary>
        public AssetInfo Info
        {
            get
            {
                var info = new AssetInfo { StructSize = (uint)sizeof(AssetInfo) };
                bool held = false;
                Status status = Native.lr_asset_get_info(Hold(ref held), &info);
                Release(held);
                LangevinException.Check(status, "lr_asset_get_info");
                return info;
            }
        }

        /// <summary>The name from the bake.</summary>
        public string Name { get { return Info.NameText; } }

        /// <summary>The baked coefficients of its loads.</summary>
        public Aerodynamics Aerodynamics
        {
            get
            {
                var aerodynamics = new Aerodynamics { StructSize = (uint)sizeof(Aerodynamics) };
                bool held = false;
                Status status = Native.lr_asset_get_aerodynamics(Hold(ref held), &aerodynamics);
                Release(held);
                LangevinException.Check(status, "lr_asset_get_aerodynamics");
                return aerodynamics;
            }
        }

        /// <summary>The native asset, for <see cref="Native"/> and <see cref="BatchDesc.Asset"/>. Valid while this object is: keep it
        /// alive over the call.</summary>
        /// <exception cref="ObjectDisposedException">It was disposed of.</exception>
        public IntPtr Pointer
        {
            get
            {
                if (_handle.IsClosed) throw new ObjectDisposedException("Asset");
                return _handle.DangerousGetHandle();
            }
        }

        /// <summary>Another object for the same native asset, disposed of separately: for independent owners.</summary>
        public Asset Share()
        {
            bool held = false;
            IntPtr asset = Hold(ref held);
            Status status = Native.lr_asset_retain(asset);
            Release(held);
            LangevinException.Check(status, "lr_asset_retain");
            return new Asset(asset);
        }

        /// <summary>Whether it was disposed of.</summary>
        public bool IsDisposed { get { return _handle.IsClosed; } }

        /// <summary>Releases this reference. Batches keep theirs.</summary>
        public void Dispose()
        {
            _handle.Dispose();
        }

        /// <summary>The native asset, which no other thread can release until <see cref="Release"/>.</summary>
        internal IntPtr Hold(ref bool held)
        {
            if (_handle.IsClosed) throw new ObjectDisposedException("Asset");
            _handle.DangerousAddRef(ref held);
            return _handle.DangerousGetHandle();
        }

        internal void Release(bool held)
        {
            if (held) _handle.DangerousRelease();
        }

        private static bool IsAboutBytes(Status status)
        {
            return status == Status.AssetFormat || status == Status.AssetVersion || status == Status.AssetCorrupt || status == Status.AssetInvalid;
        }

        private static IReadOnlyList<AssetFault> FaultsOfFile(string path)
        {
            try
            {
                return Check(File.ReadAllBytes(path));
            }
            catch (Exception e) when (e is IOException || e is UnauthorizedAccessException)
            {
                return null; // the status matters more, and the file can be gone by now
            }
        }

        [MonoPInvokeCallback(typeof(FaultFn))]
        private static void OnFault(IntPtr user, uint number, byte* where, byte* what, byte* remedy)
        {
            try
            {
                var faults = (List<AssetFault>)GCHandle.FromIntPtr(user).Target;
                faults.Add(new AssetFault { Number = number, Where = Utf8.Read(where), What = Utf8.Read(what), Remedy = Utf8.Read(remedy) });
            }
            catch (Exception)
            {
                // Out of memory: the list lacks a fault. An exception must not cross native code.
            }
        }
    }
}
