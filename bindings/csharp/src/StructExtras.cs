// SPDX-License-Identifier: MIT
#if NETSTANDARD2_1 || NETSTANDARD2_1_OR_GREATER || NETCOREAPP || UNITY_2021_2_OR_NEWER
#define LANGEVIN_SPAN
#endif
using System;

namespace LangevinRigid
{
    public unsafe partial struct AssetInfo
    {
        /// <summary><see cref="Name"/> as a string.</summary>
        public string NameText
        {
            get { fixed (byte* name = Name) return Utf8.Read(name, 64); }
        }
    }

    public unsafe partial struct WindQuery
    {
        /// <summary>Positions along an axis, 0 to 2: m, <see cref="Count"/> values.</summary>
        public float* Position(int axis) { return axis == 0 ? PositionX : axis == 1 ? PositionY : axis == 2 ? PositionZ : NoAxis(); }

        /// <summary>Velocities to write, likewise.</summary>
        public float* Velocity(int axis) { return axis == 0 ? VelocityX : axis == 1 ? VelocityY : axis == 2 ? VelocityZ : NoAxis(); }

        /// <summary>Their partial derivatives in time, to write.</summary>
        public float* Rate(int axis) { return axis == 0 ? RateX : axis == 1 ? RateY : axis == 2 ? RateZ : NoAxis(); }

        /// <summary>d velocity[row] / d position[column], to write.</summary>
        public float* Gradient(int row, int column)
        {
            if ((uint)row > 2 || (uint)column > 2) NoAxis();
            switch (3 * row + column)
            {
                case 0: return Gradient0;
                case 1: return Gradient1;
                case 2: return Gradient2;
                case 3: return Gradient3;
                case 4: return Gradient4;
                case 5: return Gradient5;
                case 6: return Gradient6;
                case 7: return Gradient7;
                default: return Gradient8;
            }
        }

        internal static float* NoAxis()
        {
            throw new ArgumentOutOfRangeException("axis", "Axes are 0, 1 and 2.");
        }

#if LANGEVIN_SPAN
        /// <summary><see cref="Position(int)"/> as a span.</summary>
        public ReadOnlySpan<float> PositionSpan(int axis) { return new ReadOnlySpan<float>(Position(axis), (int)Count); }
        /// <summary><see cref="Velocity(int)"/> as a span.</summary>
        public Span<float> VelocitySpan(int axis) { return new Span<float>(Velocity(axis), (int)Count); }
        /// <summary><see cref="Rate(int)"/> as a span.</summary>
        public Span<float> RateSpan(int axis) { return new Span<float>(Rate(axis), (int)Count); }
        /// <summary><see cref="Gradient(int, int)"/> as a span.</summary>
        public Span<float> GradientSpan(int row, int column) { return new Span<float>(Gradient(row, column), (int)Count); }
#endif
    }

    public unsafe partial struct WaterQuery
    {
        /// <summary>Positions along an axis, 0 to 2: m, <see cref="Count"/> values.</summary>
        public float* Position(int axis)
        {
            return axis == 0 ? PositionX : axis == 1 ? PositionY : axis == 2 ? PositionZ : WindQuery.NoAxis();
        }

        /// <summary>Normals of the surface, to read and write, likewise.</summary>
        public float* Normal(int axis) { return axis == 0 ? NormalX : axis == 1 ? NormalY : axis == 2 ? NormalZ : WindQuery.NoAxis(); }

        /// <summary>Velocities of the water.</summary>
        public float* Velocity(int axis)
        {
            return axis == 0 ? VelocityX : axis == 1 ? VelocityY : axis == 2 ? VelocityZ : WindQuery.NoAxis();
        }

        /// <summary>Its accelerations.</summary>
        public float* Rate(int axis) { return axis == 0 ? RateX : axis == 1 ? RateY : axis == 2 ? RateZ : WindQuery.NoAxis(); }

#if LANGEVIN_SPAN
        /// <summary><see cref="Position(int)"/> as a span.</summary>
        public ReadOnlySpan<float> PositionSpan(int axis) { return new ReadOnlySpan<float>(Position(axis), (int)Count); }
        /// <summary><see cref="Height"/> as a span.</summary>
        public Span<float> HeightSpan() { return new Span<float>(Height, (int)Count); }
        /// <summary><see cref="Normal(int)"/> as a span.</summary>
        public Span<float> NormalSpan(int axis) { return new Span<float>(Normal(axis), (int)Count); }
        /// <summary><see cref="Velocity(int)"/> as a span.</summary>
        public Span<float> VelocitySpan(int axis) { return new Span<float>(Velocity(axis), (int)Count); }
        /// <summary><see cref="Rate(int)"/> as a span.</summary>
        public Span<float> RateSpan(int axis) { return new Span<float>(Rate(axis), (int)Count); }
#endif
    }
}
