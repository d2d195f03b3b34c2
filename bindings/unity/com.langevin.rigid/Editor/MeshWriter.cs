// SPDX-License-Identifier: MIT
using System;
using System.Globalization;
using System.IO;
using LangevinRigid;
using UnityEngine;

namespace LangevinUnity.Editor
{
    /// <summary>Writes a Unity mesh as OBJ for the baker, in the library's right-handed frame. It welds equal vertices: Unity splits a surface
    /// along seams of normals and texture coordinates, but the baker needs it closed.</summary>
    public static class MeshWriter
    {
        /// <summary>Writes the triangles of all submeshes. Throws an ArgumentException that names the problem of the mesh.</summary>
        public static void WriteObj(Mesh mesh, string path)
        {
            if (mesh == null) throw new ArgumentNullException("mesh");
            Vector3[] vertices = mesh.vertices;
            int[] triangles = mesh.triangles;
            if (vertices.Length == 0 || triangles.Length == 0)
                throw new ArgumentException("Mesh \"" + mesh.name + "\" has no triangles" +
                    (mesh.isReadable ? "." : ": turn on Read/Write in its import settings."));
            var points = new Float3[vertices.Length];
            var indices = new uint[triangles.Length];
            LangevinConversion.MeshToLibrary(vertices, triangles, points, indices);
            var index = new System.Collections.Generic.Dictionary<Float3, int>();
            var welded = new int[points.Length];
            using (var writer = new StreamWriter(path, false, new System.Text.UTF8Encoding(false)))
            {
                writer.NewLine = "\n";
                for (int i = 0; i < points.Length; ++i)
                {
                    int at;
                    if (!index.TryGetValue(points[i], out at))
                    {
                        at = index.Count + 1;
                        index.Add(points[i], at);
                        writer.WriteLine("v " + Number(points[i].X) + " " + Number(points[i].Y) + " " + Number(points[i].Z));
                    }
                    welded[i] = at;
                }
                for (int i = 0; i + 2 < indices.Length; i += 3)
                {
                    int a = welded[indices[i]], b = welded[indices[i + 1]], c = welded[indices[i + 2]];
                    if (a != b && b != c && a != c) writer.WriteLine("f " + a + " " + b + " " + c);
                }
            }
        }

        // R keeps every bit of a float, and the invariant culture writes a point. -0 and 0 must be one vertex.
        private static string Number(float value) { return (value == 0.0f ? 0.0f : value).ToString("R", CultureInfo.InvariantCulture); }
    }
}
