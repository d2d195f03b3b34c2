// SPDX-License-Identifier: MIT
using System.Linq;
using LangevinRigid;
using LangevinUnity;
using NUnit.Framework;
using UnityEngine;

public sealed class BatchTests : Stage
{
    [Test]
    public void LeavesFallAndAreDrawnWhereTheyAre()
    {
        LangevinBatch batch = NewBatch(10);
        BodyId body = batch.Spawn(new Vector3(1.0f, 10.0f, 2.0f), Quaternion.Euler(10.0f, 20.0f, 30.0f));
        Frames(60);
        LangevinBodyState state;
        Assert.IsTrue(batch.TryGetState(body, out state));
        Assert.Less(state.position.y, 9.7);
        Assert.Greater(state.position.y, 5.0);
        Assert.AreEqual(2.0, state.position.z, 1.0, "its z has kept its sign");
        Assert.AreEqual(1.0, state.age, 1e-4);
        Assert.AreEqual(1, batch.Instances.Count);
        Matrix4x4 m = batch.Instances.Matrices[0];
        var center = new Vector3(Asset.Numbers.centerOfMass.x, Asset.Numbers.centerOfMass.y, -Asset.Numbers.centerOfMass.z);
        foreach (Vector3 p in new[] { Vector3.zero, Vector3.right, Vector3.up, Vector3.forward })
            Near(state.position + state.rotation * (p - center), m.MultiplyPoint3x4(p), 1e-4);
        Assert.AreEqual(1, Graphics.Calls.Count);
        Near(m.MultiplyPoint3x4(Vector3.one), Graphics.Calls[0].Instances[0].MultiplyPoint3x4(Vector3.one), 0.0);
        Silent();
    }

    [Test]
    public void StateRoundTripsForBothMirrors()
    {
        foreach (MeshMirror mirror in new[] { MeshMirror.Z, MeshMirror.X })
        {
            Asset = LangevinAsset.FromBytes(Leaf, mirror);
            LangevinBatch batch = NewBatch(4);
            Quaternion q = Quaternion.Euler(-15.0f, 75.0f, 40.0f);
            var v = new Vector3(0.1f, -0.2f, 0.3f);
            var w = new Vector3(1.0f, 2.0f, -3.0f);
            BodyId body = batch.Spawn(new Vector3(1.0f, 2.0f, 3.0f), q, v, w, 1.5f);
            LangevinBodyState state;
            Assert.IsTrue(batch.TryGetState(body, out state));
            Near(new Vector3(1.0f, 2.0f, 3.0f), state.position, 0.0);
            Near(v, state.velocity, 1e-6);
            Near(w, state.angularVelocity, 1e-5);
            Near(q * Vector3.right, state.rotation * Vector3.right, 1e-6);
            Near(q * Vector3.forward, state.rotation * Vector3.forward, 1e-6);
            Assert.AreEqual(1.5f, state.scale);
            World.Present();
            Frames(1);
            LangevinBodyState later;
            batch.TryGetState(body, out later);
            Near(later.rotation * Vector3.up * 1.5f, batch.Instances.Matrices[0].MultiplyPoint3x4(Vector3.up) -
                batch.Instances.Matrices[0].MultiplyPoint3x4(Vector3.zero), 1e-5);
            batch.Despawn(body);
            Assert.IsFalse(batch.TryGetState(body, out state));
            Silent();
        }
    }

    // Two kinds of leaves fall from one tree that moves, and the game uses the transform's flag too.
    [Test]
    public void EmittersFollowATransformThatTheyShare()
    {
        var tree = new GameObject("tree");
        tree.SetActive(false);
        var batches = new[] { tree.AddComponent<LangevinBatch>(), tree.AddComponent<LangevinBatch>() };
        foreach (LangevinBatch batch in batches)
        {
            batch.Asset = Asset;
            batch.Emitter.rate = 0.0f;
            batch.Emitter.shape = EmitterShape.Point;
        }
        tree.SetActive(true);
        Frames(1);
        tree.transform.position = new Vector3(3.0f, 4.0f, 5.0f);
        tree.transform.hasChanged = false;
        Frames(1);
        foreach (LangevinBatch batch in batches)
        {
            batch.Emit(1);
            Near(tree.transform.position, batch.GetBounds().center, 0.1);
        }
    }

    [Test]
    public void OnlyTheAwakePartIsWritten()
    {
        LangevinBatch batch = NewBatch(3000);
        var bodies = new BodyId[2500];
        for (int i = 0; i < bodies.Length; ++i) bodies[i] = batch.Spawn(new Vector3(i, 100.0f, 0.0f), Quaternion.identity);
        Frames(2);
        Assert.AreEqual(2500, batch.Instances.Written);
        for (int i = 5; i < bodies.Length; ++i) batch.SetSleep(bodies[i], true);
        Frames(1);
        Assert.AreEqual(2500, batch.Instances.Written, "who comes to rest changes places");
        Frames(1);
        Assert.AreEqual(5, batch.Instances.Written);
        // Unwritten matrices keep even nonsense.
        var floats = batch.Instances.Floats;
        float before = floats[16 * 2000 + 13];
        floats[16 * 2000 + 13] = 12345.0f;
        float moving = floats[16 * 2 + 13];
        // Also in the chunk with moving bodies.
        float[] resting = Enumerable.Range(16 * 5, 16 * 1000).Select(i => floats[i]).ToArray();
        Frames(1);
        Assert.IsTrue(resting.SequenceEqual(Enumerable.Range(16 * 5, 16 * 1000).Select(i => floats[i])), "bodies at rest moved");
        Assert.AreEqual(12345.0f, floats[16 * 2000 + 13]);
        Assert.AreNotEqual(moving, floats[16 * 2 + 13]);
        Assert.AreEqual(5L, World.AwakeCount);
        batch.SetSleep(bodies[100], false);
        Frames(1);
        Assert.AreEqual(2500, batch.Instances.Written);
        // Body 100 is awake now and has another index: its y is that of all bodies, or a little less.
        Assert.AreEqual(before, floats[16 * 2000 + 13], 0.1);
        Frames(1);
        Assert.AreEqual(6, batch.Instances.Written);
        Silent();
    }

    [Test]
    public void BodiesThatEndDoNotLeaveTheirMatrices()
    {
        LangevinBatch batch = NewBatch(8);
        BodyId a = batch.Spawn(new Vector3(0.0f, 50.0f, 0.0f), Quaternion.identity);
        BodyId b = batch.Spawn(new Vector3(5.0f, 50.0f, 0.0f), Quaternion.identity);
        Frames(1);
        batch.Despawn(a);
        Frames(1);
        Assert.AreEqual(1, batch.Instances.Count);
        Assert.AreEqual(5.0, batch.Instances.Matrices[0].m03, 0.1);
        batch.Despawn(b);
        Frames(1);
        Assert.AreEqual(0, batch.Instances.Count);
        Assert.AreEqual(0, Graphics.Calls.Count);
    }

    [Test]
    public void EmitterFollowsItsTransformAndRulesRespawn()
    {
        LangevinBatch batch = NewBatch(500, b =>
        {
            b.transform.position = new Vector3(0.0f, 10.0f, 7.0f);
            b.StartCount = 200;
            b.Emitter.shape = EmitterShape.Box;
            b.Emitter.size = new Vector3(1.0f, 0.5f, 2.0f);
            b.Emitter.rate = 60.0f;
            b.Rules.enabled = true;
            b.Rules.maximumAge = 0.5f;
            b.Rules.volumes = new[]
            {
                new LangevinKillVolume { shape = VolumeShape.Plane, side = KillSide.Inside, center = new Vector3(0, -5, 0), size = Vector3.up },
            };
        });
        Assert.AreEqual(200, batch.Count);
        for (int i = 0; i < 200; ++i)
        {
            Matrix4x4 m = batch.Instances.Matrices[i];
            Assert.AreEqual(7.0, m.m23, 2.1, "z of the emitter");
            Assert.AreEqual(10.0, m.m13, 0.6);
        }
        Frames(60);
        Assert.AreEqual(260.0, batch.Count, 2.0);
        Assert.Greater(batch.Counts().TotalRespawned, 100ul);
        batch.transform.position = new Vector3(100.0f, 10.0f, -7.0f);
        Frames(40);
        int there = Enumerable.Range(0, batch.Instances.Count).Count(i => batch.Instances.Matrices[i].m03 > 90.0f && batch.Instances.Matrices[i].m23 < 0.0f);
        Assert.AreEqual(batch.Instances.Count, there);
        Silent();
    }

    [Test]
    public void ForcesAndAccelerationsPushInUnitysDirections()
    {
        LangevinBatch batch = NewBatch(4);
        BodyId a = batch.Spawn(Vector3.zero, Quaternion.identity);
        batch.AddForce(a, new Vector3(0.0f, 0.0f, 2.0f), new Vector3(0.0f, 3.0f, 0.0f), LangevinRigid.ForceMode.Velocity);
        LangevinBodyState state;
        batch.TryGetState(a, out state);
        Near(new Vector3(0.0f, 0.0f, 2.0f), state.velocity, 1e-5);
        Near(new Vector3(0.0f, 3.0f, 0.0f), state.angularVelocity, 1e-4);
        BodyId b = batch.Spawn(new Vector3(10.0f, 0.0f, 0.0f), Quaternion.identity);
        batch.SetAcceleration(new Vector3(0.0f, 0.0f, -50.0f));
        Frames(5);
        batch.TryGetState(b, out state);
        Assert.Less(state.velocity.z, -0.05);
    }

    [Test]
    public void ManyAreDrawnInChunksWithTheirBounds()
    {
        LangevinBatch batch = NewBatch(2500, b => b.StartCount = 2500);
        Frames(3);
        Assert.AreEqual(3, Graphics.Calls.Count);
        Assert.AreEqual("1023 1023 454", string.Join(" ", Graphics.Calls.Select(c => c.Instances.Length.ToString()).ToArray()));
        foreach (Graphics.Call call in Graphics.Calls)
            foreach (Matrix4x4 m in call.Instances)
                foreach (Vector3 p in call.Mesh.vertices) Assert.IsTrue(call.Parameters.worldBounds.Contains(m.MultiplyPoint3x4(p)));
        Bounds all = batch.Instances.BoundsOfAll(0.0f);
        Assert.Less(all.size.magnitude, 30.0);
    }

    [Test]
    public void WhatCannotBeDrawnSaysSoOnce()
    {
        LangevinBatch batch = NewBatch(10, b => { b.StartCount = 1; b.Drawing.materials[0].enableInstancing = false; });
        Frames(5);
        Assert.AreEqual(1, Complaints("Enable GPU Instancing"));
        batch.Drawing.materials = new Material[0];
        Frames(5);
        Assert.AreEqual(1, Complaints("No material is assigned for submesh 0"));
        NewBatch(10, b => b.Asset = null);
        Assert.AreEqual(1, Complaints("has no asset"));
        Frames(2);
    }

    [Test]
    public void BatchesFull()
    {
        LangevinBatch batch = NewBatch(1);
        batch.Spawn(Vector3.zero, Quaternion.identity);
        var e = Assert.Throws<LangevinException>(() => batch.Spawn(Vector3.one, Quaternion.identity));
        Assert.AreEqual(Status.Capacity, e.Status);
        Assert.AreEqual("lr_body_create", e.Function);
        Assert.IsTrue(e.Detail.Length > 10, "what the library says: " + e.Message);
        Silent();
    }
}
