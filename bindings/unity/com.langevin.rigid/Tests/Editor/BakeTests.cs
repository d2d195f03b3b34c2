// SPDX-License-Identifier: MIT
using System.IO;
using LangevinUnity.Editor;
using NUnit.Framework;
using UnityEngine;

namespace LangevinUnity.Tests
{
    public sealed class BakeTests
    {
        [Test]
        public void MeshesAreWrittenRightHandedAndWelded()
        {
            var mesh = new Mesh
            {
                vertices = new[]
                {
                    new Vector3(0, 0, 0), new Vector3(0, 0, 1), new Vector3(1, 0, 0),
                    new Vector3(1, 0, 0), new Vector3(0, 0, 1), new Vector3(1, 0.5f, 1),
                },
                triangles = new[] { 0, 1, 2, 3, 4, 5 },
            };
            string path = Path.GetTempFileName();
            MeshWriter.WriteObj(mesh, path);
            Assert.AreEqual("v 0 0 0\nv 0 0 -1\nv 1 0 0\nv 1 0.5 -1\nf 1 3 2\nf 3 4 2\n", File.ReadAllText(path));
            File.Delete(path);
        }

        [Test]
        public void SettingsBecomeTheBakersArguments()
        {
            var settings = new LangevinBakeSettings { sheet = true, thickness = 0.00025, arealDensity = 0.08, fluid = "water", unit = "cm" };
            string line = string.Join(" ", settings.Arguments("a.obj", "b.lrb", "leaf").ToArray());
            Assert.AreEqual("mesh a.obj -o b.lrb --unit cm --fluid water --name leaf --sheet --thickness 0.00025 --areal-density 0.08", line);
            settings = new LangevinBakeSettings { density = 350.5, wake = true };
            line = string.Join(" ", settings.Arguments("a.obj", "b.lrb", null).ToArray());
            Assert.AreEqual("mesh a.obj -o b.lrb --unit m --fluid air --density 350.5 --wake", line);
        }
    }
}
