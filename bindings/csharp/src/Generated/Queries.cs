// SPDX-License-Identifier: MIT
// Written by bindings/generator/csharp.py from include/langevin_rigid.h: change those.
using System;
using System.Runtime.InteropServices;

namespace LangevinRigid
{
    /// <summary>What a ray can hit.</summary>
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
        /// <summary>Size of the struct in bytes, set by <c>Create</c>. The same in all elements of an array: it is the
        /// array's stride.</summary>
        public uint StructSize;
        /// <summary><see cref="RayFlags"/>, what it can hit; initially both</summary>
        public RayFlags Flags;
        /// <summary>m, up to 1e9 in magnitude; initially 0</summary>
        public Float3 Origin;
        /// <summary>of any length from 1e-6 to 1e6; initially 0, -1, 0</summary>
        public Float3 Direction;
        /// <summary>m, 0 to 1e9; initially 1e9</summary>
        public float MaxDistance;
        /// <summary>whose bodies it can hit; initially 0: all</summary>
        public BatchId Batch;
        /// <summary>bits: it meets colliders that have one of them; initially all</summary>
        public uint ColliderLayers;
        /// <summary>0.</summary>
        public uint Reserved;

        /// <summary>One with its initial values and its size.</summary>
        public static Ray Create()
        {
            var value = default(Ray);
            LangevinLibrary.EnsureLoaded();
            LangevinException.Check(Native.lr_ray_init(&value, (uint)sizeof(Ray)), "lr_ray_init");
            return value;
        }
    }

    /// <summary>Never changes: 48 bytes, an element of arrays without gaps. All 0 where nothing is hit.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct RayHit
    {
        /// <summary>0 where it is a collider</summary>
        public BodyId Body;
        /// <summary>0 where it is a body</summary>
        public ColliderId Collider;
        /// <summary>m, from the ray's origin</summary>
        public float Distance;
        /// <summary>m, world frame</summary>
        public Float3 Position;
        /// <summary>unit, world frame, out of what is hit; against the ray where that begins inside, at distance
        /// 0</summary>
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
        /// <summary><see cref="OverlapShape"/>; initially <see cref="OverlapShape.Sphere"/></summary>
        public OverlapShape Shape;
        /// <summary>m, of its middle, up to 1e9 in magnitude; initially 0</summary>
        public Float3 Position;
        /// <summary>of a box, x y z w, normalised when taken; initially 0 0 0 1</summary>
        public Float4 Orientation;
        /// <summary>m, &gt; 0, up to 1e6; initially 1</summary>
        public Float3 Size;
        /// <summary>whose bodies are looked for; initially 0: all</summary>
        public BatchId Batch;
        /// <summary>0.</summary>
        public uint Reserved;

        /// <summary>One with its initial values and its size.</summary>
        public static OverlapDesc Create()
        {
            var value = default(OverlapDesc);
            LangevinLibrary.EnsureLoaded();
            LangevinException.Check(Native.lr_overlap_desc_init(&value, (uint)sizeof(OverlapDesc)), "lr_overlap_desc_init");
            return value;
        }
    }
}
