// SPDX-License-Identifier: MIT
// Written by bindings/generator/csharp.py from include/langevin_rigid.h: do not edit.
using System;
using System.Runtime.InteropServices;

namespace LangevinRigid
{
    public static unsafe partial class Native
    {
        /// <summary>Enables events; at most <paramref name="capacity"/> are stored per step. Contacts that already
        /// exist do not begin again. capacity 0 disables events. All memory is allocated here and by
        /// <see cref="Native.lr_batch_create"/>, none in steps: 64 bytes per event, and 233 for each body of a batch's
        /// capacity. Not part of the world's hash. Snapshots contain only events that calls since the last step have
        /// left for the next one, 33 bytes for each body of a batch's capacity.</summary>
        /// <param name="world">the world</param>
        /// <param name="capacity">number of elements that fit</param>
        /// <param name="kinds">bits <see cref="EventKinds"/>.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.InvalidArgument"/>
        /// (unknown bits, or no bits with a capacity), <see cref="Status.OutOfMemory"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_set_events(IntPtr world, uint capacity, EventKinds kinds);

        /// <summary>Fills a struct with its initial values; <c>EventList.Create()</c> does it with the right size.</summary>
        /// <param name="list">list</param>
        /// <param name="structSize">sizeof the struct in the caller's header</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_event_list_init(EventList* list, uint structSize);

        /// <summary>Gets the events of the last step. Valid until the next call that is not a query; empty after
        /// <see cref="Native.lr_world_snapshot_restore"/>. Sorted by batch (its place in the world's table), noise
        /// seed, kind and collider slot, so the order does not depend on workers, processor or memory. Bodies with the
        /// same noise seed are sorted by slot. Contacts are checked after each substep but end only at the end of a
        /// step: a body that bounces within a step begins one contact, and one that touches and leaves begins and ends
        /// it. A sleeping body still touches its support. A body that ends has one <see cref="EventKind.Killed"/> or
        /// <see cref="EventKind.Respawned"/>, and before it at most <see cref="EventKind.Spawned"/>, after it at most
        /// <see cref="EventKind.Diverged"/>. <see cref="Native.lr_body_destroy"/> and
        /// <see cref="Native.lr_batch_destroy"/> cause no event. A body has at most four contacts, those that press it
        /// most. Contact with other bodies takes one of the four and causes no events, but a body that falls asleep on
        /// other bodies has landed.</summary>
        /// <param name="world">the world</param>
        /// <param name="list">initialised, or with struct_size set.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>,
        /// <see cref="Status.StructSize"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_get_events(IntPtr world, EventList* list);
    }
}
