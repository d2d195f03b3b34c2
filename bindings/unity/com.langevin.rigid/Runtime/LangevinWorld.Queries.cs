// SPDX-License-Identifier: MIT
using System;
using LangevinRigid;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using UnityEngine;

namespace LangevinUnity
{
    /// <summary>What a ray hit first, in Unity's world.</summary>
    public struct LangevinRayHit
    {
        /// <summary>The body; null where it is a collider.</summary>
        public BodyId body;
        /// <summary>The collider; null where it is a body, or not one of a LangevinCollider.</summary>
        public LangevinCollider collider;
        /// <summary>m, from the ray's origin.</summary>
        public float distance;
        /// <summary>m.</summary>
        public Vector3 position;
        /// <summary>Unit, out of what is hit.</summary>
        public Vector3 normal;
    }

    public sealed unsafe partial class LangevinWorld
    {
        private LangevinSimulation Idle()
        {
            if (Simulation == null) throw new InvalidOperationException("The LangevinWorld is disabled: it has no simulation.");
            CompleteStep();
            return simulation;
        }

        /// <summary>s since the world was enabled.</summary>
        public double SimulationTime { get { return Idle().Info().Time; } }

        /// <summary>Bodies in all batches.</summary>
        public long BodyCount { get { return (long)Idle().Info().BodyCount; } }

        /// <summary>Those that are not at rest.</summary>
        public long AwakeCount { get { return (long)Idle().Info().AwakeCount; } }

        /// <summary>A hash of the state of all bodies: equal on every machine after the same calls.</summary>
        public ulong Hash()
        {
            ulong hash;
            LangevinSimulation.Check(Native.lr_world_hash(Idle().Handle, &hash), "lr_world_hash");
            return hash;
        }

        /// <summary>What the last step did and what its budget left out.</summary>
        public StepReport LastStep()
        {
            StepReport report = StepReport.Create();
            LangevinSimulation.Check(Native.lr_world_get_step_report(Idle().Handle, &report), "lr_world_get_step_report");
            return report;
        }

        /// <summary>Wakes bodies at rest that reach into a box: for footsteps and explosions. How many there were.</summary>
        public int WakeBox(Bounds box)
        {
            Float3 a = LangevinConversion.ToLibrary(box.min), b = LangevinConversion.ToLibrary(box.max);
            // The mirror swaps which of both z is the lower one.
            Float3 low = new Float3(a.X, a.Y, b.Z), high = new Float3(b.X, b.Y, a.Z);
            uint woken;
            LangevinSimulation.Check(Native.lr_world_wake_box(Idle().Handle, &low.X, &high.X, &woken), "lr_world_wake_box");
            return (int)woken;
        }

        /// <summary>Velocities of the fluid, m/s, at positions: for particles and cloth. Both arrays have equal length.</summary>
        public void SampleWind(NativeArray<Vector3> positions, NativeArray<Vector3> velocities)
        {
            if (positions.Length != velocities.Length) throw new ArgumentException("The arrays differ in length.", "velocities");
            if (positions.Length == 0) return;
            IntPtr handle = Idle().Handle;
            var from = (Vector3*)NativeArrayUnsafeUtility.GetUnsafeReadOnlyPtr(positions);
            var to = (Vector3*)NativeArrayUnsafeUtility.GetUnsafePtr(velocities);
            for (int i = 0; i < positions.Length; ++i) to[i] = new Vector3(from[i].x, from[i].y, -from[i].z);
            Status status = Native.lr_world_sample_wind(handle, (float*)to, (uint)positions.Length, (float*)to);
            LangevinSimulation.Check(status, "lr_world_sample_wind");
            for (int i = 0; i < velocities.Length; ++i) to[i].z = -to[i].z;
        }

        /// <summary>The velocity of the fluid at a position, m/s.</summary>
        public Vector3 SampleWind(Vector3 position)
        {
            Float3 p = LangevinConversion.ToLibrary(position), v = default(Float3);
            LangevinSimulation.Check(Native.lr_world_sample_wind(Idle().Handle, &p.X, 1, &v.X), "lr_world_sample_wind");
            return LangevinConversion.ToUnity(v);
        }

        /// <summary>What a ray hits first of bodies and colliders. False where that is nothing.</summary>
        public bool Raycast(Vector3 origin, Vector3 direction, float maxDistance, out LangevinRayHit hit)
        {
            LangevinRigid.Ray ray = LangevinRigid.Ray.Create();
            ray.Origin = LangevinConversion.ToLibrary(origin);
            ray.Direction = LangevinConversion.ToLibrary(direction);
            ray.MaxDistance = maxDistance;
            RayHit native;
            LangevinSimulation.Check(Native.lr_world_ray_cast(Idle().Handle, &ray, 1, &native), "lr_world_ray_cast");
            hit = default(LangevinRayHit);
            if (native.Body.IsNull && native.Collider.IsNull) return false;
            hit.body = native.Body;
            hit.collider = native.Collider.IsNull ? null : ColliderOf(native.Collider);
            hit.distance = native.Distance;
            hit.position = LangevinConversion.ToUnity(native.Position);
            hit.normal = LangevinConversion.ToUnity(native.Normal);
            return true;
        }

        /// <summary>The world's state, to be put back by RestoreSnapshot: into this world, or one with the same batches.</summary>
        public byte[] SaveSnapshot()
        {
            IntPtr handle = Idle().Handle;
            var bytes = new byte[Native.lr_world_snapshot_size(handle)];
            ulong written;
            fixed (byte* first = bytes)
                LangevinSimulation.Check(Native.lr_world_snapshot_save(handle, first, (ulong)bytes.Length, &written), "lr_world_snapshot_save");
            if (written < (ulong)bytes.Length) Array.Resize(ref bytes, (int)written);
            return bytes;
        }

        /// <summary>Puts a saved state back. Changes nothing if it does not fit.</summary>
        public void RestoreSnapshot(byte[] bytes)
        {
            if (bytes == null) throw new ArgumentNullException("bytes");
            IntPtr handle = Idle().Handle;
            fixed (byte* first = bytes)
                LangevinSimulation.Check(Native.lr_world_snapshot_restore(handle, first, (ulong)bytes.Length), "lr_world_snapshot_restore");
            stepped = true;
        }

        internal LangevinCollider ColliderOf(ColliderId id)
        {
            foreach (LangevinMember member in Members)
            {
                var collider = member as LangevinCollider;
                if (collider != null && collider.Id == id) return collider;
            }
            return null;
        }

        internal LangevinBatch BatchOf(BatchId id)
        {
            foreach (LangevinMember member in Members)
            {
                var batch = member as LangevinBatch;
                if (batch != null && batch.Id == id) return batch;
            }
            return null;
        }
    }
}
