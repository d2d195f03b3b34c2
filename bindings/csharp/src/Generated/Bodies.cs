// SPDX-License-Identifier: MIT
// Written by bindings/generator/csharp.py from include/langevin_rigid.h: change those.
using System;
using System.Runtime.InteropServices;

namespace LangevinRigid
{
    /// <summary>Whether a body is at rest.</summary>
    public enum RestState : int
    {
        /// <summary>The header's <c>LR_REST_AWAKE</c>.</summary>
        Awake = 0,
        /// <summary>The header's <c>LR_REST_RESTING</c>.</summary>
        Resting = 1,
        /// <summary>Read only: it has left physics, and <see cref="Native.lr_batch_set_fault_policy"/> holds it where
        /// it was.</summary>
        Held = 2,
    }

    /// <summary>The header's <c>struct lr_body_desc</c>.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct BodyDesc
    {
        /// <summary>Size of the struct in bytes, set by <c>Create</c>. The same in all elements of an array: it is the
        /// array's stride.</summary>
        public uint StructSize;
        /// <summary>tells its noise apart; initially 0: the world gives each body its own, in order of birth</summary>
        public uint Key;
        /// <summary>m, of the centre of mass; initially 0</summary>
        public Float3 Position;
        /// <summary>quaternion x y z w, normalised when taken; initially 0 0 0 1</summary>
        public Float4 Orientation;
        /// <summary>m/s, of the centre of mass; initially 0</summary>
        public Float3 LinearVelocity;
        /// <summary>rad/s, world frame; initially 0</summary>
        public Float3 AngularVelocity;
        /// <summary>uniform, 0.001 to 1000; mass goes with its cube; initially 1</summary>
        public float Scale;
        /// <summary>s, 0 to 1e9; initially 0. Bodies grow no older than that</summary>
        public float Age;
        /// <summary>0.</summary>
        public uint Reserved;

        /// <summary>One with its initial values and its size.</summary>
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
        public uint Key;
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
        /// <summary>0.</summary>
        public uint Reserved;
        /// <summary><see cref="RestState"/>; read only</summary>
        public RestState Resting;

        /// <summary>One with its initial values and its size.</summary>
        public static BodyState Create()
        {
            var value = default(BodyState);
            LangevinLibrary.EnsureLoaded();
            LangevinException.Check(Native.lr_body_state_init(&value, (uint)sizeof(BodyState)), "lr_body_state_init");
            return value;
        }
    }
}
