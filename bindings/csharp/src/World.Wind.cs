// SPDX-License-Identifier: MIT
using System;

namespace LangevinRigid
{
    public sealed unsafe partial class World
    {
        /// <summary>The uniform part of the wind: m/s.</summary>
        public void SetWind(Float3 velocity)
        {
            WindDesc desc = WindDesc.Create();
            desc.Velocity = velocity;
            SetWind(desc);
        }

        /// <summary>The uniform part of the wind. A change is spread evenly over the next step.</summary>
        public void SetWind(WindDesc desc)
        {
            Leave(Native.lr_world_set_wind(EnterChange(), &desc), "lr_world_set_wind");
        }

        /// <summary>Still fluid, but for the sources.</summary>
        public void ClearWind()
        {
            Leave(Native.lr_world_set_wind(EnterChange(), null), "lr_world_set_wind");
        }

        /// <summary>Adds gusts, a vortex, a blower, turbulence, a grid or a ground profile. A grid's <see
        /// cref="WindSourceDesc.Samples"/> are copied.</summary>
        public WindSourceId AddWind(WindSourceDesc desc)
        {
            WindSourceId source;
            Leave(Native.lr_world_add_wind(EnterChange(), &desc, &source), "lr_world_add_wind");
            return source;
        }

        /// <summary>A grid from an array: x, y and z of each sample, x fastest, then y, z and frame; as many as <see
        /// cref="WindSourceDesc.Counts"/> and <see cref="WindSourceDesc.Frames"/> say.</summary>
        public WindSourceId AddWind(WindSourceDesc desc, float[] samples)
        {
            CheckSamples(desc, samples);
            fixed (float* first = samples)
            {
                desc.Samples = first;
                return AddWind(desc);
            }
        }

        /// <summary>Replaces everything of a source, also its kind. A grid without samples keeps those that it has.</summary>
        public void UpdateWind(WindSourceId source, WindSourceDesc desc)
        {
            Leave(Native.lr_world_update_wind(EnterChange(), source, &desc), "lr_world_update_wind");
        }

        /// <summary>The same, with samples of a grid from an array.</summary>
        public void UpdateWind(WindSourceId source, WindSourceDesc desc, float[] samples)
        {
            CheckSamples(desc, samples);
            fixed (float* first = samples)
            {
                desc.Samples = first;
                UpdateWind(source, desc);
            }
        }

        /// <summary>Takes a source away.</summary>
        public void RemoveWind(WindSourceId source)
        {
            Leave(Native.lr_world_remove_wind(EnterChange(), source), "lr_world_remove_wind");
        }

        /// <summary>A field of the program's own, added to all else; null removes it. The world holds on to it.</summary>
        public void SetWindField(WindField field)
        {
            IntPtr world = EnterChange();
            _callbacks.Wind = field;
            Leave(Native.lr_world_set_wind_callback(world, field == null ? IntPtr.Zero : WorldCallbacks.Pointers.Wind, _callbacks.User),
                "lr_world_set_wind_callback");
        }

        /// <summary>The fluid's velocity at <paramref name="count"/> positions x, y, z; both may be the same memory.</summary>
        public void SampleWind(float* positions, int count, float* velocities)
        {
            uint number = Counts.Of(count);
            Leave(Native.lr_world_sample_wind(Enter(), positions, number, velocities), "lr_world_sample_wind");
        }

        /// <summary>The same for arrays of equal length.</summary>
        public void SampleWind(Float3[] positions, Float3[] velocities)
        {
            if (positions == null) throw new ArgumentNullException("positions");
            Counts.CheckRoom(velocities, "velocities", positions.Length);
            fixed (Float3* from = positions)
            fixed (Float3* to = velocities) SampleWind((float*)from, positions.Length, (float*)to);
        }

        /// <summary>The fluid's velocity at a point.</summary>
        public Float3 SampleWind(Float3 position)
        {
            var velocity = default(Float3);
            SampleWind(&position.X, 1, &velocity.X);
            return velocity;
        }

        /// <summary>A second fluid under a surface: water. From the next step on.</summary>
        public void SetSurface(SurfaceDesc desc)
        {
            Leave(Native.lr_world_set_surface(EnterChange(), &desc), "lr_world_set_surface");
        }

        /// <summary>Takes the water away.</summary>
        public void ClearSurface()
        {
            Leave(Native.lr_world_set_surface(EnterChange(), null), "lr_world_set_surface");
        }

        /// <summary>A water surface of the program's own, while there is a surface; null removes it. The world holds on to it.</summary>
        public void SetSurfaceField(SurfaceField field)
        {
            IntPtr world = EnterChange();
            _callbacks.Surface = field;
            Leave(Native.lr_world_set_surface_callback(world, field == null ? IntPtr.Zero : WorldCallbacks.Pointers.Surface, _callbacks.User),
                "lr_world_set_surface_callback");
        }

        private static void CheckSamples(WindSourceDesc desc, float[] samples)
        {
            if (samples == null) throw new ArgumentNullException("samples");
            double wanted = 3.0 * desc.Counts.X * desc.Counts.Y * desc.Counts.Z * desc.Frames;
            if (samples.Length != wanted)
                throw new ArgumentException("Counts and Frames ask for " + wanted + " values, 3 a sample; there are " + samples.Length + ".", "samples");
        }
    }
}
