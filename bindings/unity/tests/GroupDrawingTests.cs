// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using LangevinRigid;
using LangevinUnity;
using NUnit.Framework;
using Unity.Collections;
using UnityEngine;
using UnityEngine.Rendering;
using Allocator = Unity.Collections.Allocator;

public sealed unsafe class GroupDrawingTests : Stage
{
    private LangevinBatch NewGroup(int capacity, int count)
    {
        return NewBatch(capacity, b =>
        {
            b.StartCount = count;
            b.Emitter.size = new Vector3(2.0f, 2.0f, 2.0f);
            b.Drawing.mode = LangevinDrawMode.BatchRendererGroup;
            b.Drawing.materials[0].enableInstancing = false;
        });
    }

    private static void Cull(Action<BatchCullingOutputDrawCommands> look, BatchCullingViewType view, params Plane[] planes)
    {
        var context = new BatchCullingContext { cullingPlanes = new NativeArray<Plane>(planes.Length, Allocator.Temp), viewType = view };
        for (int i = 0; i < planes.Length; ++i) context.cullingPlanes[i] = planes[i];
        var output = new BatchCullingOutput { drawCommands = new NativeArray<BatchCullingOutputDrawCommands>(1, Allocator.Temp) };
        BatchRendererGroup.Last.Cull(BatchRendererGroup.Last, context, output, IntPtr.Zero).Complete();
        BatchCullingOutputDrawCommands commands = output.drawCommands[0];
        look(commands);
        foreach (IntPtr memory in new[] { (IntPtr)commands.drawCommands, (IntPtr)commands.visibleInstances, (IntPtr)commands.drawRanges })
            Unity.Collections.LowLevel.Unsafe.UnsafeUtility.Free((void*)memory, Allocator.TempJob);
        context.cullingPlanes.Dispose();
        output.drawCommands.Dispose();
    }

    [Test]
    public void MatricesAndInversesLieWhereTheMetadataSays()
    {
        LangevinBatch batch = NewGroup(100, 60);
        Frames(3);
        MetadataValue[] metadata = BatchRendererGroup.Last.Metadata;
        Assert.AreEqual(Shader.PropertyToID("unity_ObjectToWorld"), metadata[0].NameID);
        Assert.AreEqual(Shader.PropertyToID("unity_WorldToObject"), metadata[1].NameID);
        float[] gpu = GraphicsBuffer.Last.Floats;
        int to = (int)(metadata[0].Value & 0x7fffffffu) / 4, from = (int)(metadata[1].Value & 0x7fffffffu) / 4;
        Assert.IsTrue(metadata[0].Value >> 31 == 1 && metadata[1].Value >> 31 == 1);
        for (int i = 0; i < 16; ++i) Assert.AreEqual(0.0f, gpu[i]);
        BatchView view = batch.View();
        for (int i = 0; i < 60; ++i)
        {
            int a = to + 12 * i, b = from + 12 * i;
            Assert.AreEqual(view.PositionX[i], gpu[a + 9], 1e-3);
            Assert.AreEqual(-view.PositionZ[i], gpu[a + 11], 1e-3);
            for (int r = 0; r < 3; ++r)
                for (int c = 0; c < 4; ++c)
                {
                    double sum = c == 3 ? gpu[b + 9 + r] : 0.0;
                    for (int k = 0; k < 3; ++k) sum += gpu[b + 3 * k + r] * gpu[a + 3 * c + k];
                    Assert.AreEqual(r == c ? 1.0 : 0.0, sum, 1e-4);
                }
        }
        Assert.AreEqual(0, Graphics.Calls.Count);
        Silent();
    }

    [Test]
    public void OnlyWhatMovedIsSent()
    {
        LangevinBatch batch = NewGroup(2000, 2000);
        Frames(2);
        BatchView view = batch.View();
        var ids = new List<BodyId>();
        for (int i = 10; i < 2000; ++i) ids.Add(view.Ids[i]);
        foreach (BodyId id in ids) batch.SetSleep(id, true);
        Frames(2);
        GraphicsBuffer.Last.Sent = 0;
        Frames(1);
        Assert.AreEqual(2 * 12 * 10, GraphicsBuffer.Last.Sent);
    }

    [Test]
    public void CullingDrawsChunksThatAreSeen()
    {
        NewGroup(2500, 2500);
        Frames(1);
        Cull(c =>
        {
            Assert.AreEqual(3, c.drawCommandCount);
            Assert.AreEqual(2500, c.visibleInstanceCount);
            Assert.AreEqual(1, c.drawRangeCount);
            Assert.AreEqual(3u, c.drawRanges[0].drawCommandsCount);
            var seen = new HashSet<int>();
            for (int d = 0; d < 3; ++d)
                for (uint i = 0; i < c.drawCommands[d].visibleCount; ++i) seen.Add(c.visibleInstances[c.drawCommands[d].visibleOffset + i]);
            Assert.AreEqual(2500, seen.Count);
        }, BatchCullingViewType.Camera, new Plane(Vector3.up, 100.0f), new Plane(Vector3.down, 100.0f));
        Cull(c => Assert.AreEqual(0, c.drawCommandCount), BatchCullingViewType.Camera, new Plane(Vector3.up, -100.0f));
        Cull(c => Assert.AreEqual(0, c.drawCommandCount), BatchCullingViewType.Picking);
        Assert.Greater(BatchRendererGroup.Last.GlobalBounds.size.x, 3.0);
        Silent();
    }

    [Test]
    public void WithoutRawBuffersItIsInstanced()
    {
        BatchRendererGroup.Target = BatchBufferTarget.ConstantBuffer;
        try
        {
            NewBatch(10, b => { b.StartCount = 3; b.Drawing.mode = LangevinDrawMode.BatchRendererGroup; });
            Frames(1);
            Assert.AreEqual(1, Graphics.Calls.Count);
            Assert.AreEqual(1, Complaints("no raw buffers"));
        }
        finally
        {
            BatchRendererGroup.Target = BatchBufferTarget.RawBuffer;
        }
    }
}
