// SPDX-License-Identifier: MIT
// Written by bindings/generator/csharp.py from include/langevin_rigid.h: do not edit.
using System;
using System.Runtime.InteropServices;

namespace LangevinRigid
{
    public static unsafe partial class Native
    {
        /// <summary>Fills a struct with its initial values; <c>BatchDesc.Create()</c> does it with the right size.</summary>
        /// <param name="desc">initialised by its <c>_init</c> function, or with struct_size set</param>
        /// <param name="structSize">sizeof the struct in the caller's header</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_batch_desc_init(BatchDesc* desc, uint structSize);

        /// <summary>Creates a batch.</summary>
        /// <param name="world">the world</param>
        /// <param name="desc">initialised by its <c>_init</c> function, or with struct_size set</param>
        /// <param name="out">receives the batch, id 0 after an error.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/> (also desc-&gt;asset),
        /// <see cref="Status.StructSize"/>, <see cref="Status.NotFinite"/>, <see cref="Status.InvalidArgument"/>,
        /// <see cref="Status.Capacity"/>, <see cref="Status.OutOfMemory"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_batch_create(IntPtr world, BatchDesc* desc, BatchId* @out);

        /// <summary>Destroys a batch with all its bodies. Wakes the bodies of batches that had body contact with it
        /// (<see cref="Native.lr_batch_set_body_contact"/>).</summary>
        /// <param name="world">the world</param>
        /// <param name="batch">handle of a batch of the world</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>,
        /// <see cref="Status.StaleBatch"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_batch_destroy(IntPtr world, BatchId batch);

        /// <summary>Returns 1 if the batch exists in this world, else 0. Never an error: see
        /// <see cref="Native.lr_body_is_valid"/>.</summary>
        /// <param name="world">the world</param>
        /// <param name="batch">handle of a batch of the world</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int lr_batch_is_valid(IntPtr world, BatchId batch);

        /// <summary>Fills a struct with its initial values; <c>LoadGains.Create()</c> does it with the right size.</summary>
        /// <param name="gains">gains</param>
        /// <param name="structSize">sizeof the struct in the caller's header</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_load_gains_init(LoadGains* gains, uint structSize);

        /// <summary>Sets the gains of a batch from the next step on; null sets all to 1. The gains of LANGEVIN loads
        /// are in <see cref="BatchDesc"/>.</summary>
        /// <param name="world">the world</param>
        /// <param name="batch">handle of a batch of the world</param>
        /// <param name="gains">gains</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/> (world),
        /// <see cref="Status.StaleBatch"/>, <see cref="Status.StructSize"/>, <see cref="Status.NotFinite"/>,
        /// <see cref="Status.InvalidArgument"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_batch_set_load_gains(IntPtr world, BatchId batch, LoadGains* gains);

        /// <summary>Reads the gains of a batch.</summary>
        /// <param name="world">the world</param>
        /// <param name="batch">handle of a batch of the world</param>
        /// <param name="gains">initialised, or with struct_size set.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.StaleBatch"/>,
        /// <see cref="Status.StructSize"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_batch_get_load_gains(IntPtr world, BatchId batch, LoadGains* gains);

        /// <summary>
        /// <para>Sets how often a batch is stepped: level of detail for bodies that are far away, small or out of
        /// sight. A batch of divisor n takes one substep where other batches take n: fewer in each step or, if n
        /// exceeds the world's substeps, one every few steps that covers them all. Substeps are never so long that fall
        /// statistics change: at most 1/60 s, and length_d / 2 m/s for bodies under 3.3 cm. Larger divisors have no
        /// further effect. docs/reference/stepping.md. Takes effect at the next step and may change at any time: a
        /// waiting batch catches up when it is next stepped. Part of snapshots. While a batch waits</para>
        /// <para>- views and <see cref="Native.lr_body_get_state"/> show bodies as of their last step,
        /// <see cref="BatchPace.Behind"/> ago;</para>
        /// <para>- bodies that are created or set count as of that time too;</para>
        /// <para>- <see cref="Native.lr_batch_write_transforms"/> extrapolates to the present by the bodies'
        /// velocities;</para>
        /// <para>- a force on one of its bodies ends the wait, and acts with the impulse that it would have had in one
        /// step;</para>
        /// <para>- a collider that moves within the bounds of its bodies ends the wait, since it would pass through
        /// them;</para>
        /// <para>- its rules, emitter and events wait too.</para>
        /// </summary>
        /// <param name="world">the world</param>
        /// <param name="batch">handle of a batch of the world</param>
        /// <param name="divisor">1 to 1024; default 1.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.StaleBatch"/>,
        /// <see cref="Status.InvalidArgument"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_batch_set_rate(IntPtr world, BatchId batch, uint divisor);

        /// <summary>Fills a struct with its initial values; <c>BatchPace.Create()</c> does it with the right size.</summary>
        /// <param name="pace">pace</param>
        /// <param name="structSize">sizeof the struct in the caller's header</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_batch_pace_init(BatchPace* pace, uint structSize);

        /// <summary>Reads a batch's rate and backlog.</summary>
        /// <param name="world">the world</param>
        /// <param name="batch">handle of a batch of the world</param>
        /// <param name="pace">initialised, or with struct_size set.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.StaleBatch"/>,
        /// <see cref="Status.StructSize"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_batch_get_pace(IntPtr world, BatchId batch, BatchPace* pace);

        /// <summary>Fills a struct with its initial values; <c>BatchView.Create()</c> does it with the right size.</summary>
        /// <param name="view">view</param>
        /// <param name="structSize">sizeof the struct in the caller's header</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_batch_view_init(BatchView* view, uint structSize);

        /// <summary>Gets the view of a batch.</summary>
        /// <param name="world">the world</param>
        /// <param name="batch">handle of a batch of the world</param>
        /// <param name="view">initialised, or with struct_size set.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.StaleBatch"/>,
        /// <see cref="Status.StructSize"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_batch_get_view(IntPtr world, BatchId batch, BatchView* view);

        /// <summary>Computes a box around all bodies of a batch, awake or asleep, for culling. Each body counts as the
        /// sphere that contains it in any orientation; the box of a waiting batch
        /// (<see cref="Native.lr_batch_set_rate"/>) also contains the places that
        /// <see cref="Native.lr_batch_write_transforms"/> extrapolates to. The cost is proportional to the number of
        /// bodies.</summary>
        /// <param name="world">the world</param>
        /// <param name="batch">handle of a batch of the world</param>
        /// <param name="low">receive x, y, z of the corners, m, world frame. A batch without bodies gives the largest
        /// float in <paramref name="low"/> and its negative in <paramref name="high"/>: the union with any other box is
        /// that box.</param>
        /// <param name="high">receive x, y, z of the corners, m, world frame. A batch without bodies gives the largest
        /// float in <paramref name="low"/> and its negative in <paramref name="high"/>: the union with any other box is
        /// that box.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>,
        /// <see cref="Status.StaleBatch"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_batch_get_bounds(IntPtr world, BatchId batch, float* low, float* high);

        /// <summary>Writes the transforms of a batch's first <paramref name="count"/> bodies, or of all if there are
        /// fewer, in the order of its view. Draw a mesh whose origin is the centre of mass
        /// (<see cref="AssetInfo.CenterOfMass"/>). Bodies of a waiting batch (<see cref="Native.lr_batch_set_rate"/>)
        /// are extrapolated to the world's time. An instance buffer that still holds the last write needs no rewrite of
        /// sleeping bodies. While <see cref="BatchView.Revision"/> is unchanged, <paramref name="count"/> may be the
        /// greater of the old and the new awake_count; otherwise write all bodies. Remember both numbers per buffer.
        /// docs/reference/bodies.md.</summary>
        /// <param name="world">the world</param>
        /// <param name="batch">handle of a batch of the world</param>
        /// <param name="format">one of the constants above</param>
        /// <param name="dst">4-byte aligned, room for <paramref name="count"/> elements <paramref name="stride"/> bytes
        /// apart.</param>
        /// <param name="stride">0 for elements without gaps, else a multiple of 4 no smaller than an element.</param>
        /// <param name="count">number of elements</param>
        /// <param name="written">elements written; may be null.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/> (dst may be null only when nothing is to
        /// be written), <see cref="Status.StaleBatch"/>, <see cref="Status.InvalidArgument"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_batch_write_transforms(IntPtr world, BatchId batch, TransformFormat format, void* dst, ulong stride, uint count, uint* written);

        /// <summary>Writes the velocities of a batch's first <paramref name="count"/> bodies, or of all if there are
        /// fewer, in the order of its view. An element is 6 floats, world frame: the linear velocity of the centre of
        /// mass, m/s, and the angular velocity, rad/s; bit for bit those of <see cref="Native.lr_body_get_state"/>.
        /// Sleeping bodies have 0, bodies of a waiting batch (<see cref="Native.lr_batch_set_rate"/>) the velocities of
        /// their last step.</summary>
        /// <param name="world">the world</param>
        /// <param name="batch">handle of a batch of the world</param>
        /// <param name="dst">4-byte aligned, room for <paramref name="count"/> elements <paramref name="stride"/> bytes
        /// apart.</param>
        /// <param name="stride">0 for elements without gaps, else a multiple of 4 no smaller than an element.</param>
        /// <param name="count">number of elements</param>
        /// <param name="written">elements written; may be null.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/> (dst may be null only when nothing is to
        /// be written), <see cref="Status.StaleBatch"/>, <see cref="Status.InvalidArgument"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_batch_write_velocities(IntPtr world, BatchId batch, void* dst, ulong stride, uint count, uint* written);
    }
}
