// SPDX-License-Identifier: MIT
// Written by bindings/generator/csharp.py from include/langevin_rigid.h: change those.
using System;
using System.Runtime.InteropServices;

namespace LangevinRigid
{
    public static unsafe partial class Native
    {
        /// <summary>Fills a struct with its initial values; <c>BatchRules.Create()</c> does it with the right size.</summary>
        /// <param name="rules">rules</param>
        /// <param name="structSize">sizeof the struct as the caller sees it</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_batch_rules_init(BatchRules* rules, uint structSize);

        /// <summary>Bodies are judged at the end of each step, those at rest (<see cref="Native.lr_body_set_rest"/>) in
        /// one of 16 of their batch. Copied; null ends the rules. Part of snapshots. The first rules or emitter of a
        /// batch take 24 bytes for each of its capacity; later calls, say to move a volume along with a camera,
        /// none.</summary>
        /// <param name="world">the world</param>
        /// <param name="batch">handle of a batch of the world</param>
        /// <param name="rules">rules</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/> (world),
        /// <see cref="Status.StaleBatch"/>, <see cref="Status.StructSize"/>, <see cref="Status.NotFinite"/>,
        /// <see cref="Status.InvalidArgument"/> (also <see cref="EndAction.Respawn"/> without an emitter),
        /// <see cref="Status.OutOfMemory"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_batch_set_rules(IntPtr world, BatchId batch, BatchRules* rules);

        /// <summary>What becomes of a body that has left physics: forces beyond all measure, a scheme that blows up, a
        /// collider that shoots it out of the world. Every body is judged in each step, and after impulses: a number
        /// that is not finite, a coordinate over 1e10 m, a velocity over 2e6 m/s or 1e9 rad/s, or an orientation that
        /// is none must not be seen. At the end of the step it is told by <see cref="ContactEventKind.BodyFaulted"/>,
        /// counted in <see cref="BatchEvents"/>, and logged once for all; others are not touched by it.
        /// docs/reference/bodies.md A body that is held has the position and orientation of the beginning of that step
        /// or substep, and no velocity. Nothing moves or touches it, it moves and touches nothing, forces on it are
        /// taken and have no effect; it grows older, and rules may end it. <see cref="Native.lr_body_set_state"/> sets
        /// it free, and <see cref="Native.lr_body_set_rest"/> puts it to rest like any other.
        /// <see cref="BodyState.Resting"/> tells. Initially <see cref="FaultPolicy.Auto"/>. From the next step on, also
        /// for the others; those that are held stay so. Part of snapshots and hash.</summary>
        /// <param name="world">the world</param>
        /// <param name="batch">handle of a batch of the world</param>
        /// <param name="policy"><see cref="FaultPolicy"/>. <see cref="FaultPolicy.Remove"/> takes memory as
        /// <see cref="Native.lr_batch_set_rules"/>.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.StaleBatch"/>,
        /// <see cref="Status.InvalidArgument"/>, <see cref="Status.OutOfMemory"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_batch_set_fault_policy(IntPtr world, BatchId batch, FaultPolicy policy);

        /// <summary><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>,
        /// <see cref="Status.StaleBatch"/>.</summary>
        /// <param name="world">the world</param>
        /// <param name="batch">handle of a batch of the world</param>
        /// <param name="policy">receives <see cref="FaultPolicy"/>; unchanged after an error.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>,
        /// <see cref="Status.StaleBatch"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_batch_get_fault_policy(IntPtr world, BatchId batch, FaultPolicy* policy);

        /// <summary>Fills a struct with its initial values; <c>EmitterDesc.Create()</c> does it with the right size.</summary>
        /// <param name="desc">initialised by its <c>_init</c> function, or with struct_size set</param>
        /// <param name="structSize">sizeof the struct as the caller sees it</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_emitter_desc_init(EmitterDesc* desc, uint structSize);

        /// <summary>Bodies are born at the end of each step, after others have ended, up to the batch's capacity; those
        /// that find no room are not born later. Their keys are the world's next. Copied; another emitter carries on
        /// with the fraction of a body that is due and with the time since the last burst; null ends it. Part of
        /// snapshots. Memory: as <see cref="Native.lr_batch_set_rules"/>.</summary>
        /// <param name="world">the world</param>
        /// <param name="batch">handle of a batch of the world</param>
        /// <param name="desc">initialised by its <c>_init</c> function, or with struct_size set</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/> (world),
        /// <see cref="Status.StaleBatch"/>, <see cref="Status.StructSize"/>, <see cref="Status.NotFinite"/>,
        /// <see cref="Status.InvalidArgument"/> (also null while the rules respawn),
        /// <see cref="Status.OutOfMemory"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_batch_set_emitter(IntPtr world, BatchId batch, EmitterDesc* desc);

        /// <summary>Bears <paramref name="count"/> bodies now, all or none.</summary>
        /// <param name="world">the world</param>
        /// <param name="batch">handle of a batch of the world</param>
        /// <param name="count">elements of the arrays</param>
        /// <param name="outIds">receives <paramref name="count"/> ids; may be null.</param>
        /// <returns><see cref="Status.Ok"/> (also for count 0), <see cref="Status.NullArgument"/>,
        /// <see cref="Status.StaleBatch"/>, <see cref="Status.InvalidArgument"/> (no emitter),
        /// <see cref="Status.Capacity"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_batch_emit(IntPtr world, BatchId batch, uint count, BodyId* outIds);

        /// <summary>Fills a struct with its initial values; <c>BatchEvents.Create()</c> does it with the right size.</summary>
        /// <param name="events">events</param>
        /// <param name="structSize">sizeof the struct as the caller sees it</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_batch_events_init(BatchEvents* events, uint structSize);

        /// <summary>Lists are valid until the next call that is not a query. All but faults is 0 and null for a batch
        /// that never had rules or an emitter. Totals are part of snapshots; after a restore there are no events of the
        /// last step.</summary>
        /// <param name="world">the world</param>
        /// <param name="batch">handle of a batch of the world</param>
        /// <param name="events">events</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.StaleBatch"/>,
        /// <see cref="Status.StructSize"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_batch_get_events(IntPtr world, BatchId batch, BatchEvents* events);
    }
}
