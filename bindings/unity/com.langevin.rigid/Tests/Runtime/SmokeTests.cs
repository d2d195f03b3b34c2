// SPDX-License-Identifier: MIT
using LangevinRigid;
using NUnit.Framework;
using UnityEngine;

namespace LangevinUnity.Tests
{
    public sealed class SmokeTests
    {
        [Test]
        public void LibraryLoadsAndFits()
        {
            Assert.AreEqual(LangevinLibrary.HeaderVersion, LangevinLibrary.Version);
        }

        [Test]
        public void SimulationsEnd()
        {
            int before = LangevinSimulation.LivingCount;
            using (var simulation = new LangevinSimulation(1, 1, new Vector3(0.0f, -9.81f, 0.0f), 0.0f, 0.0f))
            {
                Assert.AreEqual(before + 1, LangevinSimulation.LivingCount);
                Assert.AreEqual(0ul, simulation.Info().BodyCount);
            }
            Assert.AreEqual(before, LangevinSimulation.LivingCount);
        }

        [Test]
        public void WorldsStepWithoutMembers()
        {
            var made = new GameObject("world", typeof(LangevinWorld));
            var world = made.GetComponent<LangevinWorld>();
            world.StepMode = LangevinStepMode.Manual;
            world.Step(0.25f);
            world.StepThread = LangevinStepThread.Job;
            world.Step(0.25f);
            Assert.AreEqual(0.5, world.SimulationTime, 1e-9);
            Object.DestroyImmediate(made);
        }

        [Test]
        public void RubbishIsNoAsset()
        {
            var e = Assert.Throws<LangevinException>(() => LangevinAsset.FromBytes(new byte[100], MeshMirror.Z));
            Assert.AreEqual(Status.AssetFormat, e.Status);
            Assert.Throws<LangevinException>(() => LangevinAsset.FromBytes(new byte[0], MeshMirror.Z));
        }
    }
}
