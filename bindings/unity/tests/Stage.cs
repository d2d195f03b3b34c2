// SPDX-License-Identifier: MIT
using System;
using System.IO;
using System.Linq;
using LangevinUnity;
using NUnit.Framework;
using Unity.Collections;
using UnityEngine;
using UnityEngine.Rendering;

// A scene for a test, which checks for leaks at its end.
public abstract class Stage
{
    public static readonly byte[] Leaf = File.ReadAllBytes(Environment.GetEnvironmentVariable("LR_TEST_LEAF"));

    protected LangevinWorld World;
    protected LangevinAsset Asset;

    [SetUp]
    public void Begin()
    {
        Debug.Messages.Clear();
        Asset = LangevinAsset.FromBytes(Leaf, MeshMirror.Z);
        Asset.name = "leaf";
        World = NewWorld();
        Physics.gravity = new Vector3(0.0f, -9.81f, 0.0f);
    }

    [TearDown]
    public void End()
    {
        ShimPlayer.Clear();
        Assert.AreEqual(0, LangevinSimulation.LivingCount, "worlds that were not ended");
        Assert.AreEqual(0, NativeArrayCheck.Living, "NativeArrays that were not disposed of");
        Assert.AreEqual(0, GraphicsBuffer.Living, "GraphicsBuffers");
        Assert.AreEqual(0, BatchRendererGroup.Living, "BatchRendererGroups");
    }

    protected static LangevinWorld NewWorld()
    {
        var made = new GameObject("world");
        made.SetActive(false);
        var world = made.AddComponent<LangevinWorld>();
        world.Workers = 0;
        made.SetActive(true);
        return world;
    }

    protected static Mesh LeafMesh()
    {
        var mesh = new Mesh
        {
            vertices = new[] { new Vector3(-0.035f, 0.0f, 0.0f), new Vector3(0.0f, 0.0f, 0.02f), new Vector3(0.035f, 0.0f, 0.0f) },
            triangles = new[] { 0, 1, 2 },
        };
        mesh.RecalculateBounds();
        return mesh;
    }

    protected LangevinBatch NewBatch(int capacity, Action<LangevinBatch> set = null)
    {
        var made = new GameObject("batch");
        made.SetActive(false);
        var batch = made.AddComponent<LangevinBatch>();
        batch.Asset = Asset;
        batch.Capacity = capacity;
        batch.Emitter.rate = 0.0f;
        batch.Drawing.mesh = LeafMesh();
        batch.Drawing.materials = new[] { new Material(Shader.Find("Standard")) { enableInstancing = true } };
        if (set != null) set(batch);
        made.SetActive(true);
        return batch;
    }

    protected static T Put<T>(Vector3 at, Action<T> set = null) where T : Collider
    {
        var made = new GameObject(typeof(T).Name);
        made.SetActive(false);
        var collider = made.AddComponent<T>();
        made.AddComponent<LangevinCollider>();
        made.transform.position = at;
        if (set != null) set(collider);
        made.SetActive(true);
        return collider;
    }

    protected static void Frames(int count)
    {
        for (int i = 0; i < count; ++i) ShimPlayer.Frame(1.0f / 60.0f);
    }

    protected static void Silent()
    {
        string noise = Debug.Messages.FirstOrDefault(m => !m.StartsWith("log:"));
        Assert.IsNull(noise);
    }

    protected static int Complaints(string part) { return Debug.Messages.Count(m => m.Contains(part)); }

    protected static void Near(Vector3 expected, Vector3 actual, double delta)
    {
        Assert.AreEqual(expected.x, actual.x, delta, "x of " + actual.ToString("G6"));
        Assert.AreEqual(expected.y, actual.y, delta, "y of " + actual.ToString("G6"));
        Assert.AreEqual(expected.z, actual.z, delta, "z of " + actual.ToString("G6"));
    }
}

public static class Program
{
    public static int Main(string[] names)
    {
        return ShimTestRunner.Run(names.Select(System.Reflection.Assembly.LoadFrom).ToArray());
    }
}
