// SPDX-License-Identifier: MIT
// Written by bindings/generator/csharp.py from include/langevin_rigid.h: do not edit.
using System;
using System.Runtime.InteropServices;

namespace LangevinRigid
{
    /// <summary>Coefficients of the quasi-steady loads (<see cref="LoadModel.Aerodynamic"/>) at scale 1; equations:
    /// docs/maintainers/physics.md, AERODYNAMIC. All loads act at <c>Center</c>, along <c>Axes</c>, which rotate with
    /// the body. Arrays hold one value per axis. Symbols: v is the velocity through the fluid and w the spin, both
    /// along the axes; s = |v|; (i, j, k) are cyclic; d is <see cref="AssetInfo.LengthD"/>; rho and nu are the fluid's
    /// density and kinematic viscosity.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct Aerodynamics
    {
        /// <summary>Size of the struct in bytes, set by <c>Create</c>.</summary>
        public uint StructSize;
        /// <summary>0.</summary>
        public uint Reserved;
        /// <summary>rows: unit vectors in the body frame, right-handed</summary>
        public fixed double Axes[9];
        /// <summary>m^2, drag coefficient times area</summary>
        public Double3 Drag;
        /// <summary>m^2, the part of rounded bodies, which grows with the Reynolds number</summary>
        public Double3 DragBlunt;
        /// <summary>m^(3/2), boundary layer</summary>
        public Double3 DragLayer;
        /// <summary>m, creeping flow</summary>
        public Double3 DragStokes;
        /// <summary>m^2, positive where the body is thinner along j than along i</summary>
        public Double3 Lift;
        /// <summary>m^3</summary>
        public Double3 SpinLift;
        /// <summary>ignored since 0.3</summary>
        public Double3 LiftMoment;
        /// <summary>m^5</summary>
        public Double3 SpinDrag;
        /// <summary>m^4</summary>
        public Double3 SpinDragStream;
        /// <summary>m^3</summary>
        public Double3 SpinDragStokes;
        /// <summary>velocity fluctuations in the body's own wake, per axis, over s. Above 0.4, gains included, it acts
        /// as 0.4: a stronger wake would feed itself</summary>
        public double Intensity;
        /// <summary>m: the fluctuations are correlated over length/s</summary>
        public double Length;
        /// <summary>scales the fluctuations by Re/(Re + wake_reynolds): slow wakes are laminar</summary>
        public double WakeReynolds;
        /// <summary>0 to 1: the fluctuations grow with sum_i broadside_i (v_i/s)^2</summary>
        public Double3 Broadside;
        /// <summary>ignored since 0.3</summary>
        public double LiftStall;
        /// <summary>ignored since 0.3</summary>
        public Double3 LiftMomentStalled;
        /// <summary>ignored since 0.3</summary>
        public Double3 RollDamping;
        /// <summary>m, where the loads act, from the centre of buoyancy, body frame; within 2 d; default 0</summary>
        public Double3 Center;
        /// <summary>m^2, &gt;= 0</summary>
        public Double3 PlateLift;
        /// <summary>m^2, &gt;= 0</summary>
        public Double3 PlateVortex;
        /// <summary>0 to 1</summary>
        public Double3 PlateStall;
        /// <summary>This share of the added momentum along n, 0 to 1, does not move with the body while the stream is
        /// separated and sheds vortices: it reduces the Munk moment.</summary>
        public double PlateSeparatedShedding;
        /// <summary>m^2, &gt;= 0: drag coefficient broadside times area</summary>
        public double PlateDrag;
        /// <summary>&gt;= 0: adds to N start_drag plate_drag |u - v| ((v - u) . v/s^2) v_n</summary>
        public double StartDrag;
        /// <summary>m, &gt; 0</summary>
        public double WakeLength;
        /// <summary>&gt; 0</summary>
        public double WakeLag;
        /// <summary>0 to 1</summary>
        public double WakeShare;
        /// <summary>Vortex shedding above the Reynolds number shedding_reynolds of wake_length: an oscillator q in the
        /// plate with the frequency strouhal s/wake_length and the moment rho v_n^2 n x (shedding_moment q +
        /// shedding_rate_moment r), r the rate of q over 2 pi times the frequency. It starts from the fluctuations. At
        /// shedding_reynolds and below, the wake remembers for 2.5 times as long, and the stream stalls later:
        /// 1/plate_stall - 1 counts 0.4 times.</summary>
        public double Strouhal;
        /// <summary>&gt;= 0</summary>
        public double SheddingGrowth;
        /// <summary>&gt;= 0</summary>
        public double SheddingReynolds;
        /// <summary>&gt;= 0: of r by the fluctuations</summary>
        public double SheddingNoise;
        /// <summary>m^3</summary>
        public double SheddingMoment;
        /// <summary>m^3</summary>
        public double SheddingRateMoment;
        /// <summary>m^(7/2), boundary layer: see spin_drag</summary>
        public Double3 SpinDragLayer;

        /// <summary>A struct with its initial values and its size.</summary>
        public static Aerodynamics Create()
        {
            var value = default(Aerodynamics);
            LangevinLibrary.EnsureLoaded();
            LangevinException.Check(Native.lr_aerodynamics_init(&value, (uint)sizeof(Aerodynamics)), "lr_aerodynamics_init");
            return value;
        }
    }

    /// <summary>A body of known numbers without a mesh or file: from another solver, from measurements, or the
    /// cross-section of a card in two dimensions. Matrices are row-major, symmetric, about the centre of mass, in body
    /// axes.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct RigidDesc
    {
        /// <summary>Size of the struct in bytes, set by <c>Create</c>.</summary>
        public uint StructSize;
        /// <summary>0.</summary>
        public uint Reserved;
        /// <summary>kg, &gt; 0</summary>
        public double Mass;
        /// <summary>m^3, &gt; 0</summary>
        public double Volume;
        /// <summary>kg m^2, positive definite</summary>
        public fixed double Inertia[9];
        /// <summary>kg, kg m, kg m^2: order vx vy vz wx wy wz, fluid density included, as in <see cref="AssetInfo"/>;
        /// positive semi-definite; default 0</summary>
        public fixed double AddedMass[36];
        /// <summary>m, from the centre of mass; default 0</summary>
        public Double3 CenterOfBuoyancy;
        /// <summary>kg/m^3, &gt; 0; default 1.2, air</summary>
        public double FluidDensity;
        /// <summary>m^2/s, kinematic, &gt; 0; default 1.5e-5, air</summary>
        public double FluidViscosity;
        /// <summary>m, full size along the body axes, &gt; 0</summary>
        public Double3 Extents;
        /// <summary>of the turbulence table, as in <see cref="EllipsoidDesc"/>; default 1</summary>
        public double Intensity;
        /// <summary>copied; default null: an ellipsoid's with these extents</summary>
        public Aerodynamics* Aerodynamics;

        /// <summary>A struct with its initial values and its size.</summary>
        public static RigidDesc Create()
        {
            var value = default(RigidDesc);
            LangevinLibrary.EnsureLoaded();
            LangevinException.Check(Native.lr_rigid_desc_init(&value, (uint)sizeof(RigidDesc)), "lr_rigid_desc_init");
            return value;
        }
    }

    /// <summary>k-epsilon samples in the units of the bake. Arrays are copied.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct TurbulenceTable
    {
        /// <summary>Size of the struct in bytes, set by <c>Create</c>.</summary>
        public uint StructSize;
        /// <summary>samples, 1 to 65536</summary>
        public uint Count;
        /// <summary>1/s, turbulent frequency epsilon / k, <c>Count</c> values &gt;= 0</summary>
        public float* Chi;
        /// <summary>m^2/s^3, dissipation rate, <c>Count</c> values &gt;= 0</summary>
        public float* Epsilon;
        /// <summary>s between samples, &gt; 0</summary>
        public float Dt;
        /// <summary>m/s, the speed that the table was made at, &gt; 0; <see cref="TurbulenceClock.Speed"/> scales by
        /// it</summary>
        public float U0;
        /// <summary>m, the length that the table was made with, &gt; 0</summary>
        public float L;
        /// <summary>Kolmogorov constant, &gt; 0; default 6.5, its limit at high Reynolds number</summary>
        public float C0;
        /// <summary>the sample that <see cref="TurbulenceClock.Speed"/> uses, &lt; count; default 0</summary>
        public uint Stationary;
        /// <summary>0.</summary>
        public uint Reserved;

        /// <summary>A struct with its initial values and its size.</summary>
        public static TurbulenceTable Create()
        {
            var value = default(TurbulenceTable);
            LangevinLibrary.EnsureLoaded();
            LangevinException.Check(Native.lr_turbulence_table_init(&value, (uint)sizeof(TurbulenceTable)), "lr_turbulence_table_init");
            return value;
        }
    }

    /// <summary>The loads of the flow on a body and the state of its wake, for inspectors and debug arrows: what
    /// AERODYNAMIC loads do to it now. Weight, buoyancy and added mass are not among them, but what turning costs where
    /// added momentum is left in the wake is. World frame.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct BodyLoads
    {
        /// <summary>Size of the struct in bytes, set by <c>Create</c>.</summary>
        public uint StructSize;
        /// <summary>1 to 8: 1 where one stream describes the shape; 0: no AERODYNAMIC loads</summary>
        public uint StationCount;
        /// <summary>m/s, velocity of the fluid relative to the body, its own fluctuations included</summary>
        public Float3 Stream;
        /// <summary>m/s, the stream that the wake remembers: it follows <c>Stream</c></summary>
        public Float3 Wake;
        /// <summary>q of the vortex shedding (<see cref="Aerodynamics"/>), up to 1.4; 0: a steady wake</summary>
        public Float3 Shedding;
        /// <summary>N, sum of all stations</summary>
        public Float3 Force;
        /// <summary>N m, about the centre of mass, with the couples of spin and shed vortices</summary>
        public Float3 Torque;
        /// <summary>m, x y z of each station</summary>
        public fixed float StationPosition[24];
        /// <summary>N, x y z of each station's force</summary>
        public fixed float StationForce[24];

        /// <summary>A struct with its initial values and its size.</summary>
        public static BodyLoads Create()
        {
            var value = default(BodyLoads);
            LangevinLibrary.EnsureLoaded();
            LangevinException.Check(Native.lr_body_loads_init(&value, (uint)sizeof(BodyLoads)), "lr_body_loads_init");
            return value;
        }
    }
}
