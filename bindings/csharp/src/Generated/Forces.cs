// SPDX-License-Identifier: MIT
// Written by bindings/generator/csharp.py from include/langevin_rigid.h: do not edit.
using System;
using System.Runtime.InteropServices;

namespace LangevinRigid
{
    /// <summary>The unit and timing of a force. Forces and accelerations act over the whole next step, at the body's
    /// orientation in each substep, and are then gone; those of several calls add up. Impulses and velocities act at
    /// once. A force or impulse also moves the added mass of fluid, (M + added)^-1 F; an acceleration or velocity takes
    /// full effect whatever the mass.</summary>
    public enum ForceMode : int
    {
        /// <summary>N, N m.</summary>
        Force = 0,
        /// <summary>M/s^2, rad/s^2.</summary>
        Acceleration = 1,
        /// <summary>N s, N m s.</summary>
        Impulse = 2,
        /// <summary>M/s, rad/s: added to the body's.</summary>
        Velocity = 3,
    }

    /// <summary>The frame of a force.</summary>
    public enum ForceFrame : int
    {
        /// <summary>The header's <c>LR_FRAME_WORLD</c>.</summary>
        World = 0,
        /// <summary>Rotates with the body.</summary>
        Body = 1,
    }

    /// <summary>Options of a force on one body.</summary>
    [Flags]
    public enum ForceFlags : uint
    {
        /// <summary>No bit.</summary>
        None = 0,
        /// <summary><c>force</c> acts at <c>point</c>, not at the centre of mass; forces and impulses only.</summary>
        AtPoint = 1,
    }

    /// <summary>A force and a torque on one body. Scale matters: a body of scale 2 has eight times the mass.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct BodyForce
    {
        /// <summary>Size of the struct in bytes, set by <c>Create</c>. Equal in all elements of an array: also the
        /// array's stride.</summary>
        public uint StructSize;
        /// <summary><see cref="ForceMode"/>; default <see cref="ForceMode.Force"/></summary>
        public ForceMode Mode;
        /// <summary>Body.</summary>
        public BodyId Body;
        /// <summary><see cref="ForceFrame"/>, of force, torque and point; default
        /// <see cref="ForceFrame.World"/></summary>
        public ForceFrame Frame;
        /// <summary><see cref="ForceFlags"/>; default 0</summary>
        public ForceFlags Flags;
        /// <summary>default 0</summary>
        public Float3 Force;
        /// <summary>about the centre of mass; default 0</summary>
        public Float3 Torque;
        /// <summary>m; world frame: a position, body frame: from the centre of mass. The lever arm is fixed by the
        /// call</summary>
        public Float3 Point;
        /// <summary>0.</summary>
        public uint Reserved;

        /// <summary>A struct with its initial values and its size.</summary>
        public static BodyForce Create()
        {
            var value = default(BodyForce);
            LangevinLibrary.EnsureLoaded();
            LangevinException.Check(Native.lr_body_force_init(&value, (uint)sizeof(BodyForce)), "lr_body_force_init");
            return value;
        }
    }

    /// <summary>Forces on consecutive bodies of one batch, in the order of its view.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct ForceArrays
    {
        /// <summary>Size of the struct in bytes, set by <c>Create</c>.</summary>
        public uint StructSize;
        /// <summary><see cref="ForceMode"/>; default <see cref="ForceMode.Force"/></summary>
        public ForceMode Mode;
        /// <summary><see cref="ForceFrame"/>; default <see cref="ForceFrame.World"/></summary>
        public ForceFrame Frame;
        /// <summary>index in the view of the first body; default 0</summary>
        public uint First;
        /// <summary>bodies</summary>
        public uint Count;
        /// <summary>bytes from one body's value to the next, a multiple of 4; default 0: 4, no gaps</summary>
        public uint Stride;
        /// <summary>x, y, z: <c>Count</c> values each, not kept; all three or none. Element 0 of 3.</summary>
        public float* ForceX;
        /// <summary>x, y, z: <c>Count</c> values each, not kept; all three or none. Element 1 of 3.</summary>
        public float* ForceY;
        /// <summary>x, y, z: <c>Count</c> values each, not kept; all three or none. Element 2 of 3.</summary>
        public float* ForceZ;
        /// <summary>x, y, z: <c>Count</c> values each, not kept; all three or none. Element 0 of 3.</summary>
        public float* TorqueX;
        /// <summary>x, y, z: <c>Count</c> values each, not kept; all three or none. Element 1 of 3.</summary>
        public float* TorqueY;
        /// <summary>x, y, z: <c>Count</c> values each, not kept; all three or none. Element 2 of 3.</summary>
        public float* TorqueZ;

        /// <summary>A struct with its initial values and its size.</summary>
        public static ForceArrays Create()
        {
            var value = default(ForceArrays);
            LangevinLibrary.EnsureLoaded();
            LangevinException.Check(Native.lr_force_arrays_init(&value, (uint)sizeof(ForceArrays)), "lr_force_arrays_init");
            return value;
        }
    }

    /// <summary>Forces on every body of a batch, until changed. All default to 0; each component up to 1e9 in
    /// magnitude.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct BatchForce
    {
        /// <summary>Size of the struct in bytes, set by <c>Create</c>.</summary>
        public uint StructSize;
        /// <summary>0.</summary>
        public uint Reserved;
        /// <summary>N, world frame</summary>
        public Float3 Force;
        /// <summary>N m, world frame</summary>
        public Float3 Torque;
        /// <summary>m/s^2, world frame; of the body, whatever its mass</summary>
        public Float3 Acceleration;
        /// <summary>rad/s^2, world frame</summary>
        public Float3 AngularAcceleration;
        /// <summary>N, body frame</summary>
        public Float3 BodyForce;
        /// <summary>N m, body frame</summary>
        public Float3 BodyTorque;
        /// <summary>m/s^2, body frame</summary>
        public Float3 BodyAcceleration;
        /// <summary>rad/s^2, body frame</summary>
        public Float3 BodyAngularAcceleration;

        /// <summary>A struct with its initial values and its size.</summary>
        public static BatchForce Create()
        {
            var value = default(BatchForce);
            LangevinLibrary.EnsureLoaded();
            LangevinException.Check(Native.lr_batch_force_init(&value, (uint)sizeof(BatchForce)), "lr_batch_force_init");
            return value;
        }
    }
}
