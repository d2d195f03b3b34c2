// SPDX-License-Identifier: MIT
// Written by bindings/generator/csharp.py from include/langevin_rigid.h: change those.
using System;
using System.Runtime.InteropServices;

namespace LangevinRigid
{
    /// <summary>How the fluid's forces on bodies are computed.</summary>
    public enum LoadModel : int
    {
        /// <summary><see cref="LoadModel.Aerodynamic"/> in this version.</summary>
        Default = 0,
        /// <summary>Gravity, buoyancy and added mass only: Kirchhoff's equations.</summary>
        None = 1,
        /// <summary>The paper's turbulent loads, dimensionally repaired; docs/maintainers/physics.md, 4.</summary>
        Langevin = 2,
        /// <summary>Quasi-steady drag and lift in a turbulent fluid; docs/maintainers/physics.md, 5.</summary>
        Aerodynamic = 3,
    }

    /// <summary>What the turbulence of a body follows.</summary>
    public enum TurbulenceClock : int
    {
        /// <summary>Turbulence scales with the body's present speed through the fluid.</summary>
        Speed = 0,
        /// <summary>The paper: turbulence follows the table at the body's age.</summary>
        Age = 1,
    }

    /// <summary>What follows the last sample of a turbulence table.</summary>
    public enum TableEnd : int
    {
        /// <summary><see cref="TurbulenceClock.Age"/>: hold the last sample after the end of the table.</summary>
        Clamp = 0,
        /// <summary><see cref="TurbulenceClock.Age"/>: begin again.</summary>
        Loop = 1,
    }

    /// <summary>How motion is integrated.</summary>
    public enum Integrator : int
    {
        /// <summary><see cref="Integrator.Splitting"/> in this version.</summary>
        Default = 0,
        /// <summary>The paper's: fourth order, unstable at long steps, slow. In water: splitting.</summary>
        Rk4 = 1,
        /// <summary>Second order and stable at any step; docs/maintainers/numerics.md.</summary>
        Splitting = 2,
    }

    /// <summary>Layouts of transforms, as float elements.</summary>
    public enum TransformFormat : int
    {
        /// <summary>7 floats: position, quaternion x y z w.</summary>
        PositionQuaternion = 0,
        /// <summary>8 floats: the same and the scale.</summary>
        PositionQuaternionScale = 1,
        /// <summary>12 floats: three rows of rotation times scale and translation.</summary>
        Matrix3x4RowMajor = 2,
        /// <summary>12 floats: four columns of three.</summary>
        Matrix3x4ColumnMajor = 3,
        /// <summary>16 floats; column vectors, translation in elements 3, 7, 11.</summary>
        Matrix4x4RowMajor = 4,
        /// <summary>16 floats; column vectors, translation in elements 12, 13, 14.</summary>
        Matrix4x4ColumnMajor = 5,
    }

    /// <summary>The header's <c>struct lr_batch_desc</c>.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct BatchDesc
    {
        /// <summary>Size of the struct in bytes, set by <c>Create</c>.</summary>
        public uint StructSize;
        /// <summary>the most bodies at a time, 1 to 2^26; memory for all is taken at once</summary>
        public uint Capacity;
        /// <summary>kept by reference until the batch ends</summary>
        public IntPtr Asset;
        /// <summary><see cref="LoadModel"/>; initially <see cref="LoadModel.Default"/></summary>
        public LoadModel LoadModel;
        /// <summary><see cref="TurbulenceClock"/>; initially <see cref="TurbulenceClock.Speed"/></summary>
        public TurbulenceClock Clock;
        /// <summary><see cref="TableEnd"/>; initially <see cref="TableEnd.Clamp"/></summary>
        public TableEnd TableEnd;
        /// <summary><see cref="Integrator"/>; initially <see cref="Integrator.Default"/></summary>
        public Integrator Integrator;
        /// <summary>multiplies the turbulent damping, 0 to 100; initially 1</summary>
        public float DampingGain;
        /// <summary>multiplies the turbulent noise, 0 to 100; initially 1; 0 for repeatable single falls</summary>
        public float NoiseGain;

        /// <summary>One with its initial values and its size.</summary>
        public static BatchDesc Create()
        {
            var value = default(BatchDesc);
            LangevinLibrary.EnsureLoaded();
            LangevinException.Check(Native.lr_batch_desc_init(&value, (uint)sizeof(BatchDesc)), "lr_batch_desc_init");
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
        /// <summary>m/s, speed the table was made at, &gt; 0: what <see cref="TurbulenceClock.Speed"/> scales
        /// by</summary>
        public float U0;
        /// <summary>m, length the table was made with, &gt; 0</summary>
        public float L;
        /// <summary>Kolmogorov constant, &gt; 0; initially 6.5, its limit at high Reynolds number</summary>
        public float C0;
        /// <summary>sample that <see cref="TurbulenceClock.Speed"/> uses, &lt; count; initially 0</summary>
        public uint Stationary;
        /// <summary>0.</summary>
        public uint Reserved;

        /// <summary>One with its initial values and its size.</summary>
        public static TurbulenceTable Create()
        {
            var value = default(TurbulenceTable);
            LangevinLibrary.EnsureLoaded();
            LangevinException.Check(Native.lr_turbulence_table_init(&value, (uint)sizeof(TurbulenceTable)), "lr_turbulence_table_init");
            return value;
        }
    }

    /// <summary>Art control of the AERODYNAMIC loads: factors on top of the coefficients, so that motion stays that of
    /// some body.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct LoadGains
    {
        /// <summary>Size of the struct in bytes, set by <c>Create</c>.</summary>
        public uint StructSize;
        /// <summary>0.</summary>
        public uint Reserved;
        /// <summary>of translation, 0 to 100; initially 1</summary>
        public float Drag;
        /// <summary>and its moment, 0 to 100; initially 1</summary>
        public float Lift;
        /// <summary>0 to 100; initially 1</summary>
        public float SpinDrag;
        /// <summary>intensity of the body's own wake, 0 to 100; initially 1</summary>
        public float Turbulence;

        /// <summary>One with its initial values and its size.</summary>
        public static LoadGains Create()
        {
            var value = default(LoadGains);
            LangevinLibrary.EnsureLoaded();
            LangevinException.Check(Native.lr_load_gains_init(&value, (uint)sizeof(LoadGains)), "lr_load_gains_init");
            return value;
        }
    }

    /// <summary>How a batch keeps up with its world.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct BatchPace
    {
        /// <summary>Size of the struct in bytes, set by <c>Create</c>.</summary>
        public uint StructSize;
        /// <summary>as set</summary>
        public uint Divisor;
        /// <summary>in the last step of the world; 0: it waited</summary>
        public uint Substeps;
        /// <summary>steps since it was last stepped</summary>
        public uint Waited;
        /// <summary>s: the same as time</summary>
        public double Behind;
        /// <summary>s, in all: what its bodies' clocks are slow by</summary>
        public double Lost;
        /// <summary>in all</summary>
        public ulong BodySubsteps;

        /// <summary>One with its initial values and its size.</summary>
        public static BatchPace Create()
        {
            var value = default(BatchPace);
            LangevinLibrary.EnsureLoaded();
            LangevinException.Check(Native.lr_batch_pace_init(&value, (uint)sizeof(BatchPace)), "lr_batch_pace_init");
            return value;
        }
    }

    /// <summary>The state of a batch where it lies: arrays with one value a body, <c>Count</c> of them, 64-byte
    /// aligned. Bodies are dense: those that move come first, then those at rest, and where one leaves its part of
    /// them, the last of that part takes its place. Pointers are valid until the next call that is not a
    /// query.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct BatchView
    {
        /// <summary>Size of the struct in bytes, set by <c>Create</c>.</summary>
        public uint StructSize;
        /// <summary>bodies</summary>
        public uint Count;
        /// <summary>m, world frame: x, y, z. Element 0 of 3.</summary>
        public float* PositionX;
        /// <summary>m, world frame: x, y, z. Element 1 of 3.</summary>
        public float* PositionY;
        /// <summary>m, world frame: x, y, z. Element 2 of 3.</summary>
        public float* PositionZ;
        /// <summary>unit quaternion x, y, z, w, body to world. Element 0 of 4.</summary>
        public float* OrientationX;
        /// <summary>unit quaternion x, y, z, w, body to world. Element 1 of 4.</summary>
        public float* OrientationY;
        /// <summary>unit quaternion x, y, z, w, body to world. Element 2 of 4.</summary>
        public float* OrientationZ;
        /// <summary>unit quaternion x, y, z, w, body to world. Element 3 of 4.</summary>
        public float* OrientationW;
        /// <summary>m/s, of the centre of mass, in the BODY frame: turn by the orientation for the world's. Element 0
        /// of 3.</summary>
        public float* VelocityX;
        /// <summary>m/s, of the centre of mass, in the BODY frame: turn by the orientation for the world's. Element 1
        /// of 3.</summary>
        public float* VelocityY;
        /// <summary>m/s, of the centre of mass, in the BODY frame: turn by the orientation for the world's. Element 2
        /// of 3.</summary>
        public float* VelocityZ;
        /// <summary>rad/s, angular velocity, in the BODY frame. Element 0 of 3.</summary>
        public float* SpinX;
        /// <summary>rad/s, angular velocity, in the BODY frame. Element 1 of 3.</summary>
        public float* SpinY;
        /// <summary>rad/s, angular velocity, in the BODY frame. Element 2 of 3.</summary>
        public float* SpinZ;
        /// <summary>uniform scale</summary>
        public float* Scale;
        /// <summary>s; of a body at rest some earlier one: <see cref="Native.lr_body_get_state"/> has it
        /// exactly</summary>
        public float* Age;
        /// <summary>what tells the noise of bodies apart</summary>
        public uint* Key;
        /// <summary>Ids.</summary>
        public BodyId* Ids;
        /// <summary>Capacity.</summary>
        public uint Capacity;
        /// <summary>0.</summary>
        public uint Reserved;
        /// <summary>differs whenever bodies at rest have woken, ended, or changed their places</summary>
        public ulong Revision;
        /// <summary>bodies [0, awake_count) move, [awake_count, count) are at rest:
        /// <see cref="Native.lr_body_set_rest"/></summary>
        public uint AwakeCount;
        /// <summary>0.</summary>
        public uint Reserved1;

        /// <summary>One with its initial values and its size.</summary>
        public static BatchView Create()
        {
            var value = default(BatchView);
            LangevinLibrary.EnsureLoaded();
            LangevinException.Check(Native.lr_batch_view_init(&value, (uint)sizeof(BatchView)), "lr_batch_view_init");
            return value;
        }
    }
}
