// SPDX-License-Identifier: MIT
using System;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using UnityEngine;
using UnityEngine.Rendering;
using Allocator = Unity.Collections.Allocator;

namespace LangevinUnity
{
    /// <summary>Draws by a BatchRendererGroup. One raw buffer holds 64 zero bytes, all matrices, then all inverses; each frame sends only the
    /// changes.</summary>
    internal sealed unsafe class LangevinGroupDrawing : IDisposable
    {
        private const uint PerInstance = 0x80000000u;
        private const int HeadFloats = 16;

        private readonly LangevinDrawSettings settings;
        private readonly LangevinInstances instances;
        private readonly int layer;
        private readonly int capacity;
        private readonly float reach;
        private BatchRendererGroup group;
        private GraphicsBuffer buffer;
        private BatchID batch;
        private BatchMeshID mesh;
        private BatchMaterialID[] materials;

        /// <summary>Whether the graphics API supports this.</summary>
        public static bool Supported { get { return BatchRendererGroup.BufferTarget == BatchBufferTarget.RawBuffer; } }

        public LangevinGroupDrawing(LangevinDrawSettings settings, LangevinInstances instances, int capacity, int layer)
        {
            this.settings = settings;
            this.instances = instances;
            this.capacity = capacity;
            this.layer = layer;
            reach = settings.Reach;
            group = new BatchRendererGroup(OnPerformCulling, IntPtr.Zero);
            mesh = group.RegisterMesh(settings.mesh);
            materials = new BatchMaterialID[settings.mesh.subMeshCount];
            for (int i = 0; i < materials.Length; ++i) materials[i] = group.RegisterMaterial(settings.MaterialOf(i));
            buffer = new GraphicsBuffer(GraphicsBuffer.Target.Raw, HeadFloats + 24 * capacity, sizeof(float));
            var zeros = new NativeArray<float>(HeadFloats, Allocator.Temp);
            buffer.SetData(zeros, 0, 0, HeadFloats);
            zeros.Dispose();
            var metadata = new NativeArray<MetadataValue>(2, Allocator.Temp);
            metadata[0] = Metadata("unity_ObjectToWorld", HeadFloats);
            metadata[1] = Metadata("unity_WorldToObject", HeadFloats + 12 * capacity);
            batch = group.AddBatch(metadata, buffer.bufferHandle);
            metadata.Dispose();
        }

        private static MetadataValue Metadata(string name, int atFloat)
        {
            return new MetadataValue { NameID = Shader.PropertyToID(name), Value = (uint)(atFloat * sizeof(float)) | PerInstance };
        }

        /// <summary>Sends the matrices written by the last refresh.</summary>
        public void Upload()
        {
            int count = 12 * instances.Written;
            if (count > 0)
            {
                buffer.SetData(instances.Floats, 0, HeadFloats, count);
                buffer.SetData(instances.InverseFloats, 0, HeadFloats + 12 * capacity, count);
            }
            group.SetGlobalBounds(instances.BoundsOfAll(reach));
        }

        // Unity frees these allocations.
        private JobHandle OnPerformCulling(BatchRendererGroup renderer, BatchCullingContext context, BatchCullingOutput output, IntPtr user)
        {
            var commands = new BatchCullingOutputDrawCommands();
            int chunkCount = instances.ChunkCount;
            // Bodies have no GameObjects to pick or outline.
            if (chunkCount == 0 || context.viewType == BatchCullingViewType.Picking || context.viewType == BatchCullingViewType.SelectionOutline)
            {
                output.drawCommands[0] = commands;
                return new JobHandle();
            }
            commands.drawCommands = (BatchDrawCommand*)UnsafeUtility.Malloc(
                (long)sizeof(BatchDrawCommand) * chunkCount * materials.Length, 8, Allocator.TempJob);
            commands.visibleInstances = (int*)UnsafeUtility.Malloc((long)sizeof(int) * instances.Count, 4, Allocator.TempJob);
            commands.drawRanges = (BatchDrawRange*)UnsafeUtility.Malloc(sizeof(BatchDrawRange), 8, Allocator.TempJob);
            for (int chunk = 0; chunk < chunkCount; ++chunk)
            {
                if (!LangevinCulling.Sees(context.cullingPlanes, instances.BoundsOf(chunk, reach))) continue;
                int first = commands.visibleInstanceCount, count = instances.CountOf(chunk);
                for (int i = 0; i < count; ++i) commands.visibleInstances[first + i] = instances.FirstOf(chunk) + i;
                commands.visibleInstanceCount += count;
                for (int submesh = 0; submesh < materials.Length; ++submesh)
                    commands.drawCommands[commands.drawCommandCount++] = new BatchDrawCommand
                    {
                        visibleOffset = (uint)first,
                        visibleCount = (uint)count,
                        batchID = batch,
                        materialID = materials[submesh],
                        meshID = mesh,
                        submeshIndex = (ushort)submesh,
                        splitVisibilityMask = 0xff,
                    };
            }
            commands.drawRangeCount = 1;
            commands.drawRanges[0] = new BatchDrawRange
            {
                drawCommandsBegin = 0,
                drawCommandsCount = (uint)commands.drawCommandCount,
                filterSettings = new BatchFilterSettings
                {
                    renderingLayerMask = uint.MaxValue,
                    layer = (byte)layer,
                    motionMode = MotionVectorGenerationMode.Camera,
                    shadowCastingMode = settings.shadows,
                    receiveShadows = settings.receiveShadows,
                },
            };
            output.drawCommands[0] = commands;
            return new JobHandle();
        }

        public void Dispose()
        {
            if (group == null) return;
            group.RemoveBatch(batch);
            foreach (BatchMaterialID material in materials) group.UnregisterMaterial(material);
            group.UnregisterMesh(mesh);
            group.Dispose();
            group = null;
            buffer.Dispose();
        }
    }

    /// <summary>Tests boxes against the planes of a view.</summary>
    internal static class LangevinCulling
    {
        /// <summary>Whether a part of the box can be inside all planes. Their normals point inward.</summary>
        public static bool Sees(NativeArray<Plane> planes, Bounds box)
        {
            Vector3 center = box.center, half = box.extents;
            for (int i = 0; i < planes.Length; ++i)
            {
                Vector3 n = planes[i].normal;
                float reach = Mathf.Abs(n.x) * half.x + Mathf.Abs(n.y) * half.y + Mathf.Abs(n.z) * half.z;
                if (Vector3.Dot(n, center) + planes[i].distance < -reach) return false;
            }
            return true;
        }
    }
}
