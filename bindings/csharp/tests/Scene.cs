// SPDX-License-Identifier: MIT
using System;
using System.IO;
using LangevinRigid;

/// <summary>Set-up for many tests.</summary>
static class Scene
{
    public const float Frame = 1.0f / 60.0f;

    public static Asset Leaf()
    {
        EllipsoidDesc desc = EllipsoidDesc.Create();
        desc.SemiAxes = new Double3(0.04, 0.01, 0.0005);
        desc.Density = 800.0;
        return Asset.CreateEllipsoid(desc);
    }

    public static Batch Batch(World world, int capacity)
    {
        using (Asset leaf = Leaf()) return world.CreateBatch(leaf, capacity);
    }

    public static BodyDesc[] Bodies(int count)
    {
        var descs = new BodyDesc[count];
        BodyDesc desc = BodyDesc.Create();
        for (int i = 0; i < count; ++i)
        {
            desc.Position = new Float3(0.2f * (i % 100), 10.0f + 0.2f * (i / 100 % 100), 0.2f * (i / 10000));
            desc.Orientation = new Float4(0.1f * (i % 7), 0.2f, 0.1f * (i % 3), 1.0f);
            descs[i] = desc;
        }
        return descs;
    }

    /// <summary>An asset file of lr_bake; the test script gives its path.</summary>
    public static byte[] BakedBytes()
    {
        return File.ReadAllBytes(BakedPath);
    }

    public static string BakedPath
    {
        get
        {
            string path = Environment.GetEnvironmentVariable("LANGEVIN_TEST_ASSET");
            Check.True(!string.IsNullOrEmpty(path), "LANGEVIN_TEST_ASSET names an asset file");
            return path;
        }
    }

    /// <summary>A folder for files of tests.</summary>
    public static string Folder
    {
        get { return Path.GetDirectoryName(BakedPath); }
    }
}
