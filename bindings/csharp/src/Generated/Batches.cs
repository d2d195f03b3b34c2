// SPDX-License-Identifier: MIT
// Written by bindings/generator/csharp.py from include/langevin_rigid.h: do not edit.
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

    /// <summary>The clock of a body's turbulence.</summary>
    public enum TurbulenceClock : int
    {
        /// <summary>Turbulence scales with the body's current speed through the fluid.</summary>
        Speed = 0,
        /// <summary>The paper's: turbulence follows the table by the body's age.</summary>
        Age = 1,
    }

    /// <summary>Continuation of a turbulence table after its last sample.</summary>
    public enum TableEnd : int
    {
        /// <summary><see cref="TurbulenceClock.Age"/>: hold the last sample after the end of the table.</summary>
        Clamp = 0,
        /// <summary><see cref="TurbulenceClock.Age"/>: start over.</summary>
        Loop = 1,
    }

    /// <summary>How motion is integrated.</summary>
    public enum Integrator : int
    {
        /// <summary><see cref="Integrator.Splitting"/> in this version.</summary>
        Default = 0,
        /// <summary>The paper's: fourth order, slow, unstable at long steps. In water: splitting.</summary>
        Rk4 = 1,
        /// <summary>Second order, stable at any step; docs/maintainers/numerics.md.</summary>
        Splitting = 2,
    }

    /// <summary>Formats of transforms, in floats.</summary>
    public enum TransformFormat : int
    {
        /// <summary>7 floats: position, quaternion x y z w.</summary>
        PositionQuaternion = 0,
        /// <summary>8 floats: position, quaternion x y z w, scale.</summary>
        PositionQuaternionScale = 1,
        /// <summary>12 floats: three rows, rotation times scale and translation.</summary>
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
        /// <summary>the most bodies at a time, 1 to 2^26; memory for all is allocated at creation</summary>
        public uint Capacity;
        /// <summary>required; the batch keeps a reference until it is destroyed</summary>
        public IntPtr Asset;
        /// <summary><see cref="LoadModel"/>; default <see cref="LoadModel.Default"/></summary>
        public LoadModel LoadModel;
        /// <summary><see cref="TurbulenceClock"/>; default <see cref="TurbulenceClock.Speed"/></summary>
        public TurbulenceClock Clock;
        /// <summary><see cref="TableEnd"/>; default <see cref="TableEnd.Clamp"/></summary>
        public TableEnd TableEnd;
        /// <summary><see cref="Integrator"/>; default <see cref="Integrator.Default"/></summary>
        public Integrator Integrator;
        /// <summary>multiplies the turbulent damping, 0 to 100; default 1</summary>
        public float DampingGain;
        /// <summary>multiplies the turbulent noise, 0 to 100; default 1; 0 makes single falls repeatable</summary>
        public float NoiseGain;
        /// <summary>natural spread of AERODYNAMIC loads from body to body, as by thickness and curl: relative standard
        /// deviation, 0 to 0.5; default 0.15; 0: all bodies are alike. A body's loads follow from its noise seed and
        /// the world's seed, and never change</summary>
        public float Variation;
        /// <summary>0.</summary>
        public uint Reserved;

        /// <summary>A struct with its initial values and its size.</summary>
        public static BatchDesc Create()
        {
            var value = default(BatchDesc);
            LangevinLibrary.EnsureLoaded();
            LangevinException.Check(Native.lr_batch_desc_init(&value, (uint)sizeof(BatchDesc)), "lr_batch_desc_init");
            return value;
        }
    }

    /// <summary>Artistic control of AERODYNAMIC loads. The factors multiply the coefficients, so bodies still move
    /// physically.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct LoadGains
    {
        /// <summary>Size of the struct in bytes, set by <c>Create</c>.</summary>
        public uint StructSize;
        /// <summary>0.</summary>
        public uint Reserved;
        /// <summary>on translation, 0 to 100; default 1</summary>
        public float Drag;
        /// <summary>and its moment, 0 to 100; default 1</summary>
        public float Lift;
        /// <summary>0 to 100; default 1</summary>
        public float SpinDrag;
        /// <summary>intensity of the body's own wake, 0 to 100; default 1</summary>
        public float Turbulence;

        /// <summary>A struct with its initial values and its size.</summary>
        public static LoadGains Create()
        {
            var value = default(LoadGains);
            LangevinLibrary.EnsureLoaded();
            LangevinException.Check(Native.lr_load_gains_init(&value, (uint)sizeof(LoadGains)), "lr_load_gains_init");
            return value;
        }
    }

    /// <summary>How a batch keeps pace with its world.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct BatchPace
    {
        /// <summary>Size of the struct in bytes, set by <c>Create</c>.</summary>
        public uint StructSize;
        /// <summary>as set</summary>
        public uint Divisor;
        /// <summary>in the world's last step; 0: it waited</summary>
        public uint Substeps;
        /// <summary>steps since it was last stepped</summary>
        public uint Waited;
        /// <summary>s since it was last stepped</summary>
        public double Behind;
        /// <summary>s, simulated time lost in total</summary>
        public double Lost;
        /// <summary>in total</summary>
        public ulong BodySubsteps;

        /// <summary>A struct with its initial values and its size.</summary>
        public static BatchPace Create()
        {
            var value = default(BatchPace);
            LangevinLibrary.EnsureLoaded();
            LangevinException.Check(Native.lr_batch_pace_init(&value, (uint)sizeof(BatchPace)), "lr_batch_pace_init");
            return value;
        }
    }

    /// <summary>Read access to a batch's state without a copy: arrays of <c>Count</c> values, one per body, 64-byte
    /// aligned. Awake bodies come first, then sleeping ones, without gaps. A body that leaves either part is replaced
    /// by the last one of that part. Pointers are valid until the next call that is not a query. Velocities:
    /// <see cref="Native.lr_batch_write_velocities"/>.</summary>
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
        /// <summary>uniform scale</summary>
        public float* Scale;
        /// <summary>s; outdated for sleeping bodies: <see cref="Native.lr_body_get_state"/> gives their exact
        /// age</summary>
        public float* Age;
        /// <summary>bodies with different seeds have independent noise</summary>
        public uint* NoiseSeed;
        /// <summary>Ids.</summary>
        public BodyId* Ids;
        /// <summary><see cref="BodyDesc.User"/>; null until a body of the batch is given one</summary>
        public ulong* User;
        /// <summary>Capacity.</summary>
        public uint Capacity;
        /// <summary>0.</summary>
        public uint Reserved;
        /// <summary>changes whenever sleeping bodies wake, end or change places</summary>
        public ulong Revision;
        /// <summary>bodies [0, awake_count) are awake, [awake_count, count) asleep:
        /// <see cref="Native.lr_body_set_sleep"/></summary>
        public uint AwakeCount;
        /// <summary>0.</summary>
        public uint Reserved1;

        /// <summary>A struct with its initial values and its size.</summary>
        public static BatchView Create()
        {
            var value = default(BatchView);
            LangevinLibrary.EnsureLoaded();
            LangevinException.Check(Native.lr_batch_view_init(&value, (uint)sizeof(BatchView)), "lr_batch_view_init");
            return value;
        }
    }
}
