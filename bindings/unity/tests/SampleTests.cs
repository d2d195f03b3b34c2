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
        AssetDatabase.Assets[Folder + "/leaf.lrb"] = LangevinAsset.FromBytes(File.ReadAllBytes(Folder + "/leaf.lrb"), MeshMirror.X);
        AssetDatabase.Assets[Folder + "/leaf.obj"] = LeafMesh();
        AssetDatabase.ScriptPath = Folder + "/LeafStorm.cs";
        var storm = new GameObject("storm").AddComponent<LeafStorm>();
        ShimPlayer.Send(storm, "Reset");
        Assert.IsNotNull(storm.asset);
        Assert.IsNotNull(storm.mesh);
        storm.count = 2000;
        Frames(660);
        LangevinBatch leaves = ShimPlayer.Objects.Select(o => o.GetComponent<LangevinBatch>()).First(b => b != null);
        Assert.AreEqual(2000.0, leaves.Count, 5.0);
        Assert.AreEqual(leaves.Count, Graphics.Calls.Sum(c => c.Instances.Length));
        int onGround = Graphics.Calls.SelectMany(c => c.Instances).Count(m => m.m13 < 0.2f);
        Assert.Greater(onGround, 5);
        Assert.AreEqual(0, Graphics.Calls.SelectMany(c => c.Instances).Count(m => m.m13 < -0.1f));
        Assert.AreEqual(7ul, leaves.World.Simulation.Info().ColliderCount);
        Silent();
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
