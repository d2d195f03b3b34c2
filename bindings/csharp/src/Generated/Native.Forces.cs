// SPDX-License-Identifier: MIT
// Written by bindings/generator/csharp.py from include/langevin_rigid.h: change those.
using System;
using System.Runtime.InteropServices;

namespace LangevinRigid
{
    public static unsafe partial class Native
    {
        /// <summary>Fills a struct with its initial values; <c>BodyForce.Create()</c> does it with the right size.</summary>
        /// <param name="force">force</param>
        /// <param name="structSize">sizeof the struct as the caller sees it</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_body_force_init(BodyForce* force, uint structSize);

        /// <summary>Puts <paramref name="count"/> forces on bodies of any batches, all or none; a body may be there
        /// more than once. One of them may give its body up to 1e9 m/s^2, torques as much over its length; an impulse
        /// up to 1e6 m/s and rad/s. Pending forces are part of snapshots and of the world's hash. The first force or
        /// acceleration on a body of a batch takes 96 bytes for each of the batch's capacity.</summary>
        /// <param name="world">the world</param>
        /// <param name="forces">forces</param>
        /// <param name="count">elements of the arrays</param>
        /// <returns><see cref="Status.Ok"/> (also for count 0), <see cref="Status.NullArgument"/>,
        /// <see cref="Status.StaleBody"/>, <see cref="Status.StructSize"/>, <see cref="Status.NotFinite"/>,
        /// <see cref="Status.InvalidArgument"/>, <see cref="Status.OutOfMemory"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_body_add_force(IntPtr world, BodyForce* forces, uint count);

        /// <summary>Fills a struct with its initial values; <c>ForceArrays.Create()</c> does it with the right size.</summary>
        /// <param name="arrays">arrays</param>
        /// <param name="structSize">sizeof the struct as the caller sees it</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_force_arrays_init(ForceArrays* arrays, uint structSize);

        /// <summary><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/> (some of three pointers),
        /// <see cref="Status.StaleBatch"/>, <see cref="Status.StructSize"/>, <see cref="Status.NotFinite"/>,
        /// <see cref="Status.InvalidArgument"/> (also first + count over the batch's bodies),
        /// <see cref="Status.OutOfMemory"/>.</summary>
        /// <param name="world">the world</param>
        /// <param name="batch">handle of a batch of the world</param>
        /// <param name="arrays">arrays</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/> (some of three pointers),
        /// <see cref="Status.StaleBatch"/>, <see cref="Status.StructSize"/>, <see cref="Status.NotFinite"/>,
        /// <see cref="Status.InvalidArgument"/> (also first + count over the batch's bodies),
        /// <see cref="Status.OutOfMemory"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_batch_add_forces(IntPtr world, BatchId batch, ForceArrays* arrays);

        /// <summary>Fills a struct with its initial values; <c>BatchForce.Create()</c> does it with the right size.</summary>
        /// <param name="force">force</param>
        /// <param name="structSize">sizeof the struct as the caller sees it</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_batch_force_init(BatchForce* force, uint structSize);

        /// <summary>From the next step on, until changed; copied. Null ends it. A change wakes the batch's bodies. Part
        /// of snapshots.</summary>
        /// <param name="world">the world</param>
        /// <param name="batch">handle of a batch of the world</param>
        /// <param name="force">force</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/> (world),
        /// <see cref="Status.StaleBatch"/>, <see cref="Status.StructSize"/>, <see cref="Status.NotFinite"/>,
        /// <see cref="Status.InvalidArgument"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_batch_set_force(IntPtr world, BatchId batch, BatchForce* force);
    }
}
