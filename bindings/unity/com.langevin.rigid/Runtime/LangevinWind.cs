// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using LangevinRigid;
using UnityEngine;

namespace LangevinUnity
{
    /// <summary>Wind from a WindZone of the same GameObject. Directional zones add to the uniform wind along their forward axis. Spherical
    /// zones blow outward; their wind falls to 0 at the radius.</summary>
    [AddComponentMenu("Langevin Rigid/Langevin Wind")]
    [RequireComponent(typeof(WindZone))]
    public sealed unsafe class LangevinWind : LangevinMember
    {
        private const int Frames = 8;

        [Tooltip("Wind speed for a Main of 1, m/s.")]
        [SerializeField, Min(0.0f)] private float speedScale = 1.0f;
        [Tooltip("Size of the largest eddies of Turbulence, m.")]
        [SerializeField, Min(0.01f)] private float eddySize = 2.0f;
        [Tooltip("Wind samples along each axis of a spherical zone.")]
        [SerializeField, Range(5, 33)] private int resolution = 17;
        [SerializeField] private int seed = 1;

        private WindZone zone;
        private WindSourceId eddies;
        private WindSourceId sphere;
        private TurbulenceDesc eddiesSet;
        private Shape shapeSet;
        private Vector3 positionSet;

        // Parameters of a spherical zone's samples; its position is separate.
        private struct Shape : IEquatable<Shape>
        {
            public float Radius, Speed, Pulse, Frequency;
            public int Resolution;

            public bool Equals(Shape other)
            {
                return Radius == other.Radius && Speed == other.Speed && Pulse == other.Pulse && Frequency == other.Frequency &&
                    Resolution == other.Resolution;
            }
        }

        /// <summary>Wind speed for a Main of 1, m/s.</summary>
        public float SpeedScale { get { return speedScale; } set { speedScale = value; } }

        /// <summary>Size of the largest eddies, m.</summary>
        public float EddySize { get { return eddySize; } set { eddySize = value; } }

        internal override void OnJoin(LangevinSimulation simulation)
        {
            zone = GetComponent<WindZone>();
            Synchronize(simulation);
        }

        internal override void OnLeave(LangevinSimulation simulation)
        {
            Remove(simulation, ref eddies);
            Remove(simulation, ref sphere);
            Apply(World, this);
        }

        protected override void OnDisable()
        {
            base.OnDisable();
            // If the world was destroyed first, its sources are gone.
            eddies = default(WindSourceId);
            sphere = default(WindSourceId);
        }

        // Reads what there is, to update only what differs: an update starts eddies and pulses anew.
        internal override void OnRestored(LangevinSimulation simulation)
        {
            TurbulenceDesc seen = TurbulenceDesc.Create();
            if (!eddies.IsNull && Native.lr_wind_source_is_valid(simulation.Handle, eddies) == 0) eddies = default(WindSourceId);
            if (!eddies.IsNull)
                LangevinSimulation.Check(Native.lr_world_get_turbulence(simulation.Handle, eddies, &seen), "lr_world_get_turbulence");
            eddiesSet = seen;
            WindGridDesc grid = WindGridDesc.Create();
            if (!sphere.IsNull && Native.lr_wind_source_is_valid(simulation.Handle, sphere) == 0) sphere = default(WindSourceId);
            if (sphere.IsNull) return;
            LangevinSimulation.Check(Native.lr_world_get_wind_grid(simulation.Handle, sphere, &grid), "lr_world_get_wind_grid");
            if (!grid.Position.Equals(CornerOf(positionSet, shapeSet))) shapeSet = default(Shape);
        }

        internal override void BeforeStep(LangevinSimulation simulation, float dt) { Synchronize(simulation); }

        /// <summary>The velocity of a directional zone at the world's time, m/s: Main, varied by Pulse Magnitude at Pulse
        /// Frequency.</summary>
        public Vector3 VelocityAt(double time)
        {
            if (zone == null || zone.mode != WindZoneMode.Directional) return Vector3.zero;
            double pulse = 1.0 + zone.windPulseMagnitude * Math.Sin(2.0 * Math.PI * zone.windPulseFrequency * time);
            return transform.forward * (float)(zone.windMain * speedScale * Math.Max(0.0, pulse));
        }

        /// <summary>Sets the world's uniform wind to the sum of its directional zones, without the leaving one.</summary>
        internal static void Apply(LangevinWorld world, LangevinWind leaving = null)
        {
            LangevinSimulation simulation = world.Simulation;
            Vector3 sum = Vector3.zero;
            bool any = false;
            foreach (LangevinMember member in world.Members)
            {
                var wind = member as LangevinWind;
                if (wind == null) continue;
                any = true;
                if (wind == leaving) continue;
                sum += wind.VelocityAt(simulation.Info().Time);
            }
            // A world without directional zones keeps the wind set by scripts.
            if (!any) return;
            Float3 uniform = LangevinConversion.ToLibrary(sum);
            LangevinSimulation.Check(Native.lr_world_set_uniform_wind(simulation.Handle, uniform.X, uniform.Y, uniform.Z), "lr_world_set_uniform_wind");
        }

        private void Synchronize(LangevinSimulation simulation)
        {
            float rms = Mathf.Abs(zone.windTurbulence * zone.windMain) * speedScale;
            if (rms > 0.0f) SynchronizeEddies(simulation, rms);
            else Remove(simulation, ref eddies);
            if (zone.mode == WindZoneMode.Spherical && zone.radius > 0.0f && zone.windMain != 0.0f) SynchronizeSphere(simulation);
            else Remove(simulation, ref sphere);
        }

        private void SynchronizeEddies(LangevinSimulation simulation, float rms)
        {
            TurbulenceDesc desc = TurbulenceDesc.Create();
            desc.Rms = rms;
            desc.IntegralLength = Mathf.Max(eddySize, 0.01f);
            desc.Octaves = 3;
            desc.Seed = (uint)seed;
            if (!eddies.IsNull && desc.Rms == eddiesSet.Rms && desc.IntegralLength == eddiesSet.IntegralLength && desc.Seed == eddiesSet.Seed) return;
            WindSourceId id = eddies;
            if (id.IsNull) LangevinSimulation.Check(Native.lr_world_add_turbulence(simulation.Handle, &desc, &id), "lr_world_add_turbulence");
            else LangevinSimulation.Check(Native.lr_world_update_turbulence(simulation.Handle, id, &desc), "lr_world_update_turbulence");
            eddies = id;
            simulation.GoneWinds.Remove(id);
            eddiesSet = desc;
        }

        private void SynchronizeSphere(LangevinSimulation simulation)
        {
            var shape = new Shape
            {
                Radius = zone.radius,
                Speed = zone.windMain * speedScale,
                Pulse = zone.windPulseMagnitude,
                Frequency = zone.windPulseFrequency,
                Resolution = Mathf.Max(5, resolution),
            };
            bool same = !sphere.IsNull && shape.Equals(shapeSet);
            if (same && transform.position == positionSet) return;
            float[] samples = same ? null : Samples(shape);
            WindGridDesc desc = WindGridDesc.Create();
            float spacing = 2.0f * shape.Radius / (shape.Resolution - 1);
            desc.Position = CornerOf(transform.position, shape);
            desc.Spacing = new Float3(spacing, spacing, spacing);
            desc.Counts = new UInt3((uint)shape.Resolution, (uint)shape.Resolution, (uint)shape.Resolution);
            desc.Frames = FramesOf(shape);
            desc.FrameTime = Pulses(shape) ? 1.0f / (shape.Frequency * Frames) : 1.0f;
            desc.Outside = WindOutside.Zero;
            fixed (float* first = samples)
            {
                desc.Samples = first;
                WindSourceId id = sphere;
                if (id.IsNull) LangevinSimulation.Check(Native.lr_world_add_wind_grid(simulation.Handle, &desc, &id), "lr_world_add_wind_grid");
                else LangevinSimulation.Check(Native.lr_world_update_wind_grid(simulation.Handle, id, &desc), "lr_world_update_wind_grid");
                sphere = id;
                simulation.GoneWinds.Remove(id);
            }
            shapeSet = shape;
            positionSet = transform.position;
        }

        // The first sample is the corner with the least coordinates in the library's frame. The samples are symmetric, so mirroring keeps their order.
        private static Float3 CornerOf(Vector3 at, Shape shape)
        {
            Float3 middle = LangevinConversion.ToLibrary(at);
            return new Float3(middle.X - shape.Radius, middle.Y - shape.Radius, middle.Z - shape.Radius);
        }

        private static bool Pulses(Shape shape) { return shape.Pulse != 0.0f && shape.Frequency > 0.0f; }

        private static uint FramesOf(Shape shape) { return Pulses(shape) ? (uint)Frames : 1u; }

        // The velocity points outward and falls linearly from the middle to the radius. The frames hold one period of the pulse.
        private static float[] Samples(Shape shape)
        {
            int n = shape.Resolution, frames = (int)FramesOf(shape), at = 0;
            float half = 0.5f * (n - 1);
            var samples = new float[3 * n * n * n * frames];
            for (int frame = 0; frame < frames; ++frame)
            {
                double pulse = frames > 1 ? Math.Max(0.0, 1.0 + shape.Pulse * Math.Sin(2.0 * Math.PI * frame / frames)) : 1.0;
                for (int k = 0; k < n; ++k)
                    for (int j = 0; j < n; ++j)
                        for (int i = 0; i < n; ++i, at += 3)
                        {
                            var r = new Vector3((i - half) / half, (j - half) / half, (k - half) / half);
                            float length = r.magnitude;
                            if (length <= 0.0f || length >= 1.0f) continue;
                            float speed = (float)(shape.Speed * pulse) * (1.0f - length) / length;
                            samples[at] = r.x * speed;
                            samples[at + 1] = r.y * speed;
                            samples[at + 2] = r.z * speed;
                        }
            }
            return samples;
        }

        private static void Remove(LangevinSimulation simulation, ref WindSourceId id)
        {
            if (id.IsNull) return;
            WindSourceId gone = id;
            id = default(WindSourceId);
            simulation.GoneWinds.Add(gone);
            LangevinSimulation.Check(Native.lr_world_remove_wind(simulation.Handle, gone), "lr_world_remove_wind");
        }

#if UNITY_EDITOR
        private void OnDrawGizmosSelected()
        {
            var seen = GetComponent<WindZone>();
            if (seen == null) return;
            Gizmos.color = new Color(0.4f, 0.7f, 1.0f, 0.9f);
            if (seen.mode == WindZoneMode.Directional) Gizmos.DrawRay(transform.position, transform.forward * (seen.windMain * speedScale));
            else Gizmos.DrawWireSphere(transform.position, seen.radius);
        }
#endif
    }
}
