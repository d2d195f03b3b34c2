// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Runtime.CompilerServices;
using LangevinUnity;
using LangevinUnity.Editor;
using NUnit.Framework;
using UnityEditor;
using UnityEditor.AssetImporters;
using UnityEngine;

public sealed class EditorTests : Stage
{
    private static readonly string Folder = Environment.GetEnvironmentVariable("LR_TEST_FOLDER");
    private static readonly string Baker = Environment.GetEnvironmentVariable("LR_TEST_BAKER");

    private static AssetImportContext Import(byte[] bytes, MeshMirror mirror)
    {
        string path = Path.Combine(Folder, "imported leaf.lrb");
        File.WriteAllBytes(path, bytes);
        var context = new AssetImportContext(path);
        new LrbImporter { Mirror = mirror }.OnImportAsset(context);
        return context;
    }

    [Test]
    public void ImporterMakesAnAsset()
    {
        AssetImportContext context = Import(Leaf, MeshMirror.X);
        Assert.AreEqual(0, context.Errors.Count);
        var asset = context.mainObject as LangevinAsset;
        Assert.IsNotNull(asset);
        Assert.AreEqual("imported leaf", asset.name);
        Assert.AreEqual(MeshMirror.X, asset.Mirror);
        Assert.AreEqual(0.00018015, asset.Numbers.mass, 1e-7);
        Assert.AreEqual(350.0, asset.Numbers.density, 1e-6);
        Assert.AreEqual(0.07, asset.Numbers.length, 1e-3);
        Assert.AreEqual(Leaf.Length, asset.Bytes.Length);
        new LangevinAssetEditor { target = asset }.OnInspectorGUI();
    }

    [Test]
    public void ImporterSaysWhatIsWrong()
    {
        AssetImportContext cut = Import(Leaf.Take(1000).ToArray(), MeshMirror.Z);
        Assert.IsNull(cut.mainObject);
        Assert.IsTrue(cut.Errors.Count == 1 && cut.Errors[0].Contains("error "), "numbered: " + string.Join("; ", cut.Errors.ToArray()));
        byte[] damaged = (byte[])Leaf.Clone();
        damaged[damaged.Length / 2] ^= 0x40;
        AssetImportContext broken = Import(damaged, MeshMirror.Z);
        Assert.IsNull(broken.mainObject);
        Assert.IsTrue(broken.Errors[0].Contains("AssetCorrupt"), broken.Errors[0]);
        Assert.IsTrue(Import(new byte[0], MeshMirror.Z).Errors.Count == 1);
    }

    // A box of 4 x 2 x 1 cm with four vertices per side, as Unity has, seams included.
    private static Mesh SeamedBox()
    {
        var vertices = new List<Vector3>();
        var triangles = new List<int>();
        for (int axis = 0; axis < 3; ++axis)
            for (int side = -1; side <= 1; side += 2)
            {
                int first = vertices.Count;
                for (int k = 0; k < 4; ++k)
                {
                    float u = k == 1 || k == 2 ? 1 : -1, v = k >= 2 ? 1 : -1;
                    Vector3 p = axis == 0 ? new Vector3(side, u, v) : axis == 1 ? new Vector3(v, side, u) : new Vector3(u, v, side);
                    vertices.Add(Vector3.Scale(p, new Vector3(0.02f, 0.01f, 0.005f)));
                }
                // Clockwise seen from outside.
                int[] corners = side > 0 ? new[] { 0, 1, 2, 0, 2, 3 } : new[] { 0, 2, 1, 0, 3, 2 };
                foreach (int c in corners) triangles.Add(first + c);
            }
        return new Mesh { name = "box with a space", vertices = vertices.ToArray(), triangles = triangles.ToArray() };
    }

    private LangevinBake Bake(string input, string output, LangevinBakeSettings settings)
    {
        var bake = new LangevinBake(Baker, settings.Arguments(input, output, "a \"quoted\" name"));
        bake.Wait();
        return bake;
    }

    [Test]
    public void MeshesAreBakedAsTheyAre()
    {
        string obj = Path.Combine(Folder, "a box.obj"), lrb = Path.Combine(Folder, "a box.lrb");
        MeshWriter.WriteObj(SeamedBox(), obj);
        string[] lines = File.ReadAllLines(obj);
        Assert.AreEqual(8, lines.Count(l => l.StartsWith("v ")));
        Assert.AreEqual(12, lines.Count(l => l.StartsWith("f ")));
        using (LangevinBake bake = Bake(obj, lrb, new LangevinBakeSettings { density = 500.0 }))
        {
            Assert.AreEqual(0, bake.ExitCode, bake.Errors);
            Assert.IsFalse(bake.Errors.Contains("warning"));
            Assert.IsTrue(bake.Report.Contains("mass"));
        }
        LangevinAsset asset = LangevinAsset.FromBytes(File.ReadAllBytes(lrb), MeshMirror.Z);
        Assert.AreEqual(500.0 * 0.04 * 0.02 * 0.01, asset.Numbers.mass, 1e-8);
        Assert.AreEqual("a \"quoted\" name", asset.Numbers.bakedName);
    }

    // All corners on one line: no repair makes a body of it.
    private static Mesh WithoutArea()
    {
        Mesh mesh = SeamedBox();
        mesh.vertices = mesh.vertices.Select(v => new Vector3(v.x + 2.0f * v.y + 4.0f * v.z, 0.0f, 0.0f)).ToArray();
        return mesh;
    }

    [Test]
    public void BakesThatFailSayWhy()
    {
        string obj = Path.Combine(Folder, "open.obj"), lrb = Path.Combine(Folder, "open.lrb");
        File.Delete(lrb);
        MeshWriter.WriteObj(WithoutArea(), obj);
        using (LangevinBake bake = Bake(obj, lrb, new LangevinBakeSettings()))
        {
            Assert.AreEqual(1, bake.ExitCode);
            Assert.IsTrue(bake.Errors.Contains("error "), bake.Errors);
        }
        Assert.IsFalse(File.Exists(lrb));
        // An open mesh is a sheet.
        Mesh box = SeamedBox();
        box.triangles = box.triangles.Skip(6).ToArray();
        MeshWriter.WriteObj(box, obj);
        using (LangevinBake bake = Bake(obj, lrb, new LangevinBakeSettings { sheet = true, thickness = 0.0002, arealDensity = 0.08 }))
            Assert.AreEqual(0, bake.ExitCode, bake.Errors);
        Assert.IsTrue(File.Exists(lrb));
        Assert.Throws<ArgumentException>(() => MeshWriter.WriteObj(new Mesh(), obj));
        Assert.IsNotNull(new LangevinBakeSettings { density = 0.0 }.Problem());
        Assert.IsNotNull(new LangevinBakeSettings { sheet = true, thickness = 0.0 }.Problem());
        Assert.IsNull(new LangevinBakeSettings().Problem());
    }

    [Test]
    public void BakesCanBeCancelled()
    {
        string obj = Path.Combine(Folder, "a box.obj"), lrb = Path.Combine(Folder, "cancelled.lrb");
        MeshWriter.WriteObj(SeamedBox(), obj);
        using (var bake = new LangevinBake(Baker, new LangevinBakeSettings { wake = true }.Arguments(obj, lrb, "x").Concat(new[] { "--grid", "256,128,128" })))
        {
            bake.Cancel();
            bake.Wait();
            Assert.IsTrue(bake.Cancelled && bake.Ended);
        }
        Assert.IsFalse(File.Exists(lrb));
    }

    // Driven like in the editor: fields, a press on Bake, updates until the end.
    private static BakeWindow Press(Mesh mesh, string output, bool cancel, out string message)
    {
        var window = ScriptableObject.CreateInstance<BakeWindow>();
        Set(window, "mesh", mesh);
        Set(window, "output", output);
        EditorPrefs.SetString(LangevinBakerTool.PreferenceKey, Baker);
        ShimPlayer.Send(window, "OnEnable");
        ShimPlayer.Send(window, "OnGUI");
        Assert.IsNull(window.GetType().GetMethod("Problem", Hidden).Invoke(window, null));
        ShimPlayer.Send(window, "Begin");
        EditorUtility.Cancel = cancel;
        for (int i = 0; i < 600 && Get(window, "bake") != null; ++i)
        {
            System.Threading.Thread.Sleep(20);
            EditorApplication.update();
        }
        EditorUtility.Cancel = false;
        Assert.IsNull(Get(window, "bake"));
        ShimPlayer.Send(window, "OnGUI");
        ShimPlayer.Send(window, "OnDisable");
        message = (string)Get(window, "message");
        return window;
    }

    private const System.Reflection.BindingFlags Hidden = System.Reflection.BindingFlags.Instance | System.Reflection.BindingFlags.NonPublic;

    private static void Set(object o, string field, object value) { o.GetType().GetField(field, Hidden).SetValue(o, value); }

    private static object Get(object o, string field) { return o.GetType().GetField(field, Hidden).GetValue(o); }

    [Test]
    public void TheBakeWindowBakesAndImports()
    {
        string message;
        AssetDatabase.Imported.Clear();
        var importer = new LrbImporter { Mirror = MeshMirror.X };
        AssetImporter.ShimImporters["Assets/made/box.lrb"] = importer;
        BakeWindow window = Press(SeamedBox(), "Assets/made/box.lrb", false, out message);
        Assert.IsFalse((bool)Get(window, "failed"));
        Assert.IsTrue(message.Contains("box with a space"), message);
        Assert.IsTrue(File.Exists("Assets/made/box.lrb"));
        Assert.AreEqual("Assets/made/box.lrb", AssetDatabase.Imported.Single());
        Assert.AreEqual(MeshMirror.Z, importer.Mirror);
        Assert.IsNull(Get(window, "temporary"));
        byte[] before = File.ReadAllBytes("Assets/made/box.lrb");
        // A cancelled or failed bake keeps the old file.
        window = Press(SeamedBox(), "Assets/made/box.lrb", true, out message);
        Assert.IsTrue((bool)Get(window, "failed") && message.Contains("Cancelled"));
        window = Press(WithoutArea(), "Assets/made/box.lrb", false, out message);
        Assert.IsTrue((bool)Get(window, "failed") && message.Contains("error "), message);
        Assert.IsTrue(before.SequenceEqual(File.ReadAllBytes("Assets/made/box.lrb")));
        Assert.AreEqual(1, AssetDatabase.Imported.Count);
        Assert.AreEqual(0, Directory.GetFiles(".", "*.obj").Length);
    }

    [Test]
    public void ABakerThatLostItsMarkIsRun()
    {
        string copy = Path.Combine(Folder, "lr_bake copy");
        File.WriteAllText(copy, "#!/bin/sh\necho it ran\n");
        using (var bake = new LangevinBake(copy, new[] { "x" }))
        {
            bake.Wait();
            Assert.AreEqual(0, bake.ExitCode);
            Assert.AreEqual("it ran\n", bake.Report);
        }
    }

    [Test]
    public void TheBakerIsFound()
    {
        string package = Path.Combine(Folder, "package");
        Assert.IsNull(LangevinBakerTool.Find(package, "", false));
        string tools = Path.Combine(Path.Combine(package, "Tools~"), "linux-x64");
        Directory.CreateDirectory(tools);
        File.WriteAllText(Path.Combine(tools, "lr_bake"), "");
        Assert.AreEqual(Path.Combine(tools, "lr_bake"), LangevinBakerTool.Find(package, "", false));
        Assert.AreEqual(Baker, LangevinBakerTool.Find(null, "/nowhere:" + Path.GetDirectoryName(Baker), false));
        EditorPrefs.SetString(LangevinBakerTool.PreferenceKey, Baker);
        Assert.AreEqual(Baker, LangevinBakerTool.Find());
        Directory.Delete(package, true);
    }

    [Test]
    public void ReloadsEndWhatIsLeft()
    {
        RuntimeHelpers.RunClassConstructor(typeof(LrbImporter).Assembly.GetType("LangevinUnity.Editor.ReloadGuard").TypeHandle);
        var left = new LangevinSimulation(1, 2, Vector3.zero, 0.0f, 0.0f);
        AssemblyReloadEvents.ShimReload();
        Assert.IsTrue(left.IsDisposed);
        left.Dispose();
        left = new LangevinSimulation(1, 0, Vector3.zero, 0.0f, 0.0f);
        EditorApplication.ShimPlayMode(PlayModeStateChange.ExitingPlayMode);
        Assert.IsFalse(left.IsDisposed);
        EditorApplication.ShimPlayMode(PlayModeStateChange.EnteredEditMode);
        Assert.IsTrue(left.IsDisposed);
        // Components survive the end of their world.
        ShimPlayer.Clear();
        Silent();
    }
}
