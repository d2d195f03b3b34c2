// SPDX-License-Identifier: MIT
using System;
using LangevinRigid;
using NUnit.Framework;
using UnityEngine;

namespace LangevinUnity.Tests
{
    public sealed unsafe class ConversionTests
    {
        private static readonly Vector3 V = new Vector3(1.0f, 2.0f, 3.0f);
        private static readonly Vector3 W = new Vector3(-0.5f, 4.0f, 2.5f);

        private static void Near(Vector3 expected, Vector3 actual)
        {
            Assert.AreEqual(expected.x, actual.x, 2e-5, "x");
            Assert.AreEqual(expected.y, actual.y, 2e-5, "y");
            Assert.AreEqual(expected.z, actual.z, 2e-5, "z");
        }

        // Rotation in the library's right-handed convention, from the components alone.
        private static Float3 Turn(Float4 q, Float3 v)
        {
            double tx = 2.0 * (q.Y * v.Z - q.Z * v.Y), ty = 2.0 * (q.Z * v.X - q.X * v.Z), tz = 2.0 * (q.X * v.Y - q.Y * v.X);
            return new Float3((float)(v.X + q.W * tx + q.Y * tz - q.Z * ty), (float)(v.Y + q.W * ty + q.Z * tx - q.X * tz),
                (float)(v.Z + q.W * tz + q.X * ty - q.Y * tx));
        }

        [Test]
        public void VectorsMirrorInZ()
        {
            Assert.AreEqual(new Float3(1.0f, 2.0f, -3.0f), LangevinConversion.ToLibrary(V));
            Assert.AreEqual(V, LangevinConversion.ToUnity(LangevinConversion.ToLibrary(V)));
        }

        [Test]
        public void SpinsMirrorAsAxialVectors()
        {
            Assert.AreEqual(new Float3(0.5f, -4.0f, 2.5f), LangevinConversion.SpinToLibrary(W));
            Assert.AreEqual(W, LangevinConversion.SpinToUnity(LangevinConversion.SpinToLibrary(W)));
            // The velocity of a point of a spinning body is the same in both worlds.
            Float3 w = LangevinConversion.SpinToLibrary(W), r = LangevinConversion.ToLibrary(V);
            var v = new Float3(w.Y * r.Z - w.Z * r.Y, w.Z * r.X - w.X * r.Z, w.X * r.Y - w.Y * r.X);
            Near(Vector3.Cross(W, V), LangevinConversion.ToUnity(v));
        }

        [Test]
        public void QuaternionsTurnTheSameBodyTheSameWay()
        {
            Quaternion q = Quaternion.Euler(30.0f, -70.0f, 110.0f);
            Float4 p = LangevinConversion.ToLibrary(q);
            Near(q * V, LangevinConversion.ToUnity(Turn(p, LangevinConversion.ToLibrary(V))));
            Assert.AreEqual(1.0, Math.Abs(Quaternion.Dot(q, LangevinConversion.ToUnity(p))), 1e-6);
            // A quarter turn about y by the left-hand rule is a negative quarter turn by the right-hand rule.
            Float4 quarter = LangevinConversion.ToLibrary(Quaternion.AngleAxis(90.0f, Vector3.up));
            Assert.AreEqual(-Math.Sqrt(0.5), quarter.Y, 1e-6);
        }

        [Test]
        public void MeshesMirroredInXDifferByHalfATurn()
        {
            Quaternion q = Quaternion.Euler(20.0f, 40.0f, -65.0f);
            Float4 p = LangevinConversion.ToLibrary(q, MeshMirror.X);
            // A point of the baked mesh, and the same point of the drawn mesh: x negated.
            var baked = new Float3(1.0f, 2.0f, 3.0f);
            var drawn = new Vector3(-1.0f, 2.0f, 3.0f);
            Near(q * drawn, LangevinConversion.ToUnity(Turn(p, baked)));
            Assert.AreEqual(1.0, Math.Abs(Quaternion.Dot(q, LangevinConversion.ToUnity(p, MeshMirror.X))), 1e-6);
        }

        [Test]
        public void TrianglesKeepTheirOutside()
        {
            var vertices = new[] { Vector3.zero, new Vector3(0.0f, 0.0f, 1.0f), new Vector3(1.0f, 0.0f, 0.0f) };
            var points = new Float3[3];
            var indices = new uint[3];
            LangevinConversion.MeshToLibrary(vertices, new[] { 0, 1, 2 }, points, indices);
            // Unity: clockwise seen from outside, here from above.
            Assert.Greater(Vector3.Cross(vertices[1] - vertices[0], vertices[2] - vertices[0]).y, 0.0);
            Float3 a = points[indices[1]], b = points[indices[2]];
            Assert.Greater(a.Z * b.X - a.X * b.Z, 0.0, "right-handed: counter-clockwise seen from above");
        }

        // The expected place of a point of the drawn mesh, in steps: to the baked mesh, to the centre of mass, by the library, to Unity.
        private static Vector3 Expected(Vector3 p, MeshMirror mirror, Float3 center, Float4 q, float scale, Float3 at)
        {
            var baked = mirror == MeshMirror.X ? new Float3(-p.x, p.y, p.z) : new Float3(p.x, p.y, -p.z);
            Float3 turned = Turn(q, new Float3(scale * (baked.X - center.X), scale * (baked.Y - center.Y), scale * (baked.Z - center.Z)));
            return LangevinConversion.ToUnity(new Float3(turned.X + at.X, turned.Y + at.Y, turned.Z + at.Z));
        }

        private static void Matrices(MeshMirror mirror, int rows)
        {
            var center = new Float3(0.1f, -0.2f, 0.3f);
            var at = new Float3(5.0f, -6.0f, 7.0f);
            const float scale = 1.7f;
            Float4 q = LangevinConversion.ToLibrary(Quaternion.Euler(25.0f, 130.0f, -48.0f));
            float* m = stackalloc float[16];
            float* inverse = stackalloc float[12];
            Float3[] columns = { Turn(q, new Float3(scale, 0, 0)), Turn(q, new Float3(0, scale, 0)), Turn(q, new Float3(0, 0, scale)), at };
            for (int i = 0; i < 4; ++i)
            {
                m[i * rows] = columns[i].X;
                m[i * rows + 1] = columns[i].Y;
                m[i * rows + 2] = columns[i].Z;
                if (rows == 4) m[i * rows + 3] = i == 3 ? 1.0f : 0.0f;
            }
            LangevinConversion.MatricesToUnity(m, 1, rows, center, mirror);
            foreach (Vector3 p in new[] { Vector3.zero, V, W })
            {
                var got = new Vector3(m[0] * p.x + m[rows] * p.y + m[2 * rows] * p.z + m[3 * rows],
                    m[1] * p.x + m[rows + 1] * p.y + m[2 * rows + 1] * p.z + m[3 * rows + 1],
                    m[2] * p.x + m[rows + 2] * p.y + m[2 * rows + 2] * p.z + m[3 * rows + 2]);
                Near(Expected(p, mirror, center, q, scale, at), got);
                if (rows != 3) continue;
                LangevinConversion.InvertPacked(m, inverse, 1);
                Near(p, new Vector3(inverse[0] * got.x + inverse[3] * got.y + inverse[6] * got.z + inverse[9],
                    inverse[1] * got.x + inverse[4] * got.y + inverse[7] * got.z + inverse[10],
                    inverse[2] * got.x + inverse[5] * got.y + inverse[8] * got.z + inverse[11]));
            }
            // A proper rotation: instances keep their winding.
            var x = new Vector3(m[0], m[1], m[2]);
            var y = new Vector3(m[rows], m[rows + 1], m[rows + 2]);
            var z = new Vector3(m[2 * rows], m[2 * rows + 1], m[2 * rows + 2]);
            Assert.AreEqual(scale * scale * scale, Vector3.Dot(Vector3.Cross(x, y), z), 1e-4);
            if (rows == 4) Assert.AreEqual(1.0f, m[15]);
        }

        [Test]
        public void MatricesMirroredInZ() { Matrices(MeshMirror.Z, 4); }

        [Test]
        public void MatricesMirroredInX() { Matrices(MeshMirror.X, 4); }

        [Test]
        public void PackedMatricesAndInverses()
        {
            Matrices(MeshMirror.Z, 3);
            Matrices(MeshMirror.X, 3);
        }
    }
}
