// SPDX-License-Identifier: MIT
using System;
using System.Runtime.InteropServices;

namespace LangevinRigid
{
    /// <summary>A reference to a native asset. Safe to finalize: any thread can release assets.</summary>
    internal sealed class AssetHandle : SafeHandle
    {
        public AssetHandle(IntPtr asset) : base(IntPtr.Zero, true)
        {
            SetHandle(asset);
        }

        public override bool IsInvalid { get { return handle == IntPtr.Zero; } }

        protected override bool ReleaseHandle()
        {
            Native.lr_asset_release(handle);
            return true;
        }
    }

    /// <summary>A native world and its callbacks. Safe to finalize: no thread uses a world without references.</summary>
    internal sealed class WorldHandle : SafeHandle
    {
        private readonly WorldCallbacks _callbacks;

        public WorldHandle(IntPtr world, WorldCallbacks callbacks) : base(IntPtr.Zero, true)
        {
            _callbacks = callbacks;
            SetHandle(world);
        }

        public override bool IsInvalid { get { return handle == IntPtr.Zero; } }

        protected override bool ReleaseHandle()
        {
            Native.lr_world_destroy(handle);
            _callbacks.Free();
            return true;
        }
    }
}
