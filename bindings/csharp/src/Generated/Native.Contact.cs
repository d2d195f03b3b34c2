// SPDX-License-Identifier: MIT
// Written by bindings/generator/csharp.py from include/langevin_rigid.h: change those.
using System;
using System.Runtime.InteropServices;

namespace LangevinRigid
{
    public static unsafe partial class Native
    {
        /// <summary>Fills a struct with its initial values; <c>ColliderDesc.Create()</c> does it with the right size.</summary>
        /// <param name="desc">initialised by its <c>_init</c> function, or with struct_size set</param>
        /// <param name="structSize">sizeof the struct as the caller sees it</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_collider_desc_init(ColliderDesc* desc, uint structSize);

        /// <summary>Creates <paramref name="count"/> colliders, all or none. They are there from the next step on.
        /// Hulls, heightfields and meshes that are equal share one copy of their data.</summary>
        /// <param name="world">the world</param>
        /// <param name="descs"><paramref name="count"/> elements.</param>
        /// <param name="count">elements of the arrays</param>
        /// <param name="outIds">receives <paramref name="count"/> ids; may be null.</param>
        /// <returns><see cref="Status.Ok"/> (also for count 0), <see cref="Status.NullArgument"/> (also arrays that the
        /// kind needs), <see cref="Status.StructSize"/>, <see cref="Status.NotFinite"/>,
        /// <see cref="Status.InvalidArgument"/> (also a hull that is flat: thinner than 1e-4 of its largest extent; a
        /// mesh with an index out of range, or no triangle with an area), <see cref="Status.Capacity"/>,
        /// <see cref="Status.OutOfMemory"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_collider_create(IntPtr world, ColliderDesc* descs, uint count, ColliderId* outIds);

        /// <summary>Destroys <paramref name="count"/> colliders, all or none: if one of them is stale, or given twice,
        /// nothing is destroyed.</summary>
        /// <param name="world">the world</param>
        /// <param name="colliders"><paramref name="count"/> handles of colliders</param>
        /// <param name="count">elements of the arrays</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>,
        /// <see cref="Status.StaleCollider"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_collider_destroy(IntPtr world, ColliderId* colliders, uint count);

        /// <summary>Fills a struct with its initial values; <c>ColliderMotion.Create()</c> does it with the right size.</summary>
        /// <param name="motion">motion</param>
        /// <param name="structSize">sizeof the struct as the caller sees it</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_collider_motion_init(ColliderMotion* motion, uint structSize);

        /// <summary>Moves <paramref name="count"/> colliders, all or none, in this order: of several motions of one
        /// collider the last holds. Planes that turn keep all bodies of the world from the fast path while they
        /// do.</summary>
        /// <param name="world">the world</param>
        /// <param name="motions">motions</param>
        /// <param name="count">elements of the arrays</param>
        /// <returns><see cref="Status.Ok"/> (also for count 0), <see cref="Status.NullArgument"/>,
        /// <see cref="Status.StructSize"/>, <see cref="Status.StaleCollider"/>, <see cref="Status.NotFinite"/>,
        /// <see cref="Status.InvalidArgument"/>, <see cref="Status.OutOfMemory"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_collider_move(IntPtr world, ColliderMotion* motions, uint count);

        /// <summary>Fills a struct with its initial values; <c>ColliderState.Create()</c> does it with the right size.</summary>
        /// <param name="state">state</param>
        /// <param name="structSize">sizeof the struct as the caller sees it</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_collider_state_init(ColliderState* state, uint structSize);

        /// <summary><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.StaleCollider"/>,
        /// <see cref="Status.StructSize"/>.</summary>
        /// <param name="world">the world</param>
        /// <param name="collider">a collider's handle</param>
        /// <param name="state">initialised, or with struct_size set.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.StaleCollider"/>,
        /// <see cref="Status.StructSize"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_collider_get_state(IntPtr world, ColliderId collider, ColliderState* state);

        /// <summary>Fills a struct with its initial values; <c>ColliderSurface.Create()</c> does it with the right size.</summary>
        /// <param name="surface">surface</param>
        /// <param name="structSize">sizeof the struct as the caller sees it</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_collider_surface_init(ColliderSurface* surface, uint structSize);

        /// <summary>Gives <paramref name="count"/> colliders the same surface, all or none, from the next step
        /// on.</summary>
        /// <param name="world">the world</param>
        /// <param name="colliders"><paramref name="count"/> handles of colliders</param>
        /// <param name="count">elements of the arrays</param>
        /// <param name="surface">surface</param>
        /// <returns><see cref="Status.Ok"/> (also for count 0), <see cref="Status.NullArgument"/>,
        /// <see cref="Status.StaleCollider"/>, <see cref="Status.StructSize"/>, <see cref="Status.NotFinite"/>,
        /// <see cref="Status.InvalidArgument"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_collider_set_surface(IntPtr world, ColliderId* colliders, uint count, ColliderSurface* surface);

        /// <summary>Fills a struct with its initial values; <c>BatchContact.Create()</c> does it with the right size.</summary>
        /// <param name="contact">contact</param>
        /// <param name="structSize">sizeof the struct as the caller sees it</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_batch_contact_init(BatchContact* contact, uint structSize);

        /// <summary>From the next step on; copied. Null is what a batch has initially. Wakes the batch's bodies at
        /// rest. Part of snapshots.</summary>
        /// <param name="world">the world</param>
        /// <param name="batch">handle of a batch of the world</param>
        /// <param name="contact">contact</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/> (world),
        /// <see cref="Status.StaleBatch"/>, <see cref="Status.StructSize"/>, <see cref="Status.NotFinite"/>,
        /// <see cref="Status.InvalidArgument"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_batch_set_contact(IntPtr world, BatchId batch, BatchContact* contact);

        /// <summary><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.StaleBatch"/>,
        /// <see cref="Status.StructSize"/>.</summary>
        /// <param name="world">the world</param>
        /// <param name="batch">handle of a batch of the world</param>
        /// <param name="contact">initialised, or with struct_size set.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.StaleBatch"/>,
        /// <see cref="Status.StructSize"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_batch_get_contact(IntPtr world, BatchId batch, BatchContact* contact);

        /// <summary>Whether bodies of <paramref name="a"/> and of <paramref name="b"/> meet each other, from the next
        /// step on; their order does not matter, and a == b are the bodies of one batch among themselves. Initially
        /// none do. Friction, restitution and rolling resistance are those of <see cref="BatchContact"/>: of a pair,
        /// friction is the geometric mean of both and restitution the larger. Layers are for colliders alone. Bodies of
        /// batches that are stepped at different rates (<see cref="Native.lr_batch_set_rate"/>), or wait for a budget,
        /// meet only while one of both is at rest. A change wakes the bodies at rest of both batches, and the end of
        /// one batch those of the other. Part of snapshots. The first pair of a batch takes 28 bytes for each of its
        /// capacity, and up to 75 more unless there have been colliders. docs/maintainers/contact.md</summary>
        /// <param name="world">the world</param>
        /// <param name="a">handle of a batch of the world</param>
        /// <param name="b">handle of a batch of the world</param>
        /// <param name="enabled">0 or 1.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/> (world), <see cref="Status.StaleBatch"/>
        /// (either), <see cref="Status.InvalidArgument"/> (enabled), <see cref="Status.OutOfMemory"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_batch_set_pair_contact(IntPtr world, BatchId a, BatchId b, int enabled);

        /// <summary><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.StaleBatch"/>
        /// (either).</summary>
        /// <param name="world">the world</param>
        /// <param name="a">handle of a batch of the world</param>
        /// <param name="b">handle of a batch of the world</param>
        /// <param name="enabled">receives 0 or 1; unchanged after an error.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.StaleBatch"/>
        /// (either).</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_batch_get_pair_contact(IntPtr world, BatchId a, BatchId b, int* enabled);
    }
}
