// SPDX-License-Identifier: MIT
using LangevinRigid;
using UnityEngine;

namespace LangevinUnity
{
    /// <summary>The mirror from coordinates of the baked mesh to those of the drawn mesh.</summary>
    public enum MeshMirror
    {
        /// <summary>Baked from a Unity mesh by the bake window, which negates z.</summary>
        Z = 0,
        /// <summary>Baked from the source file: Unity's importer negates x of FBX, OBJ and similar files.</summary>
        X = 1,
    }

    /// <summary>Converts between Unity's left-handed and the library's right-handed world, both in metres, by a mirror in z. A vector negates
    /// its z. A spin, torque or quaternion negates its x and y. The mirror is its own inverse.</summary>
    public static unsafe class LangevinConversion
    {
        /// <summary>Converts a position, velocity, force or direction to the library.</summary>
        public static Float3 ToLibrary(Vector3 v) { return new Float3(v.x, v.y, -v.z); }

        /// <summary>Converts a position, velocity, force or direction to Unity.</summary>
        public static Vector3 ToUnity(Float3 v) { return new Vector3(v.X, v.Y, -v.Z); }

        /// <summary>Converts an angular velocity or torque to the library: from the left-hand to the right-hand rule.</summary>
        public static Float3 SpinToLibrary(Vector3 w) { return new Float3(-w.x, -w.y, w.z); }

        /// <summary>Converts an angular velocity or torque to Unity.</summary>
        public static Vector3 SpinToUnity(Float3 w) { return new Vector3(-w.X, -w.Y, w.Z); }

        /// <summary>Converts an orientation to the library.</summary>
        public static Float4 ToLibrary(Quaternion q) { return new Float4(-q.x, -q.y, q.z, q.w); }

        /// <summary>Converts an orientation to Unity.</summary>
        public static Quaternion ToUnity(Float4 q) { return new Quaternion(-q.X, -q.Y, q.Z, q.W); }

        /// <summary>Converts the orientation of a drawn mesh to that of its body in the library. Mirrors in x and in z differ by half a turn about
        /// y.</summary>
        public static Float4 ToLibrary(Quaternion q, MeshMirror mirror)
        {
            return ToLibrary(mirror == MeshMirror.X ? new Quaternion(q.z, -q.w, -q.x, q.y) : q);
        }

        /// <summary>Converts a body's orientation in the library to that of its drawn mesh.</summary>
        public static Quaternion ToUnity(Float4 orientation, MeshMirror mirror)
        {
            Quaternion q = ToUnity(orientation);
            return mirror == MeshMirror.X ? new Quaternion(-q.z, q.w, q.x, -q.y) : q;
        }

        /// <summary>Converts lengths along axes (half extents, semi-axes), which a mirror does not change.</summary>
        public static Float3 SizeToLibrary(Vector3 s) { return new Float3(s.x, s.y, s.z); }

        /// <summary>Mirrors a mesh and reverses the order of each triangle, so that its outside stays outside.</summary>
        public static void MeshToLibrary(Vector3[] vertices, int[] triangles, Float3[] outVertices, uint[] outIndices)
        {
            for (int i = 0; i < vertices.Length; ++i) outVertices[i] = ToLibrary(vertices[i]);
            for (int i = 0; i + 2 < triangles.Length; i += 3)
            {
                outIndices[i] = (uint)triangles[i];
                outIndices[i + 1] = (uint)triangles[i + 2];
                outIndices[i + 2] = (uint)triangles[i + 1];
            }
        }

        /// <summary>Converts column-major matrices of the library to Unity's, in place. The library's matrices map points about the centre of mass
        /// to its world; Unity's map points of the drawn mesh to its own: S A B p + S (t - A c).</summary>
        /// <param name="matrices">The first of `count` matrices.</param>
        /// <param name="count">The number of matrices.</param>
        /// <param name="rows">Rows of a column: 4 for Matrix4x4, 3 for packed matrices.</param>
        /// <param name="center">Centre of mass in the frame of the baked mesh.</param>
        /// <param name="mirror">The mirror from the baked to the drawn mesh.</param>
        public static void MatricesToUnity(float* matrices, int count, int rows, Float3 center, MeshMirror mirror)
        {
            float bx = mirror == MeshMirror.X ? -1.0f : 1.0f;
            float bz = mirror == MeshMirror.Z ? -1.0f : 1.0f;
            for (int i = 0; i < count; ++i)
            {
                float* x = matrices + (long)i * 4 * rows;
                float* y = x + rows;
                float* z = y + rows;
                float* t = z + rows;
                t[0] -= x[0] * center.X + y[0] * center.Y + z[0] * center.Z;
                t[1] -= x[1] * center.X + y[1] * center.Y + z[1] * center.Z;
                t[2] = -(t[2] - (x[2] * center.X + y[2] * center.Y + z[2] * center.Z));
                x[0] *= bx;
                x[1] *= bx;
                x[2] *= -bx;
                y[2] = -y[2];
                z[0] *= bz;
                z[1] *= bz;
                z[2] *= -bz;
            }
        }

        /// <summary>Inverts packed matrices of rotation (or mirror), uniform scale and translation.</summary>
        public static void InvertPacked(float* matrices, float* inverses, int count)
        {
            for (int i = 0; i < count; ++i)
            {
                float* m = matrices + (long)i * 12;
                float* n = inverses + (long)i * 12;
                float squared = m[0] * m[0] + m[1] * m[1] + m[2] * m[2];
                float k = squared > 0.0f ? 1.0f / squared : 0.0f;
                for (int row = 0; row < 3; ++row)
                {
                    float* column = m + 3 * row;
                    n[row] = column[0] * k;
                    n[3 + row] = column[1] * k;
                    n[6 + row] = column[2] * k;
                    n[9 + row] = -(n[row] * m[9] + n[3 + row] * m[10] + n[6 + row] * m[11]);
                }
            }
        }
    }
}
