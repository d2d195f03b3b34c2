// SPDX-License-Identifier: MIT
using System.IO;
using System.Linq;
using LangevinUnity;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;

public sealed class SampleTests : Stage
{
    private static readonly string Folder = Path.Combine(System.Environment.GetEnvironmentVariable("LR_TEST_PACKAGE"), "Samples~/LeafStorm");

    [Test]
    public void LeafStormFallsAndIsDrawn()
    {
        Object.DestroyImmediate(World.gameObject);
        Load();
        LangevinBatch leaves = ShimPlayer.Objects.Select(o => o.GetComponent<LangevinBatch>()).First(b => b != null);
        Assert.AreEqual(20000, leaves.Capacity);
        leaves.enabled = false; // fewer, for the test's time
        leaves.Capacity = 2000;
        leaves.StartCount = 1000;
        leaves.Emitter.rate = 100.0f;
        leaves.enabled = true;
        Frames(660);
        Assert.AreEqual(2000.0, leaves.Count, 5.0);
        Assert.AreEqual(25.0f, leaves.Emitter.size.x);
        Assert.AreEqual(30.0f, leaves.Rules.volumes[0].size.x);
        Assert.AreEqual(12.0 * System.Math.Sin(5.5), ShimPlayer.Objects.First(o => o.name == "Ball").transform.position.x, 0.01);
        Assert.Greater(leaves.World.SampleWind(new Vector3(0, 10, 0)).magnitude, 0.5f);
        Assert.AreEqual(leaves.Count, Graphics.Calls.Sum(c => c.Instances.Length));
        int onGround = Graphics.Calls.SelectMany(c => c.Instances).Count(m => m.m13 < 0.2f);
        Assert.Greater(onGround, 5);
        Assert.AreEqual(0, Graphics.Calls.SelectMany(c => c.Instances).Count(m => m.m13 < -0.1f));
        Assert.AreEqual(7ul, leaves.World.Simulation.Info().ColliderCount);
        Silent();
    }

    // In another pipeline than the built-in one nothing may keep its materials: it would be drawn in magenta.
    [Test]
    public void LeafStormTakesThePipelinesMaterial()
    {
        Object.DestroyImmediate(World.gameObject);
        UnityEngine.Rendering.GraphicsSettings.currentRenderPipeline = new UnityEngine.Rendering.RenderPipelineAsset { defaultMaterial = new Material(Shader.Find("URP")) };
        SceneLoader scene = Load();
        Frames(2);
        UnityEngine.Rendering.GraphicsSettings.currentRenderPipeline = null;
        MeshRenderer[] solids = scene.Made.Select(o => o.GetComponent<MeshRenderer>()).Where(r => r != null).ToArray();
        Assert.AreEqual(7, solids.Length);
        Assert.IsTrue(solids.All(r => r.sharedMaterial.shader.name == "URP"));
        Material leaf = scene.Made.Select(o => o.GetComponent<LangevinBatch>()).First(b => b != null).Drawing.materials[0];
        Assert.AreEqual("URP", leaf.shader.name);
        Assert.IsTrue(leaf.enableInstancing);
    }

    private static SceneLoader Load()
    {
        Assert.IsNotNull(typeof(LeafStorm)); // loads its assembly
        var loader = new SceneLoader(Path.Combine(Folder, "../.."), new System.Collections.Generic.Dictionary<string, Object>
        {
            { "leaf.lrb", LangevinAsset.FromBytes(File.ReadAllBytes(Folder + "/leaf.lrb"), MeshMirror.X) },
            { "leaf.obj", LeafMesh() },
            { "Leaf.mat", new Material(Shader.Find("Standard")) { enableInstancing = true } },
        });
        loader.Load(Folder + "/LeafStorm.unity");
        return loader;
    }

    // Importer settings of the sample's leaf: its mesh comes from an OBJ, whose x Unity negates.
    [Test]
    public void TheSamplesLeafIsMirroredInX()
    {
        string meta = File.ReadAllText(Folder + "/leaf.lrb.meta");
        string script = File.ReadAllText(Path.Combine(Folder, "../../Editor/LrbImporter.cs.meta"));
        string guid = script.Substring(script.IndexOf("guid: ") + 6, 32);
        Assert.IsTrue(meta.Contains("guid: " + guid));
        Assert.IsTrue(meta.Contains("meshMirror: " + (int)MeshMirror.X));
    }
}
