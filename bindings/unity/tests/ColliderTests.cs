// SPDX-License-Identifier: MIT
using System;
using System.Linq;
using LangevinRigid;
using LangevinUnity;
using NUnit.Framework;
using UnityEngine;

public sealed class ColliderTests : Stage
{
    private float Top(float x, float z)
    {
        LangevinRayHit hit;
        return World.Raycast(new Vector3(x, 100.0f, z), Vector3.down, 1000.0f, out hit) ? hit.position.y : float.NaN;
    }

    private void NothingAt(float x, float z) { Assert.IsTrue(float.IsNaN(Top(x, z)), "something at " + x + " " + z); }

    [Test]
    public void Boxes()
    {
        BoxCollider box = Put<BoxCollider>(new Vector3(1.0f, 2.0f, 30.0f), b =>
        {
            b.center = new Vector3(0.0f, 0.5f, 1.0f);
            b.size = new Vector3(2.0f, 1.0f, 6.0f);
            b.transform.localScale = new Vector3(1.0f, 2.0f, 1.0f);
        });
        Frames(1);
        Assert.AreEqual(4.0, Top(1.0f, 31.0f), 1e-4);
        Assert.AreEqual(4.0, Top(1.9f, 33.9f), 1e-4);
        NothingAt(1.0f, 27.9f);
        NothingAt(2.1f, 31.0f);
        // A quarter turn about y takes +z to +x, as in Unity.
        box.transform.rotation = Quaternion.AngleAxis(90.0f, Vector3.up);
        Frames(1);
        Assert.AreEqual(4.0, Top(4.9f, 30.0f), 1e-4);
        NothingAt(1.0f, 32.0f);
        Silent();
    }

    [Test]
    public void SpheresTakeTheLargestScale()
    {
        Put<SphereCollider>(new Vector3(0.0f, 0.0f, 5.0f), s => { s.radius = 0.5f; s.transform.localScale = new Vector3(1.0f, 4.0f, 2.0f); });
        Frames(1);
        Assert.AreEqual(2.0, Top(0.0f, 5.0f), 1e-4);
        Assert.AreEqual(Math.Sqrt(3.0), Top(1.0f, 5.0f), 1e-3);
    }

    [Test]
    public void CapsulesOfEachDirection()
    {
        for (int direction = 0; direction < 3; ++direction)
        {
            CapsuleCollider capsule = Put<CapsuleCollider>(new Vector3(0.0f, 0.0f, 20.0f), c => { c.radius = 1.0f; c.height = 6.0f; c.direction = direction; });
            Frames(1);
            Assert.AreEqual(direction == 1 ? 3.0 : 1.0, Top(0.0f, 20.0f), 1e-3);
            if (direction == 0) { Assert.AreEqual(1.0, Top(1.9f, 20.0f), 1e-3); NothingAt(0.0f, 22.0f); }
            if (direction == 1) { NothingAt(1.9f, 20.0f); NothingAt(0.0f, 22.0f); }
            if (direction == 2) { Assert.AreEqual(1.0, Top(0.0f, 21.9f), 1e-3); NothingAt(1.9f, 20.0f); }
            UnityEngine.Object.DestroyImmediate(capsule.gameObject);
        }
        // A capsule as short as it is thick is a sphere.
        Put<CapsuleCollider>(new Vector3(0.0f, 0.0f, 20.0f), c => { c.radius = 1.0f; c.height = 1.0f; });
        Frames(1);
        Assert.AreEqual(1.0, Top(0.0f, 20.0f), 1e-3);
        Silent();
    }

    private static Mesh Wedge()
    {
        // Rises along +z from 0 to 2.
        return new Mesh
        {
            vertices = new[]
            {
                new Vector3(-1, 0, 0), new Vector3(1, 0, 0), new Vector3(-1, 2, 4), new Vector3(1, 2, 4), new Vector3(-1, -1, 4), new Vector3(1, -1, 4),
            },
            triangles = new[] { 0, 2, 1, 1, 2, 3, 0, 1, 4, 1, 5, 4, 2, 4, 3, 3, 4, 5, 0, 4, 2, 1, 3, 5 },
        };
    }

    [Test]
    public void MeshesAndHulls()
    {
        foreach (bool convex in new[] { false, true })
        {
            MeshCollider mesh = Put<MeshCollider>(new Vector3(0.0f, 1.0f, 10.0f), m => { m.sharedMesh = Wedge(); m.convex = convex; });
            Frames(1);
            Assert.AreEqual(1.5, Top(0.2f, 11.0f), 1e-3);
            Assert.AreEqual(2.5, Top(0.2f, 13.0f), 1e-3);
            NothingAt(0.0f, 9.0f);
            UnityEngine.Object.DestroyImmediate(mesh.gameObject);
        }
        Silent();
    }

    [Test]
    public void HullsOfManyPointsKeepTheirShape()
    {
        var points = new Vector3[2000];
        var random = new System.Random(1);
        for (int i = 0; i < points.Length; ++i)
        {
            var p = new Vector3((float)random.NextDouble() - 0.5f, (float)random.NextDouble() - 0.5f, (float)random.NextDouble() - 0.5f);
            points[i] = p.normalized * 2.0f;
        }
        Put<MeshCollider>(Vector3.zero, m => { m.sharedMesh = new Mesh { vertices = points, triangles = new[] { 0, 1, 2 } }; m.convex = true; });
        Frames(1);
        Assert.AreEqual(2.0, Top(0.0f, 0.0f), 0.06);
        Silent();
    }

    [Test]
    public void TerrainsAreNotMirrored()
    {
        const int n = 33;
        var data = new TerrainData { heightmapResolution = n, size = new Vector3(64.0f, 10.0f, 32.0f) };
        var heights = new float[n, n];
        for (int z = 0; z < n; ++z)
            for (int x = 0; x < n; ++x) heights[z, x] = 0.2f + 0.6f * z / (n - 1) + 0.1f * x / (n - 1);
        data.SetHeights(0, 0, heights);
        // A terrain ignores the rotation of its transform.
        TerrainCollider terrain = Put<TerrainCollider>(new Vector3(100.0f, 5.0f, 200.0f), t =>
        {
            t.terrainData = data;
            t.transform.rotation = Quaternion.AngleAxis(45.0f, Vector3.up);
        });
        Frames(1);
        Assert.AreEqual(5.0 + 2.0, Top(100.01f, 200.01f), 0.01);
        Assert.AreEqual(5.0 + 8.0, Top(100.01f, 231.99f), 0.01);
        Assert.AreEqual(5.0 + 3.0, Top(163.99f, 200.01f), 0.01);
        Assert.AreEqual(5.0 + 5.5, Top(132.0f, 216.0f), 0.01);
        NothingAt(99.0f, 210.0f);
        NothingAt(120.0f, 199.0f);
        // Another height, set by hand.
        for (int z = 0; z < n; ++z)
            for (int x = 0; x < n; ++x) heights[z, x] = 1.0f;
        data.SetHeights(0, 0, heights);
        terrain.GetComponent<LangevinCollider>().Rebuild();
        Frames(1);
        Assert.AreEqual(15.0, Top(132.0f, 216.0f), 1e-3);
        Silent();
    }

    [Test]
    public void MovingOnesHaveVelocitiesAndTeleportsHaveNone()
    {
        BoxCollider box = Put<BoxCollider>(new Vector3(0.0f, 0.0f, 0.0f), b => b.size = new Vector3(2.0f, 1.0f, 2.0f));
        LangevinBatch batch = NewBatch(50);
        for (int i = 0; i < 20; ++i) batch.Spawn(new Vector3(-0.5f + 0.05f * i, 0.55f, 0.0f), Quaternion.Euler(90.0f, 0.0f, 0.0f));
        Frames(240);
        // Friction carries the bodies along +z.
        for (int i = 0; i < 60; ++i)
        {
            box.transform.position += new Vector3(0.0f, 0.0f, 0.01f);
            Frames(1);
        }
        double z = Enumerable.Range(0, 20).Average(i => (double)batch.Instances.Matrices[i].m23);
        Assert.Greater(z, 0.2);
        int still = Enumerable.Range(0, 20).Count(i => batch.Instances.Matrices[i].m13 > 0.4f);
        Assert.Greater(still, 10);
        // Without the collider they fall.
        box.transform.position = new Vector3(500.0f, 0.0f, 0.0f);
        Frames(60);
        Assert.AreEqual(0, Enumerable.Range(0, 20).Count(i => batch.Instances.Matrices[i].m13 > 0.3f));
        Assert.IsFalse(float.IsNaN(Top(500.0f, 0.0f)));
        Silent();
    }

    [Test]
    public void ChangesAreNoticed()
    {
        BoxCollider box = Put<BoxCollider>(Vector3.zero);
        Frames(1);
        Assert.AreEqual(0.5, Top(0.0f, 0.0f), 1e-4);
        box.size = new Vector3(1.0f, 3.0f, 1.0f);
        Frames(1);
        Assert.AreEqual(1.5, Top(0.0f, 0.0f), 1e-4);
        box.enabled = false;
        Frames(1);
        NothingAt(0.0f, 0.0f);
        box.enabled = true;
        Frames(1);
        Assert.AreEqual(1.5, Top(0.0f, 0.0f), 1e-4);
        var fixedOne = box.GetComponent<LangevinCollider>();
        fixedOne.NeverMoves = true;
        box.transform.position = Vector3.right;
        Frames(1);
        Assert.AreEqual(1.5, Top(-0.4f, 0.0f), 1e-4);
        fixedOne.NeverMoves = false;
        Frames(1);
        NothingAt(-0.4f, 0.0f);
        // Layers and materials.
        var member = box.GetComponent<LangevinCollider>();
        box.gameObject.layer = 9;
        box.sharedMaterial = new PhysicMaterial { dynamicFriction = 0.9f, bounciness = 0.7f };
        Frames(1);
        Assert.AreEqual(1u << 9, StateOf(member).Layers);
        Assert.AreEqual(0.9, StateOf(member).Friction, 1e-6);
        Assert.AreEqual(0.7, StateOf(member).Restitution, 1e-6);
        Silent();
    }

    private unsafe ColliderState StateOf(LangevinCollider collider)
    {
        ColliderState state = ColliderState.Create();
        LangevinException.Check(Native.lr_collider_get_state(World.Simulation.Handle, collider.Id, &state), "lr_collider_get_state");
        return state;
    }

    [Test]
    public void OneThatGoesWrongStopsNoOther()
    {
        MeshCollider mesh = Put<MeshCollider>(new Vector3(0.0f, 1.0f, 10.0f), m => m.sharedMesh = Wedge());
        SphereCollider other = Put<SphereCollider>(new Vector3(50.0f, 0.0f, 0.0f));
        Frames(1);
        mesh.sharedMesh = null;
        Frames(5);
        Assert.AreEqual(1, Complaints("has no mesh"));
        NothingAt(0.2f, 11.0f);
        other.transform.position = new Vector3(60.0f, 0.0f, 0.0f);
        Frames(2);
        Assert.AreEqual(0.5, Top(60.0f, 0.0f), 1e-4);
        mesh.sharedMesh = Wedge();
        Frames(1);
        Assert.AreEqual(1.5, Top(0.2f, 11.0f), 1e-3);
        LangevinBatch batch = NewBatch(5, b => b.StartCount = 5);
        batch.Emitter.scale = new Vector2(-1.0f, -1.0f);
        batch.transform.position = Vector3.one;
        Frames(5);
        Assert.AreEqual(1, Complaints("lr_batch_set_emitter"));
        Assert.AreEqual(5, batch.Count);
    }

    [Test]
    public void WhatHasNoCounterpartSaysWhy()
    {
        Put<CharacterController>(Vector3.zero);
        Assert.AreEqual(1, Complaints("CharacterController is not supported"));
        Put<MeshCollider>(Vector3.zero);
        Assert.AreEqual(1, Complaints("has no mesh"));
        Mesh locked = Wedge();
        locked.UploadMeshData(true);
        Put<MeshCollider>(Vector3.zero, m => m.sharedMesh = locked);
        Assert.AreEqual(1, Complaints("Turn on Read/Write"));
        var flat = new Mesh { vertices = new[] { Vector3.zero, Vector3.right, Vector3.forward, new Vector3(1, 0, 1) }, triangles = new[] { 0, 1, 2 } };
        Put<MeshCollider>(Vector3.zero, m => { m.sharedMesh = flat; m.convex = true; });
        Assert.AreEqual(1, Complaints("turn off Convex"));
        Frames(2);
        Assert.AreEqual(0ul, World.Simulation.Info().ColliderCount);
    }
}
