// SPDX-License-Identifier: MIT
// Written by bindings/generator/csharp.py from include/langevin_rigid.h: do not edit.
using System;
using System.Runtime.InteropServices;

namespace LangevinRigid
{
    public static unsafe partial class Native
    {
        /// <summary>Fills a struct with its initial values; <c>Ray.Create()</c> does it with the right size.</summary>
        /// <param name="ray">ray</param>
        /// <param name="structSize">sizeof the struct in the caller's header</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_ray_init(Ray* ray, uint structSize);

        /// <summary>Finds the first hit of each ray. Bodies have their contact shape, the hull of their asset or an
        /// ellipsoid (docs/maintainers/contact.md); bodies of waiting batches (<see cref="Native.lr_batch_set_rate"/>)
        /// are where they were last stepped. Planes and heightfields are solid below their surface; meshes are hit from
        /// both sides. Colliders are where the last step or <see cref="Native.lr_collider_move"/> put them. Hits at
        /// equal distances are sorted: bodies before colliders, then by batch and noise seed or by collider
        /// slot.</summary>
        /// <param name="world">the world</param>
        /// <param name="rays"><paramref name="count"/> elements.</param>
        /// <param name="count">number of elements</param>
        /// <param name="hits">receives <paramref name="count"/> elements; none are written after an error.</param>
        /// <returns><see cref="Status.Ok"/> (also for count 0), <see cref="Status.NullArgument"/>,
        /// <see cref="Status.StructSize"/>, <see cref="Status.NotFinite"/>, <see cref="Status.InvalidArgument"/>,
        /// <see cref="Status.StaleBatch"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_ray_cast(IntPtr world, Ray* rays, uint count, RayHit* hits);

        /// <summary>Fills a struct with its initial values; <c>OverlapDesc.Create()</c> does it with the right size.</summary>
        /// <param name="desc">initialised by its <c>_init</c> function, or with struct_size set</param>
        /// <param name="structSize">sizeof the struct in the caller's header</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_overlap_desc_init(OverlapDesc* desc, uint structSize);

        /// <summary>Finds all bodies that overlap a sphere or box, sorted by batch, noise seed and slot. Shapes and
        /// places of bodies are as for rays.</summary>
        /// <param name="world">the world</param>
        /// <param name="desc">initialised by its <c>_init</c> function, or with struct_size set</param>
        /// <param name="bodies">room for <paramref name="capacity"/> ids; may be null when capacity is 0.</param>
        /// <param name="capacity">number of elements that fit</param>
        /// <param name="count">receives how many there are.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.StructSize"/>,
        /// <see cref="Status.NotFinite"/>, <see cref="Status.InvalidArgument"/>, <see cref="Status.StaleBatch"/>,
        /// <see cref="Status.BufferTooSmall"/>: *count is set, and the contents of <paramref name="bodies"/> are
        /// undefined.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_overlap(IntPtr world, OverlapDesc* desc, BodyId* bodies, uint capacity, uint* count);
    }
}
