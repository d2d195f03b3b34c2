// SPDX-License-Identifier: MIT
using System;
using LangevinRigid;
using UnityEngine;

namespace LangevinUnity
{
    /// <summary>A Unity collider in the library's terms: kind, size, data, and its frame relative to the transform.</summary>
    internal sealed class LangevinShape
    {
        public ColliderKind Kind;
        public Float3 Size;
        /// <summary>Origin of the frame, in the transform's axes without its scale.</summary>
        public Vector3 Offset;
        /// <summary>Rotation of the frame in the transform's axes.</summary>
        public Quaternion Turn = Quaternion.identity;
        /// <summary>A terrain ignores rotation and scale of its transform.</summary>
        public bool AxisAligned;
        public Float3[] Vertices;
        public uint[] Indices;
        public float[] Heights;
        public UInt2 Counts;
        public Float2 Spacing;
        /// <summary>Identifies the source: another collider size or mesh gives another shape.</summary>
        public int Key;

        /// <summary>The frame's position in Unity's world.</summary>
        public Vector3 PositionOf(Transform at) { return AxisAligned ? at.position + Offset : at.position + at.rotation * Offset; }

        /// <summary>The frame's orientation in Unity's world.</summary>
        public Quaternion RotationOf(Transform at) { return AxisAligned ? Quaternion.identity : at.rotation * Turn; }
    }

    /// <summary>Reads Unity's colliders.</summary>
    internal static class LangevinColliderShapes
    {
        /// <summary>A number that changes with the shape.</summary>
        public static int KeyOf(Collider collider)
        {
            int key = collider.transform.lossyScale.GetHashCode();
            var box = collider as BoxCollider;
            if (box != null) return Mix(key, box.center.GetHashCode(), box.size.GetHashCode());
            var sphere = collider as SphereCollider;
            if (sphere != null) return Mix(key, sphere.center.GetHashCode(), sphere.radius.GetHashCode());
            var capsule = collider as CapsuleCollider;
            if (capsule != null)
                return Mix(Mix(key, capsule.center.GetHashCode(), capsule.radius.GetHashCode()), capsule.height.GetHashCode(), capsule.direction);
            var mesh = collider as MeshCollider;
            if (mesh != null) return Mix(key, mesh.sharedMesh == null ? 0 : mesh.sharedMesh.GetHashCode(), mesh.convex ? 1 : 0);
            var terrain = collider as TerrainCollider;
            TerrainData data = terrain == null ? null : terrain.terrainData;
            return data == null ? 0 : Mix(17, data.GetHashCode(), data.size.GetHashCode());
        }

        private static int Mix(int a, int b, int c) { return unchecked((a * 397 ^ b) * 397 ^ c); }

        /// <summary>The shape; throws an ArgumentException with the reason if the collider has none.</summary>
        public static LangevinShape Of(Collider collider)
        {
            LangevinShape shape = Read(collider);
            shape.Key = KeyOf(collider);
            return shape;
        }

        private static LangevinShape Read(Collider collider)
        {
            Vector3 scale = collider.transform.lossyScale;
            var size = new Vector3(Mathf.Abs(scale.x), Mathf.Abs(scale.y), Mathf.Abs(scale.z));
            var box = collider as BoxCollider;
            if (box != null)
                return new LangevinShape
                {
                    Kind = ColliderKind.Box,
                    Offset = Vector3.Scale(box.center, scale),
                    Size = LangevinConversion.SizeToLibrary(Vector3.Scale(box.size, size) * 0.5f),
                };
            var sphere = collider as SphereCollider;
            if (sphere != null) return Sphere(Vector3.Scale(sphere.center, scale), sphere.radius * Mathf.Max(size.x, Mathf.Max(size.y, size.z)));
            var capsule = collider as CapsuleCollider;
            if (capsule != null) return Capsule(capsule, scale, size);
            var mesh = collider as MeshCollider;
            if (mesh != null) return MeshOf(mesh, scale);
            var terrain = collider as TerrainCollider;
            if (terrain != null) return Terrain(terrain);
            throw new ArgumentException(collider.GetType().Name + " is not supported. Use Box, Sphere, Capsule, Mesh or Terrain.");
        }

        private static LangevinShape Sphere(Vector3 offset, float radius)
        {
            return new LangevinShape { Kind = ColliderKind.Sphere, Offset = offset, Size = new Float3(radius, 0.0f, 0.0f) };
        }

        // As in Unity's PhysX: height scales along the axis, the radius by the larger of the other two scales.
        private static LangevinShape Capsule(CapsuleCollider capsule, Vector3 scale, Vector3 size)
        {
            int axis = capsule.direction;
            float along = axis == 0 ? size.x : axis == 1 ? size.y : size.z;
            float across = axis == 0 ? Mathf.Max(size.y, size.z) : axis == 1 ? Mathf.Max(size.x, size.z) : Mathf.Max(size.x, size.y);
            float radius = capsule.radius * across;
            float half = capsule.height * along * 0.5f - radius;
            Vector3 offset = Vector3.Scale(capsule.center, scale);
            if (half < 1e-5f) return Sphere(offset, radius);
            // A capsule of the library lies along y.
            Quaternion turn = Quaternion.identity;
            if (axis == 0) turn = Quaternion.AngleAxis(90.0f, Vector3.forward);
            if (axis == 2) turn = Quaternion.AngleAxis(90.0f, Vector3.right);
            return new LangevinShape { Kind = ColliderKind.Capsule, Offset = offset, Turn = turn, Size = new Float3(radius, half, 0.0f) };
        }

        private static LangevinShape MeshOf(MeshCollider collider, Vector3 scale)
        {
            Mesh mesh = collider.sharedMesh;
            if (mesh == null) throw new ArgumentException("The MeshCollider has no mesh.");
            if (!mesh.isReadable)
                throw new ArgumentException("Mesh \"" + mesh.name + "\" is not readable. Turn on Read/Write in its import settings.");
            Vector3[] vertices = mesh.vertices;
            int[] triangles = mesh.triangles;
            var shape = new LangevinShape { Vertices = new Float3[vertices.Length], Indices = new uint[triangles.Length / 3 * 3] };
            for (int i = 0; i < vertices.Length; ++i) vertices[i] = Vector3.Scale(vertices[i], scale);
            LangevinConversion.MeshToLibrary(vertices, triangles, shape.Vertices, shape.Indices);
            shape.Kind = ColliderKind.Mesh;
            if (!collider.convex) return shape;
            shape.Kind = ColliderKind.Hull;
            shape.Indices = null;
            shape.Vertices = LangevinHullPoints.Reduce(shape.Vertices, (int)Limits.MaxHullVertices);
            return shape;
        }

        // Unity's terrain extends from its position along +x and +z. Mirrored, it begins at its far edge with its rows reversed.
        private static LangevinShape Terrain(TerrainCollider collider)
        {
            TerrainData data = collider.terrainData;
            if (data == null) throw new ArgumentException("The TerrainCollider has no terrain data.");
            int n = data.heightmapResolution;
            float[,] rows = data.GetHeights(0, 0, n, n);
            Vector3 size = data.size;
            var heights = new float[n * n];
            for (int z = 0; z < n; ++z)
                for (int x = 0; x < n; ++x) heights[(n - 1 - z) * n + x] = rows[z, x] * size.y;
            return new LangevinShape
            {
                Kind = ColliderKind.Heightfield,
                AxisAligned = true,
                Offset = new Vector3(0.0f, 0.0f, size.z),
                Heights = heights,
                Counts = new UInt2((uint)n, (uint)n),
                Spacing = new Float2(size.x / (n - 1), size.z / (n - 1)),
            };
        }
    }

    /// <summary>Reduces points to a few with nearly the same hull.</summary>
    internal static class LangevinHullPoints
    {
        /// <summary>All distinct points if they are at most `most`; otherwise the farthest points along evenly spread directions.</summary>
        public static Float3[] Reduce(Float3[] points, int most)
        {
            var different = new System.Collections.Generic.List<Float3>(new System.Collections.Generic.HashSet<Float3>(points));
            if (different.Count <= most) return different.ToArray();
            var kept = new System.Collections.Generic.HashSet<int>();
            double golden = Math.PI * (3.0 - Math.Sqrt(5.0));
            for (int k = 0; k < most; ++k)
            {
                double y = 1.0 - 2.0 * (k + 0.5) / most, r = Math.Sqrt(1.0 - y * y), a = golden * k;
                float dx = (float)(r * Math.Cos(a)), dy = (float)y, dz = (float)(r * Math.Sin(a));
                int best = 0;
                float far = float.NegativeInfinity;
                for (int i = 0; i < different.Count; ++i)
                {
                    float along = different[i].X * dx + different[i].Y * dy + different[i].Z * dz;
                    if (along > far) { far = along; best = i; }
                }
                kept.Add(best);
            }
            var reduced = new Float3[kept.Count];
            int at = 0;
            foreach (int i in kept) reduced[at++] = different[i];
            return reduced;
        }
    }
}
