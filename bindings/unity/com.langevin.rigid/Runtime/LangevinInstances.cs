// SPDX-License-Identifier: MIT
using System;
using LangevinRigid;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
using UnityEngine;
using Allocator = Unity.Collections.Allocator;

namespace LangevinUnity
{
    /// <summary>The matrices of a batch's bodies, for renderers. The library writes them, and they are converted to Unity in place. Matrices of
    /// sleeping bodies are not written again until a sleeping body wakes or ends.</summary>
    public sealed unsafe class LangevinInstances : IDisposable
    {
        private readonly int rows;
        private NativeArray<float> matrices;
        private NativeArray<float> inverses;
        private NativeArray<LangevinChunk> chunks;
        private bool valid;
        private ulong revision;
        private uint awake;

        /// <summary>The number of bodies, each with a matrix.</summary>
        public int Count { get; private set; }

        /// <summary>The number of matrices written by the last Refresh: the first ones.</summary>
        public int Written { get; private set; }

        /// <summary>Allocates memory for `capacity` bodies. packed: 12 floats per matrix (four columns of three) and inverses, for
        /// BatchRendererGroup; otherwise 16 floats, as Matrix4x4.</summary>
        public LangevinInstances(int capacity, bool packed)
        {
            rows = packed ? 3 : 4;
            matrices = new NativeArray<float>(capacity * 4 * rows, Allocator.Persistent, NativeArrayOptions.UninitializedMemory);
            if (packed) inverses = new NativeArray<float>(capacity * 12, Allocator.Persistent, NativeArrayOptions.UninitializedMemory);
            int count = (capacity + LangevinConvertJob.Chunk - 1) / LangevinConvertJob.Chunk;
            chunks = new NativeArray<LangevinChunk>(count, Allocator.Persistent);
        }

        /// <summary>The matrices without a copy; valid until Dispose. Not for packed matrices.</summary>
        public NativeArray<Matrix4x4> Matrices { get { return matrices.Reinterpret<Matrix4x4>(sizeof(float)); } }

        /// <summary>All floats of the matrices.</summary>
        public NativeArray<float> Floats { get { return matrices; } }

        /// <summary>All floats of the inverses of packed matrices.</summary>
        public NativeArray<float> InverseFloats { get { return inverses; } }

        /// <summary>The number of draw calls, each of at most LangevinConvertJob.Chunk bodies.</summary>
        public int ChunkCount { get { return (Count + LangevinConvertJob.Chunk - 1) / LangevinConvertJob.Chunk; } }

        /// <summary>The first body of a chunk.</summary>
        public int FirstOf(int chunk) { return chunk * LangevinConvertJob.Chunk; }

        /// <summary>The number of bodies of a chunk.</summary>
        public int CountOf(int chunk) { return Math.Min(LangevinConvertJob.Chunk, Count - FirstOf(chunk)); }

        /// <summary>A box around all bodies of a chunk, if each reaches at most `reach` metres from its origin at scale 1.</summary>
        public Bounds BoundsOf(int chunk, float reach)
        {
            LangevinChunk box = chunks[chunk];
            var bounds = new Bounds();
            var grow = Vector3.one * (reach * box.Scale);
            bounds.SetMinMax(new Vector3(box.Min.X, box.Min.Y, box.Min.Z) - grow, new Vector3(box.Max.X, box.Max.Y, box.Max.Z) + grow);
            return bounds;
        }

        /// <summary>A box around all bodies; empty and at the origin without bodies.</summary>
        public Bounds BoundsOfAll(float reach)
        {
            var all = new Bounds();
            for (int chunk = 0; chunk < ChunkCount; ++chunk)
            {
                if (chunk == 0) all = BoundsOf(chunk, reach);
                else all.Encapsulate(BoundsOf(chunk, reach));
            }
            return all;
        }

        /// <summary>Makes the next Refresh write everything.</summary>
        public void Invalidate() { valid = false; }

        /// <summary>Updates the matrices from the bodies' present poses. No step may run.</summary>
        public void Refresh(IntPtr world, BatchId batch, Float3 center, MeshMirror mirror)
        {
            BatchView view = BatchView.Create();
            LangevinSimulation.Check(Native.lr_batch_get_view(world, batch, &view), "lr_batch_get_view");
            bool kept = valid && view.Revision == revision;
            uint wanted = kept ? Math.Max(awake, view.AwakeCount) : view.Count;
            wanted = Math.Min(wanted, view.Count);
            uint written = 0;
            float* first = (float*)NativeArrayUnsafeUtility.GetUnsafePtr(matrices);
            if (wanted > 0)
            {
                TransformFormat format = rows == 3 ? TransformFormat.Matrix3x4ColumnMajor : TransformFormat.Matrix4x4ColumnMajor;
                Status status = Native.lr_batch_write_transforms(world, batch, format, first, 0, wanted, &written);
                LangevinSimulation.Check(status, "lr_batch_write_transforms");
            }
            Count = (int)view.Count;
            Written = (int)written;
            revision = view.Revision;
            awake = view.AwakeCount;
            valid = true;
            if (written == 0) return;
            var job = new LangevinConvertJob
            {
                Matrices = first,
                Inverses = rows == 3 ? (float*)NativeArrayUnsafeUtility.GetUnsafePtr(inverses) : null,
                Chunks = (LangevinChunk*)NativeArrayUnsafeUtility.GetUnsafePtr(chunks),
                Count = Count,
                Written = Written,
                Rows = rows,
                Center = center,
                Mirror = mirror,
            };
            int dirty = (Written + LangevinConvertJob.Chunk - 1) / LangevinConvertJob.Chunk;
            job.Schedule(dirty, 4).Complete();
        }

        /// <summary>Frees the memory. Further calls do nothing.</summary>
        public void Dispose()
        {
            if (matrices.IsCreated) matrices.Dispose();
            if (inverses.IsCreated) inverses.Dispose();
            if (chunks.IsCreated) chunks.Dispose();
            Count = 0;
        }
    }
}
