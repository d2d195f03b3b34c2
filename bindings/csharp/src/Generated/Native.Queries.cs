// SPDX-License-Identifier: MIT
// Written by bindings/generator/csharp.py from include/langevin_rigid.h: change those.
using System;
using System.Runtime.InteropServices;

namespace LangevinRigid
{
    public static unsafe partial class Native
    {
        /// <summary>Fills a struct with its initial values; <c>Ray.Create()</c> does it with the right size.</summary>
        /// <param name="ray">ray</param>
        /// <param name="structSize">sizeof the struct as the caller sees it</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_ray_init(Ray* ray, uint structSize);

        /// <summary>What each ray hits first. Bodies are what can touch colliders of them: the hull of their asset, or
        /// an ellipsoid (docs/maintainers/contact.md); those of batches that wait
        /// (<see cref="Native.lr_batch_set_rate"/>) are where they were stepped last. Planes and heightfields are solid
        /// below their surface, meshes are met from both sides. Colliders are where the last step or
        /// <see cref="Native.lr_collider_move"/> has put them. Of equal distances bodies come before colliders, then
        /// the order is that of batches and keys, or of colliders' slots.</summary>
        /// <param name="world">the world</param>
        /// <param name="rays"><paramref name="count"/> elements.</param>
        /// <param name="count">elements of the arrays</param>
        /// <param name="hits">receives <paramref name="count"/> elements.</param>
        /// <returns><see cref="Status.Ok"/> (also for count 0), <see cref="Status.NullArgument"/>,
        /// <see cref="Status.StructSize"/>, <see cref="Status.NotFinite"/>, <see cref="Status.InvalidArgument"/>,
        /// <see cref="Status.StaleBatch"/>: then no hit is written.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_ray_cast(IntPtr world, Ray* rays, uint count, RayHit* hits);

        /// <summary>Fills a struct with its initial values; <c>OverlapDesc.Create()</c> does it with the right size.</summary>
        /// <param name="desc">initialised by its <c>_init</c> function, or with struct_size set</param>
        /// <param name="structSize">sizeof the struct as the caller sees it</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_overlap_desc_init(OverlapDesc* desc, uint structSize);

        /// <summary>All bodies of which a part is in a sphere or box, in order of batches, then keys, then slots. They
        /// are the same as for rays.</summary>
        /// <param name="world">the world</param>
        /// <param name="desc">initialised by its <c>_init</c> function, or with struct_size set</param>
        /// <param name="bodies">room for <paramref name="capacity"/> ids; may be null when that is 0.</param>
        /// <param name="capacity">elements that there is room for</param>
        /// <param name="count">receives how many there are.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.StructSize"/>,
        /// <see cref="Status.NotFinite"/>, <see cref="Status.InvalidArgument"/>, <see cref="Status.StaleBatch"/>,
        /// <see cref="Status.BufferTooSmall"/>: *count is set, and <paramref name="bodies"/> holds no
        /// meaning.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_overlap(IntPtr world, OverlapDesc* desc, BodyId* bodies, uint capacity, uint* count);
    }
}
