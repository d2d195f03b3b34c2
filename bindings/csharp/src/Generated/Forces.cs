// SPDX-License-Identifier: MIT
// Written by bindings/generator/csharp.py from include/langevin_rigid.h: change those.
using System;
using System.Runtime.InteropServices;

namespace LangevinRigid
{
    /// <summary>What a force's numbers are. A body answers with the inertia of the fluid that moves along with it, (M +
    /// added)^-1 F; accelerations and velocities come out as given, whatever the mass. The first two act over the whole
    /// next step, in each substep at its own orientation, and are then gone; forces of several calls before a step add
    /// up. The last two change the velocity at once.</summary>
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

    /// <summary>Of a force on one body.</summary>
    [Flags]
    public enum ForceFlags : uint
    {
        /// <summary>No bit.</summary>
        None = 0,
        /// <summary><c>force</c> acts at <c>point</c>, not at the centre of mass; forces and impulses only.</summary>
        AtPoint = 1,
    }

    /// <summary>The frame that a force is given in.</summary>
    public enum ForceFrame : int
    {
        /// <summary>The header's <c>LR_FRAME_WORLD</c>.</summary>
        World = 0,
        /// <summary>Turns with the body.</summary>
        Body = 1,
    }

    /// <summary>A force and a torque on one body, at the body's true size: a body of scale 2 has eight times the
    /// mass.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct BodyForce
    {
        /// <summary>Size of the struct in bytes, set by <c>Create</c>. The same in all elements of an array: it is the
        /// array's stride.</summary>
        public uint StructSize;
        /// <summary><see cref="ForceMode"/>; initially <see cref="ForceMode.Force"/></summary>
        public ForceMode Mode;
        /// <summary>Body.</summary>
        public BodyId Body;
        /// <summary><see cref="ForceFrame"/>, of force, torque and point; initially
        /// <see cref="ForceFrame.World"/></summary>
        public ForceFrame Frame;
        /// <summary><see cref="ForceFlags"/>; initially 0</summary>
        public ForceFlags Flags;
        /// <summary>initially 0</summary>
        public Float3 Force;
        /// <summary>about the centre of mass; initially 0</summary>
        public Float3 Torque;
        /// <summary>m; in the world frame a position, in the body frame from the centre of mass. Its arm is taken at
        /// the time of the call</summary>
        public Float3 Point;
        /// <summary>0.</summary>
        public uint Reserved;

        /// <summary>One with its initial values and its size.</summary>
        public static BodyForce Create()
        {
            var value = default(BodyForce);
            LangevinLibrary.EnsureLoaded();
            LangevinException.Check(Native.lr_body_force_init(&value, (uint)sizeof(BodyForce)), "lr_body_force_init");
            return value;
        }
    }

    /// <summary>The same for many bodies of one batch, in the order of its view.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct ForceArrays
    {
        /// <summary>Size of the struct in bytes, set by <c>Create</c>.</summary>
        public uint StructSize;
        /// <summary><see cref="ForceMode"/>; initially <see cref="ForceMode.Force"/></summary>
        public ForceMode Mode;
        /// <summary><see cref="ForceFrame"/>; initially <see cref="ForceFrame.World"/></summary>
        public ForceFrame Frame;
        /// <summary>index in the view of the first body; initially 0</summary>
        public uint First;
        /// <summary>bodies</summary>
        public uint Count;
        /// <summary>bytes from one body's value to the next's, a multiple of 4; initially 0: no gaps, 4</summary>
        public uint Stride;
        /// <summary>x, y, z: <c>Count</c> values each, not kept; all three or none. Element 0 of 3.</summary>
        public float* ForceX;
        /// <summary>x, y, z: <c>Count</c> values each, not kept; all three or none. Element 1 of 3.</summary>
        public float* ForceY;
        /// <summary>x, y, z: <c>Count</c> values each, not kept; all three or none. Element 2 of 3.</summary>
        public float* ForceZ;
        /// <summary>alike; all three or none. Element 0 of 3.</summary>
        public float* TorqueX;
        /// <summary>alike; all three or none. Element 1 of 3.</summary>
        public float* TorqueY;
        /// <summary>alike; all three or none. Element 2 of 3.</summary>
        public float* TorqueZ;

        /// <summary>One with its initial values and its size.</summary>
        public static ForceArrays Create()
        {
            var value = default(ForceArrays);
            LangevinLibrary.EnsureLoaded();
            LangevinException.Check(Native.lr_force_arrays_init(&value, (uint)sizeof(ForceArrays)), "lr_force_arrays_init");
            return value;
        }
    }

    /// <summary>What acts on every body of a batch. All initially 0, each component up to 1e9 in magnitude.</summary>
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
        /// <summary>the same four in the body frame</summary>
        public Float3 BodyForce;
        /// <summary>Body torque.</summary>
        public Float3 BodyTorque;
        /// <summary>Body acceleration.</summary>
        public Float3 BodyAcceleration;
        /// <summary>Body angular acceleration.</summary>
        public Float3 BodyAngularAcceleration;

        /// <summary>One with its initial values and its size.</summary>
        public static BatchForce Create()
        {
            var value = default(BatchForce);
            LangevinLibrary.EnsureLoaded();
            LangevinException.Check(Native.lr_batch_force_init(&value, (uint)sizeof(BatchForce)), "lr_batch_force_init");
            return value;
        }
    }
}
