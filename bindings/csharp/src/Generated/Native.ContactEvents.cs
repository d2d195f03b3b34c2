// SPDX-License-Identifier: MIT
// Written by bindings/generator/csharp.py from include/langevin_rigid.h: change those.
using System;
using System.Runtime.InteropServices;

namespace LangevinRigid
{
    public static unsafe partial class Native
    {
        /// <summary>Has events kept, at most <paramref name="capacity"/> of a step, from now on: contacts that there
        /// are already do not begin again.</summary>
        /// <param name="world">the world</param>
        /// <param name="capacity">elements that there is room for</param>
        /// <param name="kinds">bits <see cref="ContactEvents"/>. capacity 0 ends it. All memory is taken here and by
        /// <see cref="Native.lr_batch_create"/>, 225 bytes for each of a batch's capacity and 64 for each event, and a
        /// step takes none. Neither part of snapshots nor of the world's hash.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.InvalidArgument"/>
        /// (unknown bits; no bit but a capacity), <see cref="Status.OutOfMemory"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_set_contact_events(IntPtr world, uint capacity, ContactEvents kinds);

        /// <summary>Fills a struct with its initial values; <c>ContactEventList.Create()</c> does it with the right size.</summary>
        /// <param name="list">list</param>
        /// <param name="structSize">sizeof the struct as the caller sees it</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_contact_event_list_init(ContactEventList* list, uint structSize);

        /// <summary>Valid until the next call that is not a query; empty after
        /// <see cref="Native.lr_world_snapshot_restore"/>. In order of batches (their place in the world's table), then
        /// of the bodies' keys, then of kinds, then of colliders' slots: independent of workers, processors and where
        /// bodies lie in memory. Bodies that share a key are in order of their slots. Contact is looked at after each
        /// substep, and ends only at the end of a step: what bounces within one begins once. What touches and leaves
        /// within a step begins and ends in it. A body at rest still touches what it lies on. Of a body that ends there
        /// is one <see cref="ContactEventKind.BodyKilled"/> and nothing else, but
        /// <see cref="ContactEventKind.BodyFaulted"/> where that is why; of those destroyed by
        /// <see cref="Native.lr_body_destroy"/> there is nothing. At most four colliders of a body count, those that
        /// press it most; other bodies that it touches count as one of the four, and neither begin nor end. A body that
        /// comes to rest on other bodies has landed.</summary>
        /// <param name="world">the world</param>
        /// <param name="list">initialised, or with struct_size set.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>,
        /// <see cref="Status.StructSize"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_get_contact_events(IntPtr world, ContactEventList* list);
    }
}
