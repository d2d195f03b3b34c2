// SPDX-License-Identifier: MIT
// Written by bindings/generator/csharp.py from include/langevin_rigid.h: change those.
using System;
using System.Runtime.InteropServices;

namespace LangevinRigid
{
    public static unsafe partial class Native
    {
        /// <summary>Fills a struct with its initial values; <c>WorldDesc.Create()</c> does it with the right size.</summary>
        /// <param name="desc">initialised by its <c>_init</c> function, or with struct_size set</param>
        /// <param name="structSize">sizeof the struct as the caller sees it</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_desc_init(WorldDesc* desc, uint structSize);

        /// <summary>
        /// <para><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.StructSize"/>,
        /// <see cref="Status.NotFinite"/>, <see cref="Status.InvalidArgument"/>, <see cref="Status.Unsupported"/>
        /// (simd_target), <see cref="Status.OutOfMemory"/>, <see cref="Status.Threads"/>.</para>
        /// <para>Any thread.</para>
        /// </summary>
        /// <param name="desc">initialised by its <c>_init</c> function, or with struct_size set</param>
        /// <param name="out">receives the world, null after an error.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.StructSize"/>,
        /// <see cref="Status.NotFinite"/>, <see cref="Status.InvalidArgument"/>, <see cref="Status.Unsupported"/>
        /// (simd_target), <see cref="Status.OutOfMemory"/>, <see cref="Status.Threads"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_create(WorldDesc* desc, IntPtr* @out);

        /// <summary>Frees a world with all its batches and bodies, and ends its worker threads. A recording ends. Null
        /// is fine.</summary>
        /// <param name="world">the world</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern void lr_world_destroy(IntPtr world);

        /// <summary>Fills a struct with its initial values; <c>WorldInfo.Create()</c> does it with the right size.</summary>
        /// <param name="info">info</param>
        /// <param name="structSize">sizeof the struct as the caller sees it</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_info_init(WorldInfo* info, uint structSize);

        /// <summary><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>,
        /// <see cref="Status.StructSize"/>.</summary>
        /// <param name="world">the world</param>
        /// <param name="info">info</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>,
        /// <see cref="Status.StructSize"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_get_info(IntPtr world, WorldInfo* info);

        /// <summary>Takes effect with the next step. Another one than before wakes all bodies
        /// (<see cref="Native.lr_body_set_rest"/>).</summary>
        /// <param name="world">the world</param>
        /// <param name="gravity">m/s^2, 3 values, each up to 1e4 in magnitude.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.NotFinite"/>,
        /// <see cref="Status.InvalidArgument"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_set_gravity(IntPtr world, float* gravity);

        /// <summary>Changes the instruction set from the next step on; results do not change.</summary>
        /// <param name="world">the world</param>
        /// <param name="target">target</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.InvalidArgument"/>,
        /// <see cref="Status.Unsupported"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_set_simd_target(IntPtr world, SimdTarget target);

        /// <summary>Fills a struct with its initial values; <c>WindDesc.Create()</c> does it with the right size.</summary>
        /// <param name="desc">initialised by its <c>_init</c> function, or with struct_size set</param>
        /// <param name="structSize">sizeof the struct as the caller sees it</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_wind_desc_init(WindDesc* desc, uint structSize);

        /// <summary>The uniform part of the fluid's velocity; copied. Bodies feel the fluid's velocity relative to
        /// theirs. A change is spread evenly over the next step, and bodies feel the fluid's acceleration in it
        /// (Froude-Krylov force and added mass): one that has the fluid's density is carried along, a heavy one keeps
        /// most of its velocity. What is set before the world's first step is there from the beginning and accelerates
        /// nothing; setting the same wind again changes nothing. Null is still fluid.
        /// docs/reference/wind_and_water.md.</summary>
        /// <param name="world">the world</param>
        /// <param name="desc">initialised by its <c>_init</c> function, or with struct_size set</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/> (world),
        /// <see cref="Status.StructSize"/>, <see cref="Status.NotFinite"/>,
        /// <see cref="Status.InvalidArgument"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_set_wind(IntPtr world, WindDesc* desc);

        /// <summary>Fills a struct with its initial values; <c>WindSourceDesc.Create()</c> does it with the right size.</summary>
        /// <param name="desc">initialised by its <c>_init</c> function, or with struct_size set</param>
        /// <param name="structSize">sizeof the struct as the caller sees it</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_wind_source_desc_init(WindSourceDesc* desc, uint structSize);

        /// <summary>Adds a source. Bodies keep their velocities: a field that appears is not one that
        /// accelerates.</summary>
        /// <param name="world">the world</param>
        /// <param name="desc">initialised by its <c>_init</c> function, or with struct_size set</param>
        /// <param name="out">receives the handle, 0 after an error; may be null.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/> (also desc-&gt;samples of a grid),
        /// <see cref="Status.StructSize"/>, <see cref="Status.NotFinite"/>, <see cref="Status.InvalidArgument"/>,
        /// <see cref="Status.Capacity"/>, <see cref="Status.OutOfMemory"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_add_wind(IntPtr world, WindSourceDesc* desc, WindSourceId* @out);

        /// <summary>Replaces everything of a source, also its kind. A grid may be given without samples: it then keeps
        /// those it has, if counts and frames are as before.</summary>
        /// <param name="world">the world</param>
        /// <param name="source">handle of a wind source of the world</param>
        /// <param name="desc">initialised by its <c>_init</c> function, or with struct_size set</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.StaleWindSource"/>, and what
        /// <see cref="Native.lr_world_add_wind"/> returns.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_update_wind(IntPtr world, WindSourceId source, WindSourceDesc* desc);

        /// <summary><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>,
        /// <see cref="Status.StaleWindSource"/>.</summary>
        /// <param name="world">the world</param>
        /// <param name="source">handle of a wind source of the world</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>,
        /// <see cref="Status.StaleWindSource"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_remove_wind(IntPtr world, WindSourceId source);

        /// <summary>An engine's own field, added to all else. Null removes it. Not part of snapshots.</summary>
        /// <param name="world">the world</param>
        /// <param name="callback">callback</param>
        /// <param name="user">as given along with the function</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/> (world).</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_set_wind_callback(IntPtr world, IntPtr callback, IntPtr user);

        /// <summary>The velocity of the fluid at the world's present time, of all sources: for particles, cloth, arrows
        /// on a screen.</summary>
        /// <param name="world">the world</param>
        /// <param name="positions">3 * count values, m, x y z x y z ..., each up to 1e9 in magnitude.</param>
        /// <param name="count">elements of the arrays</param>
        /// <param name="velocities">receives 3 * count, m/s. Both may be null when count is 0; they may be the same
        /// array.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.NotFinite"/>,
        /// <see cref="Status.InvalidArgument"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_sample_wind(IntPtr world, float* positions, uint count, float* velocities);

        /// <summary>Fills a struct with its initial values; <c>SurfaceDesc.Create()</c> does it with the right size.</summary>
        /// <param name="desc">initialised by its <c>_init</c> function, or with struct_size set</param>
        /// <param name="structSize">sizeof the struct as the caller sees it</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_surface_desc_init(SurfaceDesc* desc, uint structSize);

        /// <summary>From the next step on; copied. Null removes it. Bodies keep their velocities, also those that are
        /// now in another fluid. A batch whose mass matrix is singular in it stays in its own, with a warning. Part of
        /// snapshots and hash.</summary>
        /// <param name="world">the world</param>
        /// <param name="desc">initialised by its <c>_init</c> function, or with struct_size set</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/> (world),
        /// <see cref="Status.StructSize"/>, <see cref="Status.NotFinite"/>,
        /// <see cref="Status.InvalidArgument"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_set_surface(IntPtr world, SurfaceDesc* desc);

        /// <summary>An engine's own water, while there is a surface. Null removes it. Not part of snapshots.</summary>
        /// <param name="world">the world</param>
        /// <param name="callback">callback</param>
        /// <param name="user">as given along with the function</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/> (world).</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_set_surface_callback(IntPtr world, IntPtr callback, IntPtr user);

        /// <summary>Advances all bodies by dt in <paramref name="substeps"/> equal parts.</summary>
        /// <param name="world">the world</param>
        /// <param name="dt">s, &gt; 0.</param>
        /// <param name="substeps">1 to <see cref="Limits.MaxSubsteps"/>; at 60 Hz, 2 suit leaves and paper of some
        /// centimetres, 4 petals and confetti (docs/maintainers/numerics.md). At its end bodies end and are born as the
        /// batches' rules and emitters say. Allocates nothing but what <see cref="Allocator"/> says. The floating-point
        /// mode of the calling thread is saved, set and restored.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <c>Status.Timestep*</c>,
        /// <see cref="Status.Substeps"/>, <see cref="Status.OutOfMemory"/>: the step has been taken, not to be
        /// repeated, but bodies went through each other in it; the next one asks for the memory again.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_step(IntPtr world, float dt, uint substeps);

        /// <summary>A budget for the work of each step: a count of substeps of single bodies, whatever each of them
        /// costs, at most 2^48; 0, as at first: none. From the next step on; part of snapshots. Where the batches that
        /// are due want more, each gets the fewest substeps that keep falls as they are
        /// (<see cref="Native.lr_batch_set_rate"/>), those that have waited longest first; nobody waits for ever. The
        /// same calls give the same bits on every machine. A batch on whose single bodies forces act is stepped at
        /// once, even over the budget. docs/reference/stepping.md.</summary>
        /// <param name="world">the world</param>
        /// <param name="bodySubsteps">body substeps</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>,
        /// <see cref="Status.InvalidArgument"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_set_budget(IntPtr world, ulong bodySubsteps);

        /// <summary>Fills a struct with its initial values; <c>StepReport.Create()</c> does it with the right size.</summary>
        /// <param name="report">report</param>
        /// <param name="structSize">sizeof the struct as the caller sees it</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_step_report_init(StepReport* report, uint structSize);

        /// <summary><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>,
        /// <see cref="Status.StructSize"/>.</summary>
        /// <param name="world">the world</param>
        /// <param name="report">initialised, or with struct_size set. Zeros before the first step, and after a snapshot
        /// was restored.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>,
        /// <see cref="Status.StructSize"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_get_step_report(IntPtr world, StepReport* report);

        /// <summary>A hash of the state of all bodies and the time index. Independent of the order of bodies in memory,
        /// of the processor and of worker_count; equal hashes mean equal motion from here on, given equal worlds. Wind
        /// sources are part of it, grids by the hash of their samples, the surface, and colliders.</summary>
        /// <param name="world">the world</param>
        /// <param name="out">out</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_hash(IntPtr world, ulong* @out);

        /// <summary>Bytes that <see cref="Native.lr_world_snapshot_save"/> needs at present; 0 for null.</summary>
        /// <param name="world">the world</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern ulong lr_world_snapshot_size(IntPtr world);

        /// <summary>Writes the world's state (bodies with their ids, time, wind, surface, gravity, tables, loads,
        /// forces, rules, emitter, rates, budget, colliders with their ids, how batches meet them and each other) into
        /// <paramref name="size"/> bytes at <paramref name="memory"/>, any alignment. Assets, how batches were created,
        /// threads and callbacks are not part of it, nor the samples of wind grids and the data of hulls, heightfields
        /// and meshes, which are named by their hash.</summary>
        /// <param name="world">the world</param>
        /// <param name="memory">the bytes</param>
        /// <param name="size">bytes</param>
        /// <param name="written">bytes used; may be null.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>,
        /// <see cref="Status.BufferTooSmall"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_snapshot_save(IntPtr world, void* memory, ulong size, ulong* written);

        /// <summary>Puts a saved state back, also into another world or process whose batches were created in the same
        /// order from equal assets with equal capacities. Bodies, wind sources and colliders have the same ids as when
        /// it was saved; grids of wind, hulls, heightfields and meshes must be in the world already, in any place.
        /// Checked whole before anything changes. Allocates nothing where the world has held as much before.
        /// docs/reference/snapshots.md: which versions restore which snapshots.</summary>
        /// <param name="world">the world</param>
        /// <param name="memory">the bytes</param>
        /// <param name="size">bytes</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.SnapshotFormat"/>,
        /// <see cref="Status.SnapshotMismatch"/>, <see cref="Status.OutOfMemory"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_snapshot_restore(IntPtr world, void* memory, ulong size);
    }
}
