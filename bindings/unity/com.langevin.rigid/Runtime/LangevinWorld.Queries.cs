// SPDX-License-Identifier: MIT
using System;
using LangevinRigid;
using Unity.Collections;
using Unity.Collections.LowLevel.Unsafe;
using UnityEngine;

namespace LangevinUnity
{
    /// <summary>The first hit of a ray, in Unity's world.</summary>
    public struct LangevinRayHit
    {
        /// <summary>The hit body; null if the ray hit a collider.</summary>
        public BodyId body;
        /// <summary>The hit collider; null if the ray hit a body, or a collider without a LangevinCollider.</summary>
        public LangevinCollider collider;
        /// <summary>Distance from the ray's origin, m.</summary>
        public float distance;
        /// <summary>The hit point, m.</summary>
        public Vector3 position;
        /// <summary>Unit normal of the hit surface, outward.</summary>
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

        /// <summary>Time since the world was enabled, s.</summary>
        public double SimulationTime { get { return Idle().Info().Time; } }

        /// <summary>The number of bodies in all batches.</summary>
        public long BodyCount { get { return (long)Idle().Info().BodyCount; } }

        /// <summary>The number of awake bodies.</summary>
        public long AwakeCount { get { return (long)Idle().Info().AwakeCount; } }

        /// <summary>A hash of the state of all bodies: equal on every machine after the same calls.</summary>
        public ulong Hash()
        {
            ulong hash;
            LangevinSimulation.Check(Native.lr_world_hash(Idle().Handle, &hash), "lr_world_hash");
            return hash;
        }

        /// <summary>The work of the last step, and the work beyond its budget.</summary>
        public StepReport LastStep()
        {
            StepReport report = StepReport.Create();
            LangevinSimulation.Check(Native.lr_world_get_step_report(Idle().Handle, &report), "lr_world_get_step_report");
            return report;
        }

        /// <summary>Wakes sleeping bodies that overlap a box, for footsteps and explosions. Returns their number.</summary>
        public int WakeBox(Bounds box)
        {
            Float3 a = LangevinConversion.ToLibrary(box.min), b = LangevinConversion.ToLibrary(box.max);
            // The mirror in z exchanges lower and upper z.
            Float3 low = new Float3(a.X, a.Y, b.Z), high = new Float3(b.X, b.Y, a.Z);
            uint woken;
            LangevinSimulation.Check(Native.lr_world_wake_box(Idle().Handle, &low.X, &high.X, &woken), "lr_world_wake_box");
            return (int)woken;
        }

        /// <summary>The fluid's velocities at positions, m/s, for particles and cloth. Both arrays need equal length.</summary>
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

        /// <summary>The fluid's velocity at a position, m/s.</summary>
        public Vector3 SampleWind(Vector3 position)
        {
            Float3 p = LangevinConversion.ToLibrary(position), v = default(Float3);
            LangevinSimulation.Check(Native.lr_world_sample_wind(Idle().Handle, &p.X, 1, &v.X), "lr_world_sample_wind");
            return LangevinConversion.ToUnity(v);
        }

        /// <summary>Finds the first body or collider hit by a ray; false without a hit.</summary>
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

        /// <summary>Saves the world's state for RestoreSnapshot, in this world or in one with the same batches.</summary>
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

        /// <summary>Restores a saved state. A snapshot of another world changes nothing. In the next step, colliders
        /// and winds follow the scene as it is then.</summary>
        public void RestoreSnapshot(byte[] bytes)
        {
            if (bytes == null) throw new ArgumentNullException("bytes");
            IntPtr handle = Idle().Handle;
            fixed (byte* first = bytes)
                LangevinSimulation.Check(Native.lr_world_snapshot_restore(handle, first, (ulong)bytes.Length), "lr_world_snapshot_restore");
            stepped = true;
            simulation.RemoveGone();
            foreach (LangevinMember member in Members) member.OnRestored(simulation);
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
