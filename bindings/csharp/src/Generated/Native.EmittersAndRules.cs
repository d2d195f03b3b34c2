// SPDX-License-Identifier: MIT
// Written by bindings/generator/csharp.py from include/langevin_rigid.h: do not edit.
using System;
using System.Runtime.InteropServices;

namespace LangevinRigid
{
    public static unsafe partial class Native
    {
        /// <summary>Fills a struct with its initial values; <c>BatchRules.Create()</c> does it with the right size.</summary>
        /// <param name="rules">rules</param>
        /// <param name="structSize">sizeof the struct in the caller's header</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_batch_rules_init(BatchRules* rules, uint structSize);

        /// <summary>Sets the rules of a batch. Awake bodies are checked at the end of each step, sleeping ones in every
        /// 16th step of their batch. The struct is copied; null removes the rules. Part of snapshots. A batch's first
        /// rules or emitter allocate 8 bytes for each body of its capacity; later calls, such as moving a volume along
        /// with a camera, allocate nothing.</summary>
        /// <param name="world">the world</param>
        /// <param name="batch">handle of a batch of the world</param>
        /// <param name="rules">rules</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/> (world),
        /// <see cref="Status.StaleBatch"/>, <see cref="Status.StructSize"/>, <see cref="Status.NotFinite"/>,
        /// <see cref="Status.InvalidArgument"/> (also <see cref="EndAction.Respawn"/> without an emitter),
        /// <see cref="Status.OutOfMemory"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_batch_set_rules(IntPtr world, BatchId batch, BatchRules* rules);

        /// <summary>Reads the rules of a batch.</summary>
        /// <param name="world">the world</param>
        /// <param name="batch">handle of a batch of the world</param>
        /// <param name="rules">initialised, or with struct_size set; receives initial values if there are none.</param>
        /// <param name="present">receives 1 or 0.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.StaleBatch"/>,
        /// <see cref="Status.StructSize"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_batch_get_rules(IntPtr world, BatchId batch, BatchRules* rules, int* present);

        /// <summary>Sets how a batch treats diverged bodies: those with a number that is not finite, a coordinate over
        /// 1e10 m, a velocity over 2e6 m/s or 1e9 rad/s, or an invalid orientation. Bodies diverge through extreme
        /// forces, an unstable integrator, or a collider that shoots them out of the world. Every body is checked in
        /// each step and after impulses, so such values are never visible and never affect other bodies. At the end of
        /// the step the body causes <see cref="EventKind.Diverged"/> and counts in <see cref="BatchCounts"/>; one
        /// message is logged for all. docs/reference/bodies.md A held body stays at its position and orientation from
        /// the beginning of that step or substep, without velocity. It collides with nothing, and forces on it are
        /// accepted without effect. It ages, and rules can end it. <see cref="Native.lr_body_set_state"/> frees it,
        /// <see cref="Native.lr_body_set_sleep"/> can put it to sleep, and <see cref="BodyState.SleepState"/> shows
        /// that it is held. Takes effect at the next step; bodies already held stay held. Part of snapshots and of the
        /// world's hash. <see cref="DivergencePolicy.Remove"/> allocates as <see cref="Native.lr_batch_set_rules"/>
        /// does.</summary>
        /// <param name="world">the world</param>
        /// <param name="batch">handle of a batch of the world</param>
        /// <param name="policy"><see cref="DivergencePolicy"/>; default <see cref="DivergencePolicy.Auto"/>.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.StaleBatch"/>,
        /// <see cref="Status.InvalidArgument"/>, <see cref="Status.OutOfMemory"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_batch_set_divergence_policy(IntPtr world, BatchId batch, DivergencePolicy policy);

        /// <summary>Reads how a batch treats diverged bodies.</summary>
        /// <param name="world">the world</param>
        /// <param name="batch">handle of a batch of the world</param>
        /// <param name="policy">receives <see cref="DivergencePolicy"/>; unchanged after an error.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>,
        /// <see cref="Status.StaleBatch"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_batch_get_divergence_policy(IntPtr world, BatchId batch, DivergencePolicy* policy);

        /// <summary>Fills a struct with its initial values; <c>EmitterDesc.Create()</c> does it with the right size.</summary>
        /// <param name="desc">initialised by its <c>_init</c> function, or with struct_size set</param>
        /// <param name="structSize">sizeof the struct in the caller's header</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_emitter_desc_init(EmitterDesc* desc, uint structSize);

        /// <summary>Sets the emitter of a batch. Bodies spawn at the end of each step, after rules have ended others,
        /// up to the batch's capacity; spawns beyond it are dropped, not postponed. New bodies take the world's next
        /// noise seeds, and 0 as <c>user</c>. The struct is copied; null removes the emitter. A replacement keeps the
        /// pending fraction of a spawn and the time since the last burst. Part of snapshots. Allocates as
        /// <see cref="Native.lr_batch_set_rules"/> does.</summary>
        /// <param name="world">the world</param>
        /// <param name="batch">handle of a batch of the world</param>
        /// <param name="desc">initialised by its <c>_init</c> function, or with struct_size set</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/> (world),
        /// <see cref="Status.StaleBatch"/>, <see cref="Status.StructSize"/>, <see cref="Status.NotFinite"/>,
        /// <see cref="Status.InvalidArgument"/> (also null while the rules respawn),
        /// <see cref="Status.OutOfMemory"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_batch_set_emitter(IntPtr world, BatchId batch, EmitterDesc* desc);

        /// <summary>Reads the emitter of a batch.</summary>
        /// <param name="world">the world</param>
        /// <param name="batch">handle of a batch of the world</param>
        /// <param name="desc">initialised, or with struct_size set; receives initial values if there is none.</param>
        /// <param name="present">receives 1 or 0.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.StaleBatch"/>,
        /// <see cref="Status.StructSize"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_batch_get_emitter(IntPtr world, BatchId batch, EmitterDesc* desc, int* present);

        /// <summary>Spawns <paramref name="count"/> bodies now, all or none.</summary>
        /// <param name="world">the world</param>
        /// <param name="batch">handle of a batch of the world</param>
        /// <param name="count">number of elements</param>
        /// <param name="outIds">receives <paramref name="count"/> ids; may be null.</param>
        /// <returns><see cref="Status.Ok"/> (also for count 0), <see cref="Status.NullArgument"/>,
        /// <see cref="Status.StaleBatch"/>, <see cref="Status.InvalidArgument"/> (no emitter),
        /// <see cref="Status.Capacity"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_batch_spawn(IntPtr world, BatchId batch, uint count, BodyId* outIds);

        /// <summary>Spawns <paramref name="count"/> bodies in a box now, all or none, without an emitter: awake, evenly
        /// distributed, each orientation equally likely, at rest, scale 1, age 0, with the world's next noise seeds.
        /// Random values depend only on the world's seed and the body's noise seed, as with an
        /// <see cref="EmitterShape.Box"/> emitter. Causes <see cref="EventKind.Spawned"/>. Allocates nothing, and so
        /// counts in <see cref="BatchCounts"/> only while the batch has rules or an emitter.</summary>
        /// <param name="world">the world</param>
        /// <param name="batch">handle of a batch of the world</param>
        /// <param name="low">x, y, z of the corners, m, each up to 1e9 in magnitude, low &lt;= high.</param>
        /// <param name="high">x, y, z of the corners, m, each up to 1e9 in magnitude, low &lt;= high.</param>
        /// <param name="count">number of elements</param>
        /// <param name="outIds">receives <paramref name="count"/> ids; may be null.</param>
        /// <returns><see cref="Status.Ok"/> (also for count 0), <see cref="Status.NullArgument"/>,
        /// <see cref="Status.StaleBatch"/>, <see cref="Status.NotFinite"/>, <see cref="Status.InvalidArgument"/>,
        /// <see cref="Status.Capacity"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_batch_spawn_box(IntPtr world, BatchId batch, float* low, float* high, uint count, BodyId* outIds);

        /// <summary>Fills a struct with its initial values; <c>BatchCounts.Create()</c> does it with the right size.</summary>
        /// <param name="counts">counts</param>
        /// <param name="structSize">sizeof the struct in the caller's header</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_batch_counts_init(BatchCounts* counts, uint structSize);

        /// <summary>Reads the counts of a batch. A batch that never had rules or an emitter counts only diverged
        /// bodies. Totals are part of snapshots; after a restore the counts of the last step are 0.</summary>
        /// <param name="world">the world</param>
        /// <param name="batch">handle of a batch of the world</param>
        /// <param name="counts">initialised, or with struct_size set.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.StaleBatch"/>,
        /// <see cref="Status.StructSize"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_batch_get_counts(IntPtr world, BatchId batch, BatchCounts* counts);
    }
}
