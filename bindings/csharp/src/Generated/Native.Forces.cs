// SPDX-License-Identifier: MIT
// Written by bindings/generator/csharp.py from include/langevin_rigid.h: do not edit.
using System;
using System.Runtime.InteropServices;

namespace LangevinRigid
{
    public static unsafe partial class Native
    {
        /// <summary>Fills a struct with its initial values; <c>BodyForce.Create()</c> does it with the right size.</summary>
        /// <param name="force">force</param>
        /// <param name="structSize">sizeof the struct in the caller's header</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_body_force_init(BodyForce* force, uint structSize);

        /// <summary>Applies <paramref name="count"/> forces to bodies of any batches, all or none. A body may occur
        /// more than once. Each element may give its body at most 1e9 m/s^2 (torques: 1e9 m/s^2 over its length), an
        /// impulse at most 1e6 m/s and rad/s. Pending forces are part of snapshots and of the world's hash. The first
        /// force or acceleration on a body of a batch allocates 96 bytes for each body of the batch's
        /// capacity.</summary>
        /// <param name="world">the world</param>
        /// <param name="forces">forces</param>
        /// <param name="count">number of elements</param>
        /// <returns><see cref="Status.Ok"/> (also for count 0), <see cref="Status.NullArgument"/>,
        /// <see cref="Status.StaleBody"/>, <see cref="Status.StructSize"/>, <see cref="Status.NotFinite"/>,
        /// <see cref="Status.InvalidArgument"/>, <see cref="Status.OutOfMemory"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_body_add_force(IntPtr world, BodyForce* forces, uint count);

        /// <summary>Fills a struct with its initial values; <c>ForceArrays.Create()</c> does it with the right size.</summary>
        /// <param name="arrays">arrays</param>
        /// <param name="structSize">sizeof the struct in the caller's header</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_force_arrays_init(ForceArrays* arrays, uint structSize);

        /// <summary>Applies forces to many bodies of a batch; limits, snapshots and memory as for
        /// <see cref="Native.lr_body_add_force"/>.</summary>
        /// <param name="world">the world</param>
        /// <param name="batch">handle of a batch of the world</param>
        /// <param name="arrays">arrays</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/> (some of three pointers),
        /// <see cref="Status.StaleBatch"/>, <see cref="Status.StructSize"/>, <see cref="Status.NotFinite"/>,
        /// <see cref="Status.InvalidArgument"/> (also if first + count exceeds the batch's bodies),
        /// <see cref="Status.OutOfMemory"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_batch_add_forces(IntPtr world, BatchId batch, ForceArrays* arrays);

        /// <summary>Fills a struct with its initial values; <c>BatchForce.Create()</c> does it with the right size.</summary>
        /// <param name="force">force</param>
        /// <param name="structSize">sizeof the struct in the caller's header</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_batch_force_init(BatchForce* force, uint structSize);

        /// <summary>Sets the forces on a batch from the next step on. The struct is copied; null clears them. A change
        /// wakes the batch's sleeping bodies. Part of snapshots.</summary>
        /// <param name="world">the world</param>
        /// <param name="batch">handle of a batch of the world</param>
        /// <param name="force">force</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/> (world),
        /// <see cref="Status.StaleBatch"/>, <see cref="Status.StructSize"/>, <see cref="Status.NotFinite"/>,
        /// <see cref="Status.InvalidArgument"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_batch_set_force(IntPtr world, BatchId batch, BatchForce* force);

        /// <summary>Reads the forces on every body of a batch.</summary>
        /// <param name="world">the world</param>
        /// <param name="batch">handle of a batch of the world</param>
        /// <param name="force">initialised, or with struct_size set.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.StaleBatch"/>,
        /// <see cref="Status.StructSize"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_batch_get_force(IntPtr world, BatchId batch, BatchForce* force);
    }
}
