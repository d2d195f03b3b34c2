// SPDX-License-Identifier: MIT
#if NETSTANDARD2_1 || NETSTANDARD2_1_OR_GREATER || NETCOREAPP || UNITY_2021_2_OR_NEWER
#define LANGEVIN_SPAN
#endif
#if LANGEVIN_SPAN
using System;
using System.Runtime.InteropServices;

namespace LangevinRigid
{
    // Overloads for spans.
    public sealed unsafe partial class World
    {
        /// <summary><see cref="DestroyBodies(BodyId[])"/></summary>
        public void DestroyBodies(ReadOnlySpan<BodyId> bodies)
        {
            fixed (BodyId* first = &MemoryMarshal.GetReference(bodies)) DestroyBodies(first, bodies.Length);
        }

        /// <summary><see cref="SetSleep(BodyId[], SleepState)"/></summary>
        public void SetSleep(ReadOnlySpan<BodyId> bodies, SleepState rest)
        {
            fixed (BodyId* first = &MemoryMarshal.GetReference(bodies)) SetSleep(first, bodies.Length, rest);
        }

        /// <summary><see cref="AddForces(BodyForce[])"/></summary>
        public void AddForces(ReadOnlySpan<BodyForce> forces)
        {
            fixed (BodyForce* first = &MemoryMarshal.GetReference(forces)) AddForces(first, forces.Length);
        }

        /// <summary><see cref="CreateColliders(ColliderDesc[])"/>; <paramref name="ids"/> has the length of <paramref name="descs"/>, or is
        /// empty.</summary>
        public void CreateColliders(ReadOnlySpan<ColliderDesc> descs, Span<ColliderId> ids)
        {
            if (!ids.IsEmpty && ids.Length < descs.Length) throw new ArgumentException("It has no room for all ids.", "ids");
            fixed (ColliderDesc* first = &MemoryMarshal.GetReference(descs))
            fixed (ColliderId* to = &MemoryMarshal.GetReference(ids)) CreateColliders(first, descs.Length, ids.IsEmpty ? null : to);
        }

        /// <summary><see cref="DestroyColliders(ColliderId[])"/></summary>
        public void DestroyColliders(ReadOnlySpan<ColliderId> colliders)
        {
            fixed (ColliderId* first = &MemoryMarshal.GetReference(colliders)) DestroyColliders(first, colliders.Length);
        }

        /// <summary><see cref="MoveColliders(ColliderMotion[], int)"/></summary>
        public void MoveColliders(ReadOnlySpan<ColliderMotion> motions)
        {
            fixed (ColliderMotion* first = &MemoryMarshal.GetReference(motions)) MoveColliders(first, motions.Length);
        }

        /// <summary><see cref="RayCast(Ray[], RayHit[])"/></summary>
        public void RayCast(ReadOnlySpan<Ray> rays, Span<RayHit> hits)
        {
            if (hits.Length < rays.Length) throw new ArgumentException("It has no room for all hits.", "hits");
            fixed (Ray* from = &MemoryMarshal.GetReference(rays))
            fixed (RayHit* to = &MemoryMarshal.GetReference(hits)) RayCast(from, rays.Length, to);
        }

        /// <summary><see cref="SampleWind(Float3[], Float3[])"/></summary>
        public void SampleWind(ReadOnlySpan<Float3> positions, Span<Float3> velocities)
        {
            if (velocities.Length < positions.Length) throw new ArgumentException("It has no room for all velocities.", "velocities");
            fixed (Float3* from = &MemoryMarshal.GetReference(positions))
            fixed (Float3* to = &MemoryMarshal.GetReference(velocities)) SampleWind((float*)from, positions.Length, (float*)to);
        }

        /// <summary><see cref="TryOverlap(OverlapDesc, BodyId*, int, out int)"/></summary>
        public bool TryOverlap(OverlapDesc desc, Span<BodyId> bodies, out int count)
        {
            fixed (BodyId* first = &MemoryMarshal.GetReference(bodies)) return TryOverlap(desc, first, bodies.Length, out count);
        }

        /// <summary><see cref="SaveSnapshot(void*, ulong)"/></summary>
        public int SaveSnapshot(Span<byte> memory)
        {
            fixed (byte* first = &MemoryMarshal.GetReference(memory)) return (int)SaveSnapshot(first, (ulong)memory.Length);
        }

        /// <summary><see cref="RestoreSnapshot(byte[])"/></summary>
        public void RestoreSnapshot(ReadOnlySpan<byte> memory)
        {
            byte none;
            fixed (byte* first = &MemoryMarshal.GetReference(memory)) RestoreSnapshot(first == null ? &none : first, (ulong)memory.Length);
        }
    }

    public sealed unsafe partial class Batch
    {
        /// <summary><see cref="CreateBodies(BodyDesc[])"/>; <paramref name="ids"/> has the length of <paramref name="descs"/>, or is empty.</summary>
        public void CreateBodies(ReadOnlySpan<BodyDesc> descs, Span<BodyId> ids)
        {
            if (!ids.IsEmpty && ids.Length < descs.Length) throw new ArgumentException("It has no room for all ids.", "ids");
            fixed (BodyDesc* first = &MemoryMarshal.GetReference(descs))
            fixed (BodyId* to = &MemoryMarshal.GetReference(ids)) CreateBodies(first, descs.Length, ids.IsEmpty ? null : to);
        }

        /// <summary><see cref="Emit(int)"/></summary>
        public void Emit(Span<BodyId> ids)
        {
            fixed (BodyId* to = &MemoryMarshal.GetReference(ids)) Emit(ids.Length, to);
        }

        /// <summary><see cref="WriteTransforms(TransformFormat, float[])"/></summary>
        public int WriteTransforms(TransformFormat format, Span<float> to)
        {
            fixed (float* first = &MemoryMarshal.GetReference(to)) return WriteTransforms(format, first, 0, to.Length / FloatsOf(format));
        }

        /// <summary><see cref="WriteTransforms(TransformFormat, float[])"/> into a mapped buffer.</summary>
        public int WriteTransforms(TransformFormat format, Span<byte> to)
        {
            fixed (byte* first = &MemoryMarshal.GetReference(to)) return WriteTransforms(format, first, 0, to.Length / SizeOf(format));
        }

        /// <summary><see cref="WriteVelocities(Float3[])"/></summary>
        public int WriteVelocities(Span<Float3> to)
        {
            fixed (Float3* first = &MemoryMarshal.GetReference(to)) return WriteVelocities(first, 0, to.Length / 2);
        }

        /// <summary>Adds forces from a span per axis with a value per body; all three empty for no force.</summary>
        public void AddForces(ForceMode mode, ForceFrame frame, ReadOnlySpan<float> x, ReadOnlySpan<float> y, ReadOnlySpan<float> z)
        {
            if (x.Length != y.Length || x.Length != z.Length) throw new ArgumentException("All axes have a value for each body.");
            if (x.IsEmpty) return;
            ForceArrays arrays = ForceArrays.Create();
            arrays.Mode = mode;
            arrays.Frame = frame;
            arrays.Count = (uint)x.Length;
            fixed (float* onX = &MemoryMarshal.GetReference(x))
            fixed (float* onY = &MemoryMarshal.GetReference(y))
            fixed (float* onZ = &MemoryMarshal.GetReference(z))
            {
                arrays.ForceX = onX;
                arrays.ForceY = onY;
                arrays.ForceZ = onZ;
                AddForces(arrays);
            }
        }
    }

    public sealed unsafe partial class Asset
    {
        /// <summary><see cref="Load(byte[])"/></summary>
        public static Asset Load(ReadOnlySpan<byte> bytes)
        {
            fixed (byte* first = &MemoryMarshal.GetReference(bytes)) return Load(first, (ulong)bytes.Length);
        }
    }

    public unsafe partial struct EventList
    {
        /// <summary><see cref="Events"/> as a span.</summary>
        public ReadOnlySpan<BodyEvent> EventSpan { get { return new ReadOnlySpan<BodyEvent>(Events, (int)Count); } }
    }
}
#endif
