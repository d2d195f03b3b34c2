// SPDX-License-Identifier: MIT
// Written by bindings/generator/csharp.py from include/langevin_rigid.h: do not edit.
using System;
using System.Runtime.InteropServices;

namespace LangevinRigid
{
    public static unsafe partial class Native
    {
        /// <summary>Sets the axes to the body's, <c>length</c>, <c>wake_length</c> and <c>wake_lag</c> to 1 and
        /// everything else to 0: no loads.</summary>
        /// <param name="aerodynamics">aerodynamics</param>
        /// <param name="structSize">sizeof the struct in the caller's header</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_aerodynamics_init(Aerodynamics* aerodynamics, uint structSize);

        /// <summary>
        /// <para>Reads an asset's baked coefficients.</para>
        /// <para>Any thread.</para>
        /// </summary>
        /// <param name="asset">the asset</param>
        /// <param name="aerodynamics">initialised by <see cref="Native.lr_aerodynamics_init"/>, or with struct_size
        /// set.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>,
        /// <see cref="Status.StructSize"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_asset_get_aerodynamics(IntPtr asset, Aerodynamics* aerodynamics);

        /// <summary>Replaces the asset's coefficients of AERODYNAMIC loads for a batch from the next step on. The
        /// struct is copied; null restores the asset's. With intensity 0, <see cref="LoadGains.Turbulence"/> 1 and
        /// <see cref="BatchDesc.Variation"/> 0 a fall is the same for any seed. Axes other than the body's, or a center
        /// other than 0, put an <see cref="AssetFlags.Diagonal"/> body on the slower path of contact.</summary>
        /// <param name="world">the world</param>
        /// <param name="batch">handle of a batch of the world</param>
        /// <param name="aerodynamics">aerodynamics</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/> (world),
        /// <see cref="Status.StaleBatch"/>, <see cref="Status.StructSize"/>, <see cref="Status.NotFinite"/>,
        /// <see cref="Status.InvalidArgument"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_batch_set_aerodynamics(IntPtr world, BatchId batch, Aerodynamics* aerodynamics);

        /// <summary>Reads a batch's current coefficients.</summary>
        /// <param name="world">the world</param>
        /// <param name="batch">handle of a batch of the world</param>
        /// <param name="aerodynamics">initialised, or with struct_size set.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.StaleBatch"/>,
        /// <see cref="Status.StructSize"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_batch_get_aerodynamics(IntPtr world, BatchId batch, Aerodynamics* aerodynamics);

        /// <summary>Fills a struct with its initial values; <c>RigidDesc.Create()</c> does it with the right size.</summary>
        /// <param name="desc">initialised by its <c>_init</c> function, or with struct_size set</param>
        /// <param name="structSize">sizeof the struct in the caller's header</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_rigid_desc_init(RigidDesc* desc, uint structSize);

        /// <summary>
        /// <para>Creates an asset from given numbers.</para>
        /// <para>Any thread.</para>
        /// </summary>
        /// <param name="desc">initialised by its <c>_init</c> function, or with struct_size set</param>
        /// <param name="out">as for <see cref="Native.lr_asset_load_file"/>.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.StructSize"/>,
        /// <see cref="Status.NotFinite"/>, <see cref="Status.InvalidArgument"/> (also for matrices that no body can
        /// have), <see cref="Status.OutOfMemory"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_asset_create_rigid(RigidDesc* desc, IntPtr* @out);

        /// <summary>Fills a struct with its initial values; <c>TurbulenceTable.Create()</c> does it with the right size.</summary>
        /// <param name="table">table</param>
        /// <param name="structSize">sizeof the struct in the caller's header</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_turbulence_table_init(TurbulenceTable* table, uint structSize);

        /// <summary>Replaces the turbulence table of a batch; null restores the asset's. With AERODYNAMIC loads the
        /// table replaces the intensity of <see cref="Aerodynamics"/>: it sets the velocity of the fluid around the
        /// body.</summary>
        /// <param name="world">the world</param>
        /// <param name="batch">handle of a batch of the world</param>
        /// <param name="table">table</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.StaleBatch"/>,
        /// <see cref="Status.StructSize"/>, <see cref="Status.NotFinite"/>, <see cref="Status.InvalidArgument"/>,
        /// <see cref="Status.OutOfMemory"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_batch_set_turbulence_table(IntPtr world, BatchId batch, TurbulenceTable* table);

        /// <summary>Reads a batch's turbulence table: the one that was set, bit for bit, or the asset's, rounded to
        /// float.</summary>
        /// <param name="world">the world</param>
        /// <param name="batch">handle of a batch of the world</param>
        /// <param name="table">initialised, or with struct_size set; its own chi and epsilon receive null.</param>
        /// <param name="chi">receive <c>table-&gt;count</c> values each, up to <paramref name="capacity"/>; either may
        /// be null, and capacity is then not read for it.</param>
        /// <param name="epsilon">receive <c>table-&gt;count</c> values each, up to <paramref name="capacity"/>; either
        /// may be null, and capacity is then not read for it.</param>
        /// <param name="capacity">number of elements that fit</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/> (world, table),
        /// <see cref="Status.StaleBatch"/>, <see cref="Status.StructSize"/>, <see cref="Status.BufferTooSmall"/> (table
        /// is set, chi and epsilon are not).</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_batch_get_turbulence_table(IntPtr world, BatchId batch, TurbulenceTable* table, float* chi, float* epsilon, uint capacity);

        /// <summary>Fills a struct with its initial values; <c>BodyLoads.Create()</c> does it with the right size.</summary>
        /// <param name="loads">loads</param>
        /// <param name="structSize">sizeof the struct in the caller's header</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_body_loads_init(BodyLoads* loads, uint structSize);

        /// <summary>Computes the loads on a body from its present state, wind and water; on a sleeping body as if its
        /// wake had ended. At the surface of water those of the fluid that its centre of mass is in; the fluid's own
        /// rotation is left out.</summary>
        /// <param name="world">the world</param>
        /// <param name="body">id of a body</param>
        /// <param name="loads">initialised, or with struct_size set. A microsecond; calls the wind and water
        /// callbacks.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.StaleBody"/>,
        /// <see cref="Status.StructSize"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_body_get_loads(IntPtr world, BodyId body, BodyLoads* loads);
    }
}
