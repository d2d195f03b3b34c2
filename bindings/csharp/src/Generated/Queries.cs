// SPDX-License-Identifier: MIT
// Written by bindings/generator/csharp.py from include/langevin_rigid.h: do not edit.
using System;
using System.Runtime.InteropServices;

namespace LangevinRigid
{
    /// <summary>Targets of a ray.</summary>
    [Flags]
    public enum RayFlags : uint
    {
        /// <summary>No bit.</summary>
        None = 0,
        /// <summary>The header's <c>LR_RAY_BODIES</c>.</summary>
        Bodies = 1,
        /// <summary>The header's <c>LR_RAY_COLLIDERS</c>.</summary>
        Colliders = 2,
    }

    /// <summary>Shapes of overlap queries.</summary>
    public enum OverlapShape : int
    {
        /// <summary>Size[0]: radius.</summary>
        Sphere = 1,
        /// <summary>Size: half extents along its own axes.</summary>
        Box = 2,
    }

    /// <summary>The header's <c>struct lr_ray</c>.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct Ray
    {
        /// <summary>Size of the struct in bytes, set by <c>Create</c>. Equal in all elements of an array: also the
        /// array's stride.</summary>
        public uint StructSize;
        /// <summary><see cref="RayFlags"/>: what it can hit; default both</summary>
        public RayFlags Flags;
        /// <summary>m, up to 1e9 in magnitude; default 0</summary>
        public Float3 Origin;
        /// <summary>any length from 1e-6 to 1e6; default 0, -1, 0</summary>
        public Float3 Direction;
        /// <summary>m, 0 to 1e9; default 1e9</summary>
        public float MaxDistance;
        /// <summary>hits bodies of this batch only; default id 0: of all batches</summary>
        public BatchId Batch;
        /// <summary>bits: hits colliders that share at least one; default all</summary>
        public uint ColliderLayers;
        /// <summary>0.</summary>
        public uint Reserved;

        /// <summary>A struct with its initial values and its size.</summary>
        public static Ray Create()
        {
            var value = default(Ray);
            LangevinLibrary.EnsureLoaded();
            LangevinException.Check(Native.lr_ray_init(&value, (uint)sizeof(Ray)), "lr_ray_init");
            return value;
        }
    }

    /// <summary>The first hit of a ray, all 0 if there is none: 56 bytes in arrays without gaps. This struct never
    /// changes after 0.2.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct RayHit
    {
        /// <summary>id 0: it hit a collider</summary>
        public BodyId Body;
        /// <summary>the body's: <see cref="BodyDesc.User"/></summary>
        public ulong User;
        /// <summary>id 0: it hit a body</summary>
        public ColliderId Collider;
        /// <summary>m, from the ray's origin</summary>
        public float Distance;
        /// <summary>m, world frame</summary>
        public Float3 Position;
        /// <summary>unit, world frame, outward. If the ray starts inside: against the ray, at distance 0</summary>
        public Float3 Normal;
        /// <summary>0.</summary>
        public uint Reserved;
    }

    /// <summary>The header's <c>struct lr_overlap_desc</c>.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct OverlapDesc
    {
        /// <summary>Size of the struct in bytes, set by <c>Create</c>.</summary>
        public uint StructSize;
        /// <summary><see cref="OverlapShape"/>; default <see cref="OverlapShape.Sphere"/></summary>
        public OverlapShape Shape;
        /// <summary>m, of its centre, up to 1e9 in magnitude; default 0</summary>
        public Float3 Position;
        /// <summary>of a box, x y z w, normalised by the call; default 0 0 0 1</summary>
        public Float4 Orientation;
        /// <summary>m, &gt; 0, up to 1e6; default 1</summary>
        public Float3 Size;
        /// <summary>finds bodies of this batch only; default id 0: of all batches</summary>
        public BatchId Batch;
        /// <summary>0.</summary>
        public uint Reserved;

        /// <summary>A struct with its initial values and its size.</summary>
        public static OverlapDesc Create()
        {
            var value = default(OverlapDesc);
            LangevinLibrary.EnsureLoaded();
            LangevinException.Check(Native.lr_overlap_desc_init(&value, (uint)sizeof(OverlapDesc)), "lr_overlap_desc_init");
            return value;
        }
    }
}
