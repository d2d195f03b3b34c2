// SPDX-License-Identifier: MIT
// Written by bindings/generator/csharp.py from include/langevin_rigid.h: do not edit.
using System;
using System.Runtime.InteropServices;

namespace LangevinRigid
{
    public static unsafe partial class Native
    {
        /// <summary>Fills a struct with its initial values; <c>ColliderDesc.Create()</c> does it with the right size.</summary>
        /// <param name="desc">initialised by its <c>_init</c> function, or with struct_size set</param>
        /// <param name="structSize">sizeof the struct in the caller's header</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_collider_desc_init(ColliderDesc* desc, uint structSize);

        /// <summary>Creates <paramref name="count"/> colliders, all or none, which collide from the next step on. Equal
        /// hulls, heightfields and meshes share one copy of their data.</summary>
        /// <param name="world">the world</param>
        /// <param name="descs"><paramref name="count"/> elements.</param>
        /// <param name="count">number of elements</param>
        /// <param name="outIds">receives <paramref name="count"/> handles; may be null.</param>
        /// <returns><see cref="Status.Ok"/> (also for count 0), <see cref="Status.NullArgument"/> (also for arrays that
        /// the kind needs), <see cref="Status.StructSize"/>, <see cref="Status.NotFinite"/>,
        /// <see cref="Status.InvalidArgument"/> (also for a flat hull, thinner than 1e-4 of its largest extent, and for
        /// a mesh with an index out of range or no triangle with an area), <see cref="Status.Capacity"/>,
        /// <see cref="Status.OutOfMemory"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_collider_create(IntPtr world, ColliderDesc* descs, uint count, ColliderId* outIds);

        /// <summary>Destroys <paramref name="count"/> colliders, all or none: a stale or repeated handle fails the
        /// call.</summary>
        /// <param name="world">the world</param>
        /// <param name="colliders"><paramref name="count"/> handles of colliders</param>
        /// <param name="count">number of elements</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>,
        /// <see cref="Status.StaleCollider"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_collider_destroy(IntPtr world, ColliderId* colliders, uint count);

        /// <summary>Returns 1 if the collider exists in this world, else 0. Never an error: see
        /// <see cref="Native.lr_body_is_valid"/>.</summary>
        /// <param name="world">the world</param>
        /// <param name="collider">handle of a collider</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern int lr_collider_is_valid(IntPtr world, ColliderId collider);

        /// <summary>Fills a struct with its initial values; <c>ColliderMotion.Create()</c> does it with the right size.</summary>
        /// <param name="motion">motion</param>
        /// <param name="structSize">sizeof the struct in the caller's header</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_collider_motion_init(ColliderMotion* motion, uint structSize);

        /// <summary>Moves <paramref name="count"/> colliders, all or none, in order: the last motion of a collider
        /// wins. While a plane rotates, no body of the world can use the fast path.</summary>
        /// <param name="world">the world</param>
        /// <param name="motions">motions</param>
        /// <param name="count">number of elements</param>
        /// <returns><see cref="Status.Ok"/> (also for count 0), <see cref="Status.NullArgument"/>,
        /// <see cref="Status.StructSize"/>, <see cref="Status.StaleCollider"/>, <see cref="Status.NotFinite"/>,
        /// <see cref="Status.InvalidArgument"/>, <see cref="Status.OutOfMemory"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_collider_move(IntPtr world, ColliderMotion* motions, uint count);

        /// <summary>Fills a struct with its initial values; <c>ColliderState.Create()</c> does it with the right size.</summary>
        /// <param name="state">state</param>
        /// <param name="structSize">sizeof the struct in the caller's header</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_collider_state_init(ColliderState* state, uint structSize);

        /// <summary>Reads the state of a collider.</summary>
        /// <param name="world">the world</param>
        /// <param name="collider">handle of a collider</param>
        /// <param name="state">initialised, or with struct_size set.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.StaleCollider"/>,
        /// <see cref="Status.StructSize"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_collider_get_state(IntPtr world, ColliderId collider, ColliderState* state);

        /// <summary>Fills a struct with its initial values; <c>ColliderMaterial.Create()</c> does it with the right size.</summary>
        /// <param name="material">material</param>
        /// <param name="structSize">sizeof the struct in the caller's header</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_material_init(ColliderMaterial* material, uint structSize);

        /// <summary>Sets one material for <paramref name="count"/> colliders, all or none, from the next step on. A
        /// change wakes bodies asleep on them.</summary>
        /// <param name="world">the world</param>
        /// <param name="colliders"><paramref name="count"/> handles of colliders</param>
        /// <param name="count">number of elements</param>
        /// <param name="material">material</param>
        /// <returns><see cref="Status.Ok"/> (also for count 0), <see cref="Status.NullArgument"/>,
        /// <see cref="Status.StaleCollider"/>, <see cref="Status.StructSize"/>, <see cref="Status.NotFinite"/>,
        /// <see cref="Status.InvalidArgument"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_collider_set_material(IntPtr world, ColliderId* colliders, uint count, ColliderMaterial* material);

        /// <summary>Fills a struct with its initial values; <c>BatchContact.Create()</c> does it with the right size.</summary>
        /// <param name="contact">contact</param>
        /// <param name="structSize">sizeof the struct in the caller's header</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_batch_contact_init(BatchContact* contact, uint structSize);

        /// <summary>Sets how a batch collides from the next step on. The struct is copied; null restores the defaults.
        /// Wakes the batch's sleeping bodies. Part of snapshots.</summary>
        /// <param name="world">the world</param>
        /// <param name="batch">handle of a batch of the world</param>
        /// <param name="contact">contact</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/> (world),
        /// <see cref="Status.StaleBatch"/>, <see cref="Status.StructSize"/>, <see cref="Status.NotFinite"/>,
        /// <see cref="Status.InvalidArgument"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_batch_set_contact(IntPtr world, BatchId batch, BatchContact* contact);

        /// <summary>Reads how a batch collides.</summary>
        /// <param name="world">the world</param>
        /// <param name="batch">handle of a batch of the world</param>
        /// <param name="contact">initialised, or with struct_size set.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.StaleBatch"/>,
        /// <see cref="Status.StructSize"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_batch_get_contact(IntPtr world, BatchId batch, BatchContact* contact);

        /// <summary>Turns body contact on or off from the next step on: collisions between bodies of
        /// <paramref name="a"/> and bodies of <paramref name="b"/>, in either order. Pass the same batch twice for
        /// collisions within it. Off by default. Contacts use friction, restitution and rolling resistance of
        /// <see cref="BatchContact"/>, combined as there; layers apply to colliders only. Bodies of batches stepped at
        /// different rates (<see cref="Native.lr_batch_set_rate"/>), or waiting for the budget, collide only while one
        /// of the two is asleep. A change wakes the sleeping bodies of both batches. Part of snapshots. A batch's first
        /// pair allocates 28 bytes for each body of its capacity, and up to 75 more if the world has never had
        /// colliders. docs/maintainers/contact.md.</summary>
        /// <param name="world">the world</param>
        /// <param name="a">handle of a batch of the world</param>
        /// <param name="b">handle of a batch of the world</param>
        /// <param name="enabled">0 or 1.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/> (world), <see cref="Status.StaleBatch"/>
        /// (either), <see cref="Status.InvalidArgument"/> (enabled), <see cref="Status.OutOfMemory"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_batch_set_body_contact(IntPtr world, BatchId a, BatchId b, int enabled);

        /// <summary>Reads whether bodies of two batches collide.</summary>
        /// <param name="world">the world</param>
        /// <param name="a">handle of a batch of the world</param>
        /// <param name="b">handle of a batch of the world</param>
        /// <param name="enabled">receives 0 or 1; unchanged after an error.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.StaleBatch"/>
        /// (either).</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_batch_get_body_contact(IntPtr world, BatchId a, BatchId b, int* enabled);
    }
}
