// SPDX-License-Identifier: MIT
// Written by bindings/generator/csharp.py from include/langevin_rigid.h: do not edit.
using System;
using System.Runtime.InteropServices;

namespace LangevinRigid
{
    /// <summary>A body's sleep state.</summary>
    public enum SleepState : int
    {
        /// <summary>The header's <c>LR_SLEEP_AWAKE</c>.</summary>
        Awake = 0,
        /// <summary>The header's <c>LR_SLEEP_ASLEEP</c>.</summary>
        Asleep = 1,
        /// <summary>Read only: diverged, and held where it was by
        /// <see cref="Native.lr_batch_set_divergence_policy"/>.</summary>
        Held = 2,
    }

    /// <summary>The header's <c>struct lr_body_desc</c>.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct BodyDesc
    {
        /// <summary>Size of the struct in bytes, set by <c>Create</c>. Equal in all elements of an array: also the
        /// array's stride.</summary>
        public uint StructSize;
        /// <summary>default 0: the world assigns each body the next one</summary>
        public uint NoiseSeed;
        /// <summary>m, of the centre of mass; default 0</summary>
        public Float3 Position;
        /// <summary>quaternion x y z w, normalised by the call; default 0 0 0 1</summary>
        public Float4 Orientation;
        /// <summary>m/s, of the centre of mass; default 0</summary>
        public Float3 LinearVelocity;
        /// <summary>rad/s, world frame; default 0</summary>
        public Float3 AngularVelocity;
        /// <summary>uniform, 0.001 to 1000; mass scales with its cube; default 1</summary>
        public float Scale;
        /// <summary>s, 0 to 1e9, where it stops growing; default 0</summary>
        public float Age;
        /// <summary>0.</summary>
        public uint Reserved;
        /// <summary>the caller's own number, also in views, events and ray hits; default 0. A respawn keeps it. It does
        /// not affect motion: part of snapshots, not of the world's hash</summary>
        public ulong User;

        /// <summary>A struct with its initial values and its size.</summary>
        public static BodyDesc Create()
        {
            var value = default(BodyDesc);
            LangevinLibrary.EnsureLoaded();
            LangevinException.Check(Native.lr_body_desc_init(&value, (uint)sizeof(BodyDesc)), "lr_body_desc_init");
            return value;
        }
    }

    /// <summary>The header's <c>struct lr_body_state</c>.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct BodyState
    {
        /// <summary>Size of the struct in bytes, set by <c>Create</c>.</summary>
        public uint StructSize;
        /// <summary>read only: ignored by <see cref="Native.lr_body_set_state"/></summary>
        public uint NoiseSeed;
        /// <summary>m, of the centre of mass, world frame</summary>
        public Float3 Position;
        /// <summary>unit quaternion x y z w, body to world</summary>
        public Float4 Orientation;
        /// <summary>m/s, of the centre of mass, world frame</summary>
        public Float3 LinearVelocity;
        /// <summary>rad/s, world frame</summary>
        public Float3 AngularVelocity;
        /// <summary>0.001 to 1000</summary>
        public float Scale;
        /// <summary>s, 0 to 1e9</summary>
        public float Age;
        /// <summary><see cref="SleepState"/>; read only</summary>
        public SleepState SleepState;
        /// <summary>as in <see cref="BodyDesc"/></summary>
        public ulong User;

        /// <summary>A struct with its initial values and its size.</summary>
        public static BodyState Create()
        {
            var value = default(BodyState);
            LangevinLibrary.EnsureLoaded();
            LangevinException.Check(Native.lr_body_state_init(&value, (uint)sizeof(BodyState)), "lr_body_state_init");
            return value;
        }
    }
}
