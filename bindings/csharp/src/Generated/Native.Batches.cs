// SPDX-License-Identifier: MIT
// Written by bindings/generator/csharp.py from include/langevin_rigid.h: change those.
using System;
using System.Runtime.InteropServices;

namespace LangevinRigid
{
    public static unsafe partial class Native
    {
        /// <summary>Fills a struct with its initial values; <c>BatchDesc.Create()</c> does it with the right size.</summary>
        /// <param name="desc">initialised by its <c>_init</c> function, or with struct_size set</param>
        /// <param name="structSize">sizeof the struct as the caller sees it</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_batch_desc_init(BatchDesc* desc, uint structSize);

        /// <summary><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/> (also desc-&gt;asset),
        /// <see cref="Status.StructSize"/>, <see cref="Status.NotFinite"/>, <see cref="Status.InvalidArgument"/>,
        /// <see cref="Status.Capacity"/>, <see cref="Status.OutOfMemory"/>.</summary>
        /// <param name="world">the world</param>
        /// <param name="desc">initialised by its <c>_init</c> function, or with struct_size set</param>
        /// <param name="out">receives the batch, 0 after an error.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/> (also desc-&gt;asset),
        /// <see cref="Status.StructSize"/>, <see cref="Status.NotFinite"/>, <see cref="Status.InvalidArgument"/>,
        /// <see cref="Status.Capacity"/>, <see cref="Status.OutOfMemory"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_batch_create(IntPtr world, BatchDesc* desc, BatchId* @out);

        /// <summary>Ends a batch with all its bodies. Those of batches that it met
        /// (<see cref="Native.lr_batch_set_pair_contact"/>) wake.</summary>
        /// <param name="world">the world</param>
        /// <param name="batch">handle of a batch of the world</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>,
        /// <see cref="Status.StaleBatch"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_batch_destroy(IntPtr world, BatchId batch);

        /// <summary>Fills a struct with its initial values; <c>TurbulenceTable.Create()</c> does it with the right size.</summary>
        /// <param name="table">table</param>
        /// <param name="structSize">sizeof the struct as the caller sees it</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_turbulence_table_init(TurbulenceTable* table, uint structSize);

        /// <summary>Replaces a batch's table; null puts the asset's own back. With AERODYNAMIC loads the table sets the
        /// velocity of the fluid around the body, instead of the intensity in <see cref="Aerodynamics"/>.</summary>
        /// <param name="world">the world</param>
        /// <param name="batch">handle of a batch of the world</param>
        /// <param name="table">table</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.StaleBatch"/>,
        /// <see cref="Status.StructSize"/>, <see cref="Status.NotFinite"/>, <see cref="Status.InvalidArgument"/>,
        /// <see cref="Status.OutOfMemory"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_batch_set_turbulence_table(IntPtr world, BatchId batch, TurbulenceTable* table);

        /// <summary>Coefficients of the AERODYNAMIC loads for a batch, in place of its asset's, from the next step on;
        /// copied. Null puts the asset's own back. With intensity 0 and <see cref="LoadGains.Turbulence"/> 1 a fall is
        /// the same for any seed. With other axes than the body's, or another center than 0, a body of
        /// <see cref="AssetFlags.Diagonal"/> takes the slower path of all others.</summary>
        /// <param name="world">the world</param>
        /// <param name="batch">handle of a batch of the world</param>
        /// <param name="aerodynamics">aerodynamics</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/> (world),
        /// <see cref="Status.StaleBatch"/>, <see cref="Status.StructSize"/>, <see cref="Status.NotFinite"/>,
        /// <see cref="Status.InvalidArgument"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_batch_set_aerodynamics(IntPtr world, BatchId batch, Aerodynamics* aerodynamics);

        /// <summary>What the batch's coefficients are at present.</summary>
        /// <param name="world">the world</param>
        /// <param name="batch">handle of a batch of the world</param>
        /// <param name="aerodynamics">initialised, or with struct_size set.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.StaleBatch"/>,
        /// <see cref="Status.StructSize"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_batch_get_aerodynamics(IntPtr world, BatchId batch, Aerodynamics* aerodynamics);

        /// <summary>Fills a struct with its initial values; <c>LoadGains.Create()</c> does it with the right size.</summary>
        /// <param name="gains">gains</param>
        /// <param name="structSize">sizeof the struct as the caller sees it</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_load_gains_init(LoadGains* gains, uint structSize);

        /// <summary>From the next step on; null puts all at 1. LANGEVIN loads have their gains in
        /// <see cref="BatchDesc"/>.</summary>
        /// <param name="world">the world</param>
        /// <param name="batch">handle of a batch of the world</param>
        /// <param name="gains">gains</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/> (world),
        /// <see cref="Status.StaleBatch"/>, <see cref="Status.StructSize"/>, <see cref="Status.NotFinite"/>,
        /// <see cref="Status.InvalidArgument"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_batch_set_load_gains(IntPtr world, BatchId batch, LoadGains* gains);

        /// <summary>How often a batch is stepped: level of detail for bodies that are far away, small, or out of sight.
        /// docs/reference/stepping.md.</summary>
        /// <param name="world">the world</param>
        /// <param name="batch">handle of a batch of the world</param>
        /// <param name="divisor">
        /// <para>1 to 1024, at first 1. A batch of divisor n takes one substep where others take n: fewer in each step,
        /// or, where n is more than the world's substeps, one in every so many steps, which makes up for all of them.
        /// No substep gets longer by that than falls keep their statistics: 1/60 s, for bodies under 2.5 cm length_d /
        /// 1.5 m/s. A divisor beyond has no more effect. From the next step on, at any time: a batch that waits makes
        /// up for all of it when next stepped. While it waits</para>
        /// <para>- views and <see cref="Native.lr_body_get_state"/> have the bodies as they were last stepped,
        /// <see cref="BatchPace.Behind"/> ago, and bodies that are made</para>
        /// <code>
        ///    or set are taken to be from then; transforms are moved on by that time with the bodies' velocities;
        ///  - a force on one of its bodies ends the waiting, and acts with the impulse that it would have had in one step;
        ///  - its rules, emitter and events wait too.
        /// Part of snapshots.
        /// </code>
        /// </param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.StaleBatch"/>,
        /// <see cref="Status.InvalidArgument"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_batch_set_rate(IntPtr world, BatchId batch, uint divisor);

        /// <summary>Fills a struct with its initial values; <c>BatchPace.Create()</c> does it with the right size.</summary>
        /// <param name="pace">pace</param>
        /// <param name="structSize">sizeof the struct as the caller sees it</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_batch_pace_init(BatchPace* pace, uint structSize);

        /// <summary><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.StaleBatch"/>,
        /// <see cref="Status.StructSize"/>.</summary>
        /// <param name="world">the world</param>
        /// <param name="batch">handle of a batch of the world</param>
        /// <param name="pace">initialised, or with struct_size set.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.StaleBatch"/>,
        /// <see cref="Status.StructSize"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_batch_get_pace(IntPtr world, BatchId batch, BatchPace* pace);

        /// <summary>Fills a struct with its initial values; <c>BatchView.Create()</c> does it with the right size.</summary>
        /// <param name="view">view</param>
        /// <param name="structSize">sizeof the struct as the caller sees it</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_batch_view_init(BatchView* view, uint structSize);

        /// <summary><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.StaleBatch"/>,
        /// <see cref="Status.StructSize"/>.</summary>
        /// <param name="world">the world</param>
        /// <param name="batch">handle of a batch of the world</param>
        /// <param name="view">initialised, or with struct_size set.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.StaleBatch"/>,
        /// <see cref="Status.StructSize"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_batch_get_view(IntPtr world, BatchId batch, BatchView* view);

        /// <summary>Writes the transforms of the first <paramref name="count"/> bodies of a batch, or of all where
        /// there are fewer, in the order of its view; of one that waits (<see cref="Native.lr_batch_set_rate"/>), moved
        /// on to the world's time. The mesh to be drawn must have its origin at the centre of mass
        /// (<see cref="AssetInfo.CenterOfMass"/>). An instance buffer keeps what was written before: where
        /// <see cref="BatchView.Revision"/> is that of the last time, bodies at rest then still lie there, and it is
        /// enough to write as many as moved then or move now, the greater awake_count of the two. Else all:
        /// docs/reference/bodies.md. Keep both numbers for each buffer that is written in turn.</summary>
        /// <param name="world">the world</param>
        /// <param name="batch">handle of a batch of the world</param>
        /// <param name="format">one of the constants above</param>
        /// <param name="dst">4-byte aligned, room for <paramref name="count"/> elements <paramref name="stride"/> bytes
        /// apart.</param>
        /// <param name="stride">0 for elements without gaps, else a multiple of 4, at least an element.</param>
        /// <param name="count">elements of the arrays</param>
        /// <param name="written">elements written; may be null.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/> (dst may be null only when nothing is to
        /// be written), <see cref="Status.StaleBatch"/>, <see cref="Status.InvalidArgument"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_batch_write_transforms(IntPtr world, BatchId batch, TransformFormat format, void* dst, ulong stride, uint count, uint* written);
    }
}
