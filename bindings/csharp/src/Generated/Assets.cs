// SPDX-License-Identifier: MIT
// Written by bindings/generator/csharp.py from include/langevin_rigid.h: do not edit.
using System;
using System.Runtime.InteropServices;

namespace LangevinRigid
{
    /// <summary>Bits that describe an asset.</summary>
    [Flags]
    public enum AssetFlags : uint
    {
        /// <summary>No bit.</summary>
        None = 0,
        /// <summary>Diagonal in body axes, buoyancy at the centre of mass: the fastest path for all loads.</summary>
        Diagonal = 1,
        /// <summary>Its own mirror image across its widest face: the fastest path for AERODYNAMIC loads.</summary>
        Symmetric = 2,
    }

    /// <summary>Receives one numbered fault of an asset file; docs/reference/asset_format.md lists them. Strings are
    /// valid during the call only.</summary>
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate void FaultFn(IntPtr user, uint number, byte* where, byte* what, byte* remedy);

    /// <summary>A solid ellipsoid: the quickest way to a first falling body. Mass, added mass (Lamb) and the decay of k
    /// and epsilon in a uniform stream come from closed forms.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct EllipsoidDesc
    {
        /// <summary>Size of the struct in bytes, set by <c>Create</c>.</summary>
        public uint StructSize;
        /// <summary>0.</summary>
        public uint Reserved;
        /// <summary>m, each 1e-6 to 1e3, along body x, y, z</summary>
        public Double3 SemiAxes;
        /// <summary>kg/m^3 of the body, &gt; 0</summary>
        public double Density;
        /// <summary>kg/m^3, &gt; 0; default 1.2, air</summary>
        public double FluidDensity;
        /// <summary>m^2/s, kinematic, &gt; 0; default 1.5e-5, air</summary>
        public double FluidViscosity;
        /// <summary>turbulence intensity I of k0 = 3/2 (I U0)^2, 0 to 10; default 1, as in the paper</summary>
        public double Intensity;
        /// <summary>m, from the ellipsoid's centre, inside it; default 0. For ballast: the centre of buoyancy and the
        /// moments of inertia stay those of the uniform solid</summary>
        public Double3 CenterOfMass;

        /// <summary>A struct with its initial values and its size.</summary>
        public static EllipsoidDesc Create()
        {
            var value = default(EllipsoidDesc);
            LangevinLibrary.EnsureLoaded();
            LangevinException.Check(Native.lr_ellipsoid_desc_init(&value, (uint)sizeof(EllipsoidDesc)), "lr_ellipsoid_desc_init");
            return value;
        }
    }

    /// <summary>Properties of an asset. Matrices are row-major and symmetric.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct AssetInfo
    {
        /// <summary>Size of the struct in bytes, set by <c>Create</c>.</summary>
        public uint StructSize;
        /// <summary><see cref="AssetFlags"/></summary>
        public AssetFlags Flags;
        /// <summary>UTF-8, ends with 0</summary>
        public fixed byte Name[64];
        /// <summary>kg</summary>
        public double Mass;
        /// <summary>m^3</summary>
        public double Volume;
        /// <summary>kg/m^3</summary>
        public double Density;
        /// <summary>m, in the frame of the mesh: the position of the body's origin in it</summary>
        public Double3 CenterOfMass;
        /// <summary>m, from the centre of mass, body axes</summary>
        public Double3 CenterOfBuoyancy;
        /// <summary>kg m^2, about the centre of mass, body axes</summary>
        public fixed double Inertia[9];
        /// <summary>about the centre of mass, order vx vy vz wx wy wz, fluid density included: kg for the 3x3 block of
        /// v, kg m for the coupling, kg m^2 for the block of w</summary>
        public fixed double AddedMass[36];
        /// <summary>kg/m^3, of the fluid that the asset was baked in</summary>
        public double FluidDensity;
        /// <summary>m^2/s, kinematic</summary>
        public double FluidViscosity;
        /// <summary>m, characteristic length: the largest extent</summary>
        public double LengthD;
        /// <summary>m, thickness</summary>
        public double LengthB;
        /// <summary>m, turbulence length; see docs/maintainers/physics.md</summary>
        public double LengthL;
        /// <summary>m/s, fall velocity scale sqrt(|density ratio - 1| g b), paper Eq. 1</summary>
        public double U0;
        /// <summary>u0 d / viscosity</summary>
        public double Reynolds;
        /// <summary>Kolmogorov constant of the Langevin model, paper Eq. 10</summary>
        public double C0;
        /// <summary>s between table samples</summary>
        public double TurbulenceDt;
        /// <summary>number of table samples</summary>
        public uint TurbulenceCount;
        /// <summary>0: no hull</summary>
        public uint HullVertexCount;
        /// <summary>Hull triangle count.</summary>
        public uint HullTriangleCount;
        /// <summary>of the file; 0: created without a file</summary>
        public uint FormatVersion;
        /// <summary>of everything that affects motion; equal for equal assets</summary>
        public ulong ContentHash;

        /// <summary>A struct with its initial values and its size.</summary>
        public static AssetInfo Create()
        {
            var value = default(AssetInfo);
            LangevinLibrary.EnsureLoaded();
            LangevinException.Check(Native.lr_asset_info_init(&value, (uint)sizeof(AssetInfo)), "lr_asset_info_init");
            return value;
        }
    }
}
