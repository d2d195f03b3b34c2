// SPDX-License-Identifier: MIT
using System;
using System.Runtime.InteropServices;
using LangevinRigid;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using Unity.Jobs;
#if LANGEVIN_BURST
using Unity.Burst;
#endif

namespace LangevinUnity
{
    /// <summary>The library's functions that jobs call. They are in a class without static constructors and delegates because Burst compiles
    /// only direct calls with pointers.</summary>
    internal static unsafe class LangevinJobCalls
    {
        [DllImport(Native.Library, CallingConvention = CallingConvention.Cdecl)]
        internal static extern int lr_world_step(IntPtr world, float dt, uint substeps);
    }

    /// <summary>Steps a world. Until it ends, no other code may use that world.</summary>
#if LANGEVIN_BURST
    [BurstCompile]
#endif
    internal struct LangevinStepJob : IJob
    {
        [NativeDisableUnsafePtrRestriction] public IntPtr World;
        public float Dt;
        public uint Substeps;
        public NativeArray<int> Status;

        public void Execute()
        {
            Status[0] = LangevinJobCalls.lr_world_step(World, Dt, Substeps);
        }
    }

    /// <summary>Converts chunks of matrices to Unity's, and computes their bounds and, if packed, their inverses.</summary>
#if LANGEVIN_BURST
    [BurstCompile]
#endif
    internal unsafe struct LangevinConvertJob : IJobParallelFor
    {
        public const int Chunk = 1023;

        [NativeDisableUnsafePtrRestriction] public float* Matrices;
        [NativeDisableUnsafePtrRestriction] public float* Inverses;
        [NativeDisableUnsafePtrRestriction] public LangevinChunk* Chunks;
        public int Count;
        public int Written;
        public int Rows;
        public Float3 Center;
        public MeshMirror Mirror;

        public void Execute(int chunk)
        {
            int begin = chunk * Chunk;
            int end = begin + Chunk < Count ? begin + Chunk : Count;
            int fresh = (Written < end ? Written : end) - begin;
            int floats = 4 * Rows;
            if (fresh > 0)
            {
                LangevinConversion.MatricesToUnity(Matrices + (long)begin * floats, fresh, Rows, Center, Mirror);
                if (Inverses != null) LangevinConversion.InvertPacked(Matrices + (long)begin * 12, Inverses + (long)begin * 12, fresh);
            }
            Chunks[chunk] = LangevinChunk.Of(Matrices + (long)begin * floats, end - begin, Rows);
        }
    }

    /// <summary>A box around the positions of a chunk, and its largest scale.</summary>
    internal unsafe struct LangevinChunk
    {
        public Float3 Min;
        public Float3 Max;
        public float Scale;

        public static LangevinChunk Of(float* matrices, int count, int rows)
        {
            float* t = matrices + 3 * rows;
            var box = new LangevinChunk { Min = new Float3(t[0], t[1], t[2]), Max = new Float3(t[0], t[1], t[2]) };
            float squared = 0.0f;
            for (int i = 0; i < count; ++i)
            {
                float* x = matrices + (long)i * 4 * rows;
                t = x + 3 * rows;
                if (t[0] < box.Min.X) box.Min.X = t[0];
                if (t[1] < box.Min.Y) box.Min.Y = t[1];
                if (t[2] < box.Min.Z) box.Min.Z = t[2];
                if (t[0] > box.Max.X) box.Max.X = t[0];
                if (t[1] > box.Max.Y) box.Max.Y = t[1];
                if (t[2] > box.Max.Z) box.Max.Z = t[2];
                float s = x[0] * x[0] + x[1] * x[1] + x[2] * x[2];
                if (s > squared) squared = s;
            }
            box.Scale = (float)Math.Sqrt(squared);
            return box;
        }
    }
}
