// SPDX-License-Identifier: MIT
using System;

namespace LangevinRigid
{
    public sealed unsafe partial class World
    {
        /// <summary>Sets the uniform wind, m/s. A change is spread evenly over the next step.</summary>
        public void SetUniformWind(Float3 velocity)
        {
            Leave(Native.lr_world_set_uniform_wind(EnterChange(), velocity.X, velocity.Y, velocity.Z), "lr_world_set_uniform_wind");
        }

        /// <summary>The uniform wind last set, m/s.</summary>
        public Float3 GetUniformWind()
        {
            var velocity = default(Float3);
            Leave(Native.lr_world_get_uniform_wind(Enter(), &velocity.X), "lr_world_get_uniform_wind");
            return velocity;
        }

        /// <summary>Adds a grid from an array: x, y and z of each sample, x fastest, then y, z and frame. <see
        /// cref="WindGridDesc.Counts"/> and <see cref="WindGridDesc.Frames"/> give its length.</summary>
        public WindSourceId AddWindGrid(WindGridDesc desc, float[] samples)
        {
            CheckSamples(desc, samples);
            fixed (float* first = samples)
            {
                desc.Samples = first;
                return AddWindGrid(desc);
            }
        }

        /// <summary>Replaces all values of a grid, with samples from an array.</summary>
        public void UpdateWindGrid(WindSourceId source, WindGridDesc desc, float[] samples)
        {
            CheckSamples(desc, samples);
            fixed (float* first = samples)
            {
                desc.Samples = first;
                UpdateWindGrid(source, desc);
            }
        }

        /// <summary>Removes a source.</summary>
        public void RemoveWind(WindSourceId source)
        {
            Leave(Native.lr_world_remove_wind(EnterChange(), source), "lr_world_remove_wind");
        }

        /// <summary>Whether a source exists; false for a removed source and for the null handle.</summary>
        public bool IsValid(WindSourceId source)
        {
            int valid = Native.lr_wind_source_is_valid(Enter(), source);
            Leave(Status.Ok, "lr_wind_source_is_valid");
            return valid != 0;
        }

        /// <summary>Sets the program's wind field, which adds to other wind; null removes it. The world keeps it alive.</summary>
        public void SetWindField(WindField field)
        {
            IntPtr world = EnterChange();
            _callbacks.Wind = field;
            Leave(Native.lr_world_set_wind_callback(world, field == null ? IntPtr.Zero : WorldCallbacks.Pointers.Wind, _callbacks.User),
                "lr_world_set_wind_callback");
        }

        /// <summary>The fluid's velocity at <paramref name="count"/> positions x, y, z. Both pointers can be the same.</summary>
        public void SampleWind(float* positions, int count, float* velocities)
        {
            uint number = Counts.Of(count);
            Leave(Native.lr_world_sample_wind(Enter(), positions, number, velocities), "lr_world_sample_wind");
        }

        /// <summary>The fluid's velocity at the positions of an array; both arrays need equal length.</summary>
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

        /// <summary>Reads the water's settings; false without water.</summary>
        public bool TryGetWater(out WaterDesc desc)
        {
            int present;
            var found = new WaterDesc { StructSize = (uint)sizeof(WaterDesc) };
            Leave(Native.lr_world_get_water(Enter(), &found, &present), "lr_world_get_water");
            desc = found;
            return present != 0;
        }

        /// <summary>Sets the program's water surface, used while water is set; null removes it. The world keeps it alive.</summary>
        public void SetWaterField(WaterField field)
        {
            IntPtr world = EnterChange();
            _callbacks.Surface = field;
            Leave(Native.lr_world_set_water_callback(world, field == null ? IntPtr.Zero : WorldCallbacks.Pointers.Surface, _callbacks.User),
                "lr_world_set_water_callback");
        }

        private static void CheckSamples(WindGridDesc desc, float[] samples)
        {
            if (samples == null) throw new ArgumentNullException("samples");
            double wanted = 3.0 * desc.Counts.X * desc.Counts.Y * desc.Counts.Z * desc.Frames;
            if (samples.Length != wanted)
                throw new ArgumentException("Counts and Frames ask for " + wanted + " values, 3 a sample; there are " + samples.Length + ".", "samples");
        }
    }
}
