// SPDX-License-Identifier: MIT
// Written by bindings/generator/csharp.py from include/langevin_rigid.h: do not edit.
using System;
using System.Runtime.InteropServices;

namespace LangevinRigid
{
    public static unsafe partial class Native
    {
        /// <summary>Fills a struct with its initial values; <c>WorldDesc.Create()</c> does it with the right size.</summary>
        /// <param name="desc">initialised by its <c>_init</c> function, or with struct_size set</param>
        /// <param name="structSize">sizeof the struct in the caller's header</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_desc_init(WorldDesc* desc, uint structSize);

        /// <summary>
        /// <para>Creates a world.</para>
        /// <para>Any thread.</para>
        /// </summary>
        /// <param name="desc">initialised by its <c>_init</c> function, or with struct_size set</param>
        /// <param name="out">receives the world, null after an error.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.StructSize"/>,
        /// <see cref="Status.NotFinite"/>, <see cref="Status.InvalidArgument"/>, <see cref="Status.Unsupported"/>
        /// (simd_target), <see cref="Status.OutOfMemory"/>, <see cref="Status.Threads"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_create(WorldDesc* desc, IntPtr* @out);

        /// <summary>Destroys a world with its batches and bodies, stops its worker threads and ends its recording. Null
        /// is allowed.</summary>
        /// <param name="world">the world</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void lr_world_destroy(IntPtr world);

        /// <summary>Fills a struct with its initial values; <c>WorldInfo.Create()</c> does it with the right size.</summary>
        /// <param name="info">info</param>
        /// <param name="structSize">sizeof the struct in the caller's header</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_info_init(WorldInfo* info, uint structSize);

        /// <summary>Reads counts, time and settings of the world.</summary>
        /// <param name="world">the world</param>
        /// <param name="info">initialised, or with struct_size set.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>,
        /// <see cref="Status.StructSize"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_get_info(IntPtr world, WorldInfo* info);

        /// <summary>Sets gravity from the next step on. A change wakes all bodies
        /// (<see cref="Native.lr_body_set_sleep"/>).</summary>
        /// <param name="world">the world</param>
        /// <param name="gravity">m/s^2, 3 values, each up to 1e4 in magnitude.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.NotFinite"/>,
        /// <see cref="Status.InvalidArgument"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_set_gravity(IntPtr world, float* gravity);

        /// <summary>Sets the instruction set from the next step on. Results do not change.</summary>
        /// <param name="world">the world</param>
        /// <param name="target"><see cref="SimdTarget"/>.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.InvalidArgument"/>,
        /// <see cref="Status.Unsupported"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_set_simd_target(IntPtr world, SimdTarget target);

        /// <summary>Sets the uniform wind, the same velocity everywhere; 0 before the first call. A change is spread
        /// evenly over the next step, in which bodies feel the fluid accelerate (Froude-Krylov force and added mass): a
        /// body as dense as the fluid is carried along, a heavy one keeps most of its velocity. A wind set before the
        /// world's first step is there from the beginning and accelerates nothing. Setting the same wind again changes
        /// nothing.</summary>
        /// <param name="world">the world</param>
        /// <param name="x">m/s, each up to 1000 in magnitude.</param>
        /// <param name="y">m/s, each up to 1000 in magnitude.</param>
        /// <param name="z">m/s, each up to 1000 in magnitude.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.NotFinite"/>,
        /// <see cref="Status.InvalidArgument"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_set_uniform_wind(IntPtr world, float x, float y, float z);

        /// <summary>Reads the uniform wind that was set last.</summary>
        /// <param name="world">the world</param>
        /// <param name="velocity">receives 3 values, m/s; unchanged after an error.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_get_uniform_wind(IntPtr world, float* velocity);

        /// <summary>Fills a struct with its initial values; <c>GustsDesc.Create()</c> does it with the right size.</summary>
        /// <param name="desc">initialised by its <c>_init</c> function, or with struct_size set</param>
        /// <param name="structSize">sizeof the struct in the caller's header</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_gusts_desc_init(GustsDesc* desc, uint structSize);

        /// <summary>Adds gusts. The struct is copied.</summary>
        /// <param name="world">the world</param>
        /// <param name="desc">initialised by its <c>_init</c> function, or with struct_size set</param>
        /// <param name="out">receives the handle, id 0 after an error; may be null.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.StructSize"/>,
        /// <see cref="Status.NotFinite"/>, <see cref="Status.InvalidArgument"/>, <see cref="Status.Capacity"/> (of
        /// sources), <see cref="Status.OutOfMemory"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_add_gusts(IntPtr world, GustsDesc* desc, WindSourceId* @out);

        /// <summary>Replaces all values of a source of this kind.</summary>
        /// <param name="world">the world</param>
        /// <param name="source">handle of a wind source of the world</param>
        /// <param name="desc">initialised by its <c>_init</c> function, or with struct_size set</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.StaleWindSource"/>, <see cref="Status.InvalidArgument"/>
        /// (also a source of another kind), and every status of <see cref="Native.lr_world_add_gusts"/> but
        /// <see cref="Status.Capacity"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_update_gusts(IntPtr world, WindSourceId source, GustsDesc* desc);

        /// <summary>Reads a source of this kind as it was added or last updated, but with the position where it is now.
        /// desc: initialised, or with struct_size set; unchanged after an error.</summary>
        /// <param name="world">the world</param>
        /// <param name="source">handle of a wind source of the world</param>
        /// <param name="desc">initialised by its <c>_init</c> function, or with struct_size set</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.StructSize"/>,
        /// <see cref="Status.StaleWindSource"/>, <see cref="Status.InvalidArgument"/> (a source of another
        /// kind).</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_get_gusts(IntPtr world, WindSourceId source, GustsDesc* desc);

        /// <summary>Fills a struct with its initial values; <c>VortexDesc.Create()</c> does it with the right size.</summary>
        /// <param name="desc">initialised by its <c>_init</c> function, or with struct_size set</param>
        /// <param name="structSize">sizeof the struct in the caller's header</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_vortex_desc_init(VortexDesc* desc, uint structSize);

        /// <summary>Adds a vortex. Returns what <see cref="Native.lr_world_add_gusts"/> would.</summary>
        /// <param name="world">the world</param>
        /// <param name="desc">initialised by its <c>_init</c> function, or with struct_size set</param>
        /// <param name="out">the handle; may be null.</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_add_vortex(IntPtr world, VortexDesc* desc, WindSourceId* @out);

        /// <summary>Updates a vortex. Returns what <see cref="Native.lr_world_update_gusts"/> would.</summary>
        /// <param name="world">the world</param>
        /// <param name="source">handle of a wind source of the world</param>
        /// <param name="desc">initialised by its <c>_init</c> function, or with struct_size set</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_update_vortex(IntPtr world, WindSourceId source, VortexDesc* desc);

        /// <summary>Reads a vortex as last set. Returns what <see cref="Native.lr_world_get_gusts"/> would.</summary>
        /// <param name="world">the world</param>
        /// <param name="source">handle of a wind source of the world</param>
        /// <param name="desc">initialised by its <c>_init</c> function, or with struct_size set</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_get_vortex(IntPtr world, WindSourceId source, VortexDesc* desc);

        /// <summary>Fills a struct with its initial values; <c>BlowerDesc.Create()</c> does it with the right size.</summary>
        /// <param name="desc">initialised by its <c>_init</c> function, or with struct_size set</param>
        /// <param name="structSize">sizeof the struct in the caller's header</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_blower_desc_init(BlowerDesc* desc, uint structSize);

        /// <summary>Adds a blower. Returns what <see cref="Native.lr_world_add_gusts"/> would.</summary>
        /// <param name="world">the world</param>
        /// <param name="desc">initialised by its <c>_init</c> function, or with struct_size set</param>
        /// <param name="out">the handle; may be null.</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_add_blower(IntPtr world, BlowerDesc* desc, WindSourceId* @out);

        /// <summary>Updates a blower. Returns what <see cref="Native.lr_world_update_gusts"/> would.</summary>
        /// <param name="world">the world</param>
        /// <param name="source">handle of a wind source of the world</param>
        /// <param name="desc">initialised by its <c>_init</c> function, or with struct_size set</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_update_blower(IntPtr world, WindSourceId source, BlowerDesc* desc);

        /// <summary>Reads a blower as last set. Returns what <see cref="Native.lr_world_get_gusts"/> would.</summary>
        /// <param name="world">the world</param>
        /// <param name="source">handle of a wind source of the world</param>
        /// <param name="desc">initialised by its <c>_init</c> function, or with struct_size set</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_get_blower(IntPtr world, WindSourceId source, BlowerDesc* desc);

        /// <summary>Fills a struct with its initial values; <c>TurbulenceDesc.Create()</c> does it with the right size.</summary>
        /// <param name="desc">initialised by its <c>_init</c> function, or with struct_size set</param>
        /// <param name="structSize">sizeof the struct in the caller's header</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_turbulence_desc_init(TurbulenceDesc* desc, uint structSize);

        /// <summary>Adds turbulence. Returns what <see cref="Native.lr_world_add_gusts"/> would.</summary>
        /// <param name="world">the world</param>
        /// <param name="desc">initialised by its <c>_init</c> function, or with struct_size set</param>
        /// <param name="out">the handle; may be null.</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_add_turbulence(IntPtr world, TurbulenceDesc* desc, WindSourceId* @out);

        /// <summary>Updates turbulence. Returns what <see cref="Native.lr_world_update_gusts"/> would.</summary>
        /// <param name="world">the world</param>
        /// <param name="source">handle of a wind source of the world</param>
        /// <param name="desc">initialised by its <c>_init</c> function, or with struct_size set</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_update_turbulence(IntPtr world, WindSourceId source, TurbulenceDesc* desc);

        /// <summary>Reads turbulence as last set. Returns what <see cref="Native.lr_world_get_gusts"/> would.</summary>
        /// <param name="world">the world</param>
        /// <param name="source">handle of a wind source of the world</param>
        /// <param name="desc">initialised by its <c>_init</c> function, or with struct_size set</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_get_turbulence(IntPtr world, WindSourceId source, TurbulenceDesc* desc);

        /// <summary>Fills a struct with its initial values; <c>WindGridDesc.Create()</c> does it with the right size.</summary>
        /// <param name="desc">initialised by its <c>_init</c> function, or with struct_size set</param>
        /// <param name="structSize">sizeof the struct in the caller's header</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_wind_grid_desc_init(WindGridDesc* desc, uint structSize);

        /// <summary>Adds a grid. Returns what <see cref="Native.lr_world_add_gusts"/> would.</summary>
        /// <param name="world">the world</param>
        /// <param name="desc">initialised by its <c>_init</c> function, or with struct_size set</param>
        /// <param name="out">the handle; may be null.</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_add_wind_grid(IntPtr world, WindGridDesc* desc, WindSourceId* @out);

        /// <summary>Updates a grid. Returns what <see cref="Native.lr_world_update_gusts"/> would.</summary>
        /// <param name="world">the world</param>
        /// <param name="source">handle of a wind source of the world</param>
        /// <param name="desc">initialised by its <c>_init</c> function, or with struct_size set</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_update_wind_grid(IntPtr world, WindSourceId source, WindGridDesc* desc);

        /// <summary>Reads a grid as last set. Returns what <see cref="Native.lr_world_get_gusts"/> would.</summary>
        /// <param name="world">the world</param>
        /// <param name="source">handle of a wind source of the world</param>
        /// <param name="desc">initialised by its <c>_init</c> function, or with struct_size set</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_get_wind_grid(IntPtr world, WindSourceId source, WindGridDesc* desc);

        /// <summary>Fills a struct with its initial values; <c>GroundWindDesc.Create()</c> does it with the right size.</summary>
        /// <param name="desc">initialised by its <c>_init</c> function, or with struct_size set</param>
        /// <param name="structSize">sizeof the struct in the caller's header</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_ground_wind_desc_init(GroundWindDesc* desc, uint structSize);

        /// <summary>Adds the wind over a ground. Returns what <see cref="Native.lr_world_add_gusts"/> would.</summary>
        /// <param name="world">the world</param>
        /// <param name="desc">initialised by its <c>_init</c> function, or with struct_size set</param>
        /// <param name="out">the handle; may be null.</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_add_ground_wind(IntPtr world, GroundWindDesc* desc, WindSourceId* @out);

        /// <summary>Updates the wind over a ground. Returns what <see cref="Native.lr_world_update_gusts"/>
        /// would.</summary>
        /// <param name="world">the world</param>
        /// <param name="source">handle of a wind source of the world</param>
        /// <param name="desc">initialised by its <c>_init</c> function, or with struct_size set</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_update_ground_wind(IntPtr world, WindSourceId source, GroundWindDesc* desc);

        /// <summary>Reads the wind over a ground as last set. Returns what <see cref="Native.lr_world_get_gusts"/>
        /// would.</summary>
        /// <param name="world">the world</param>
        /// <param name="source">handle of a wind source of the world</param>
        /// <param name="desc">initialised by its <c>_init</c> function, or with struct_size set</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_get_ground_wind(IntPtr world, WindSourceId source, GroundWindDesc* desc);

        /// <summary>Removes a source of any kind.</summary>
        /// <param name="world">the world</param>
        /// <param name="source">handle of a wind source of the world</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>,
        /// <see cref="Status.StaleWindSource"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_remove_wind(IntPtr world, WindSourceId source);

        /// <summary>Returns 1 if the wind source exists in this world, else 0. Never an error: see
        /// <see cref="Native.lr_body_is_valid"/>.</summary>
        /// <param name="world">the world</param>
        /// <param name="source">handle of a wind source of the world</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int lr_wind_source_is_valid(IntPtr world, WindSourceId source);

        /// <summary>Sets a callback that adds an engine's own wind field to all other wind. Null removes it. Not part
        /// of snapshots.</summary>
        /// <param name="world">the world</param>
        /// <param name="callback">callback</param>
        /// <param name="user">passed to each call of the function</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/> (world).</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_set_wind_callback(IntPtr world, IntPtr callback, IntPtr user);

        /// <summary>Evaluates the fluid's velocity from all sources at the world's current time, for particles, cloth
        /// or debug arrows.</summary>
        /// <param name="world">the world</param>
        /// <param name="positions">3 * count values, m, x y z x y z ..., each up to 1e9 in magnitude.</param>
        /// <param name="count">number of elements</param>
        /// <param name="velocities">receives 3 * count, m/s. Both may be null when count is 0, and both may be the same
        /// array.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.NotFinite"/>,
        /// <see cref="Status.InvalidArgument"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_sample_wind(IntPtr world, float* positions, uint count, float* velocities);

        /// <summary>Fills a struct with its initial values; <c>WaterDesc.Create()</c> does it with the right size.</summary>
        /// <param name="desc">initialised by its <c>_init</c> function, or with struct_size set</param>
        /// <param name="structSize">sizeof the struct in the caller's header</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_water_desc_init(WaterDesc* desc, uint structSize);

        /// <summary>Sets the water from the next step on. The struct is copied; null removes the water. Bodies keep
        /// their velocities, even if they are now in another fluid. A batch whose mass matrix would be singular in
        /// water stays in its own fluid, and a warning is logged. Part of snapshots and of the world's hash. A change
        /// wakes sleeping bodies that feel it.</summary>
        /// <param name="world">the world</param>
        /// <param name="desc">initialised by its <c>_init</c> function, or with struct_size set</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/> (world),
        /// <see cref="Status.StructSize"/>, <see cref="Status.NotFinite"/>, <see cref="Status.InvalidArgument"/>,
        /// <see cref="Status.OutOfMemory"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_set_water(IntPtr world, WaterDesc* desc);

        /// <summary>Reads the water.</summary>
        /// <param name="world">the world</param>
        /// <param name="desc">initialised, or with struct_size set; receives initial values if there is no
        /// water.</param>
        /// <param name="present">receives 1 or 0.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>,
        /// <see cref="Status.StructSize"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_get_water(IntPtr world, WaterDesc* desc, int* present);

        /// <summary>Sets a callback for an engine's own water, used while <see cref="Native.lr_world_set_water"/> has
        /// set a surface. Null removes it. Not part of snapshots.</summary>
        /// <param name="world">the world</param>
        /// <param name="callback">callback</param>
        /// <param name="user">passed to each call of the function</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/> (world).</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_set_water_callback(IntPtr world, IntPtr callback, IntPtr user);

        /// <summary>Advances all bodies by dt, in <paramref name="substeps"/> equal parts. At 60 Hz use 1 substep for
        /// flat leaves and paper of a few centimetres, 2 for bent leaves, 4 for petals and confetti
        /// (docs/maintainers/numerics.md). Rules end bodies and emitters spawn them at the end of the step. Allocates
        /// only in the case that <see cref="Allocator"/> describes. Saves, sets and restores the calling thread's
        /// floating-point mode. Needs 192 KB of stack.</summary>
        /// <param name="world">the world</param>
        /// <param name="dt">s, &gt; 0.</param>
        /// <param name="substeps">1 to <see cref="Limits.MaxSubsteps"/>.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <c>Status.Timestep*</c>,
        /// <see cref="Status.Substeps"/>, <see cref="Status.OutOfMemory"/>: the step was taken, so do not repeat it,
        /// but bodies may have passed through each other. The next step asks for the memory again.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_step(IntPtr world, float dt, uint substeps);

        /// <summary>Limits the work of each step to a number of substeps of single bodies: the same work, so the same
        /// bits, on every machine. Takes effect at the next step. Part of snapshots. If the batches that are due need
        /// more, each first gets the fewest substeps that preserve its fall statistics
        /// (<see cref="Native.lr_batch_set_rate"/>); batches that have waited longest come first, and none waits
        /// forever. A batch with forces on single bodies is stepped at once, even beyond the budget.
        /// docs/reference/stepping.md.</summary>
        /// <param name="world">the world</param>
        /// <param name="bodySubsteps">at most 2^48; 0, the default, for no limit.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>,
        /// <see cref="Status.InvalidArgument"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_set_budget(IntPtr world, ulong bodySubsteps);

        /// <summary>Fills a struct with its initial values; <c>StepReport.Create()</c> does it with the right size.</summary>
        /// <param name="report">report</param>
        /// <param name="structSize">sizeof the struct in the caller's header</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_step_report_init(StepReport* report, uint structSize);

        /// <summary>Reads the report of the last step: zeros before the first step and after a snapshot is
        /// restored.</summary>
        /// <param name="world">the world</param>
        /// <param name="report">initialised, or with struct_size set.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>,
        /// <see cref="Status.StructSize"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_get_step_report(IntPtr world, StepReport* report);

        /// <summary>Fills a struct with its initial values; <c>Timings.Create()</c> does it with the right size.</summary>
        /// <param name="timings">timings</param>
        /// <param name="structSize">sizeof the struct in the caller's header</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_timings_init(Timings* timings, uint structSize);

        /// <summary>Reads the timings of the last step: zeros before the first one.</summary>
        /// <param name="world">the world</param>
        /// <param name="timings">initialised, or with struct_size set.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>,
        /// <see cref="Status.StructSize"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_get_timings(IntPtr world, Timings* timings);

        /// <summary>Computes a hash of the world's time index, bodies, colliders, pairs of touching bodies, water and
        /// wind sources (grids by the hash of their samples). It does not depend on the order of bodies in memory, the
        /// processor or worker_count. Worlds with equal settings and equal hashes move alike from here on.</summary>
        /// <param name="world">the world</param>
        /// <param name="out">out</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_hash(IntPtr world, ulong* @out);

        /// <summary>Bytes that <see cref="Native.lr_world_snapshot_save"/> needs at present; 0 for null. With body
        /// contact 120 of them for each pair of awake bodies that touch or nearly do.</summary>
        /// <param name="world">the world</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern ulong lr_world_snapshot_size(IntPtr world);

        /// <summary>Writes the world's state into <paramref name="size"/> bytes at <paramref name="memory"/>, of any
        /// alignment: time, gravity, wind, water, budget; bodies and colliders with their handles; pairs of touching
        /// bodies; each batch's turbulence table, loads, forces, rules, emitter, rate and contact settings. Not
        /// included: assets, the descs of batches, threads, callbacks, the samples of wind grids, and the data of
        /// hulls, heightfields and meshes; samples and data are identified by their hash.</summary>
        /// <param name="world">the world</param>
        /// <param name="memory">the bytes</param>
        /// <param name="size">number of bytes</param>
        /// <param name="written">bytes used; may be null.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>,
        /// <see cref="Status.BufferTooSmall"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_snapshot_save(IntPtr world, void* memory, ulong size, ulong* written);

        /// <summary>Restores a saved state. The world may be another one, also in another process, if its batches were
        /// created in the same order from equal assets with equal capacities. Bodies, wind sources and colliders get
        /// their handles back. Wind grids, hulls, heightfields and meshes must already be in the world, anywhere. The
        /// snapshot is checked as a whole before anything changes. Allocates nothing in a world that has held as much
        /// before. docs/reference/snapshots.md says which versions restore which snapshots.</summary>
        /// <param name="world">the world</param>
        /// <param name="memory">the bytes</param>
        /// <param name="size">number of bytes</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.SnapshotFormat"/>,
        /// <see cref="Status.SnapshotMismatch"/>, <see cref="Status.OutOfMemory"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_snapshot_restore(IntPtr world, void* memory, ulong size);
    }
}
