// SPDX-License-Identifier: MIT
// Written by bindings/generator/csharp.py from include/langevin_rigid.h: do not edit.
using System;
using System.Runtime.InteropServices;

namespace LangevinRigid
{
    /// <summary>Refuses a call on a world while another thread is inside one, and a call from one of the world's own
    /// callbacks (wind, water surface, allocator, log, job system, recording). The refused call changes nothing, a
    /// message names both functions, and the call in progress continues unharmed. A refused
    /// <see cref="Native.lr_world_destroy"/> leaks the world; a refused <see cref="Native.lr_world_snapshot_size"/>
    /// returns 0. Calls after <see cref="Native.lr_world_destroy"/> has returned are not detected. Without this bit all
    /// such calls are undefined behaviour. docs/reference/stepping.md</summary>
    [Flags]
    public enum CheckFlags : uint
    {
        /// <summary>No bit.</summary>
        None = 0,
        /// <summary>The header's <c>LR_CHECK_THREADS</c>.</summary>
        Threads = 1,
    }

    /// <summary>The core of a vortex.</summary>
    public enum VortexCore : int
    {
        /// <summary>A smooth core, as viscosity spreads it.</summary>
        LambOseen = 0,
        /// <summary>A core that rotates as a solid.</summary>
        Rankine = 1,
    }

    /// <summary>The value of a wind grid outside its samples.</summary>
    public enum WindOutside : int
    {
        /// <summary>A grid adds nothing outside its samples.</summary>
        Zero = 0,
        /// <summary>The values at its border continue outside.</summary>
        Clamp = 1,
        /// <summary>The grid repeats: its first sample follows its last.</summary>
        Repeat = 2,
    }

    /// <summary>Called with each body once per substep, in no particular order. Calls come at the same time from the
    /// stepping thread and from the world's workers or the job system's threads; with worker_count 0 from the stepping
    /// thread alone. For a deterministic world the results must depend only on position, time and batch. Must not call
    /// the library on the same world, throw, or keep pointers. If a body's results are not finite, or exceed 1000 m/s,
    /// all of them are taken as 0, and one warning is logged after the step.</summary>
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate void WindFn(IntPtr user, WindQuery* query);

    /// <summary>Called for bodies near the water surface: once, and twice more in each substep. Threads and
    /// restrictions: as for <see cref="WindFn"/>. A body's results are replaced by the plane's if one is not finite, if
    /// a height exceeds <c>reach</c>, a velocity 1000 m/s or an acceleration 1e6 m/s^2, or if the normal is invalid;
    /// one warning is then logged after the step.</summary>
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate void WaterFn(IntPtr user, WaterQuery* query);

    /// <summary>The header's <c>struct lr_world_desc</c>.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct WorldDesc
    {
        /// <summary>Size of the struct in bytes, set by <c>Create</c>.</summary>
        public uint StructSize;
        /// <summary>threads besides the caller's, 0 to 64; default 0: everything runs on the caller's thread. With
        /// <c>Jobs</c>: threads of the job system besides the caller's, and the most indices in one enqueue; 0 guesses
        /// the machine's threads less one, from 1 to 64, and logs a warning</summary>
        public uint WorkerCount;
        /// <summary>of all noise; default 0</summary>
        public ulong Seed;
        /// <summary>m/s^2; default 0, -9.81, 0</summary>
        public Float3 Gravity;
        /// <summary>kg/m^3, &gt;= 0; default 0: each batch uses the fluid that its asset was baked in. For a vacuum set
        /// 1e-6</summary>
        public float FluidDensity;
        /// <summary><see cref="SimdTarget"/>; default <see cref="SimdTarget.Auto"/></summary>
        public SimdTarget SimdTarget;
        /// <summary>m^2/s, kinematic, &gt;= 0; default 0: each batch uses the value its asset was baked with</summary>
        public float FluidViscosity;
        /// <summary>copied; default null functions: the C library's</summary>
        public Allocator Allocator;
        /// <summary>default null: no messages A function pointer of a <see cref="LogFn"/>.</summary>
        public IntPtr Log;
        /// <summary>Log user.</summary>
        public IntPtr LogUser;
        /// <summary>copied; default null functions: the world starts worker_count threads of its own</summary>
        public JobSystem Jobs;
        /// <summary><see cref="CheckFlags"/>: misuse to detect, for development; default 0</summary>
        public CheckFlags Checks;
        /// <summary>0.</summary>
        public uint Reserved;

        /// <summary>A struct with its initial values and its size.</summary>
        public static WorldDesc Create()
        {
            var value = default(WorldDesc);
            LangevinLibrary.EnsureLoaded();
            LangevinException.Check(Native.lr_world_desc_init(&value, (uint)sizeof(WorldDesc)), "lr_world_desc_init");
            return value;
        }
    }

    /// <summary>The header's <c>struct lr_world_info</c>.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct WorldInfo
    {
        /// <summary>Size of the struct in bytes, set by <c>Create</c>.</summary>
        public uint StructSize;
        /// <summary><see cref="SimdTarget"/>: in use, never <see cref="SimdTarget.Auto"/></summary>
        public SimdTarget SimdTarget;
        /// <summary>as in the desc; with <c>jobs</c> and 0: the guess</summary>
        public uint WorkerCount;
        /// <summary>Batch count.</summary>
        public uint BatchCount;
        /// <summary>Body count.</summary>
        public ulong BodyCount;
        /// <summary>substeps since creation; the time index of the noise</summary>
        public ulong SubstepCount;
        /// <summary>s since creation: the sum of all dt, in double</summary>
        public double Time;
        /// <summary>currently allocated</summary>
        public ulong MemoryBytes;
        /// <summary>Collider count.</summary>
        public ulong ColliderCount;
        /// <summary>bodies that are not asleep: <see cref="Native.lr_body_set_sleep"/></summary>
        public ulong AwakeCount;
        /// <summary>as set by <see cref="Native.lr_world_set_budget"/></summary>
        public ulong Budget;
        /// <summary>m/s^2, as set by <see cref="Native.lr_world_set_gravity"/></summary>
        public Float3 Gravity;
        /// <summary>0.</summary>
        public uint Reserved;

        /// <summary>A struct with its initial values and its size.</summary>
        public static WorldInfo Create()
        {
            var value = default(WorldInfo);
            LangevinLibrary.EnsureLoaded();
            LangevinException.Check(Native.lr_world_info_init(&value, (uint)sizeof(WorldInfo)), "lr_world_info_init");
            return value;
        }
    }

    /// <summary>Gusts: fluctuations of the uniform wind in time, with mean 0. They start from 0 when added, the fast
    /// ones first, and reach full strength after 4 integral times; an update continues them.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct GustsDesc
    {
        /// <summary>Size of the struct in bytes, set by <c>Create</c>.</summary>
        public uint StructSize;
        /// <summary>combined with the world's; default 0</summary>
        public uint Seed;
        /// <summary>mean direction, any length but 0; default 1, 0, 0</summary>
        public Float3 Direction;
        /// <summary>m/s, root mean square speed, 0 to 1000; default 1</summary>
        public float Rms;
        /// <summary>rad, root mean square angle from <c>Direction</c>, 0 to 1; default 0.1</summary>
        public float AngleRms;
        /// <summary>s, up to 1e6; default 0: 4 s. IEC 61400-1: 5.67 times height over wind speed</summary>
        public float IntegralTime;

        /// <summary>A struct with its initial values and its size.</summary>
        public static GustsDesc Create()
        {
            var value = default(GustsDesc);
            LangevinLibrary.EnsureLoaded();
            LangevinException.Check(Native.lr_gusts_desc_init(&value, (uint)sizeof(GustsDesc)), "lr_gusts_desc_init");
            return value;
        }
    }

    /// <summary>A straight vortex.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct VortexDesc
    {
        /// <summary>Size of the struct in bytes, set by <c>Create</c>.</summary>
        public uint StructSize;
        /// <summary><see cref="VortexCore"/>; default <see cref="VortexCore.LambOseen"/></summary>
        public VortexCore Core;
        /// <summary>m, a point on the axis, its middle if half_length &gt; 0; default 0</summary>
        public Float3 Position;
        /// <summary>right-hand rule, any length but 0; default 0, 1, 0</summary>
        public Float3 Axis;
        /// <summary>m/s, of the vortex itself; default 0</summary>
        public Float3 Velocity;
        /// <summary>m^2/s, up to 1e6 and up to 6000 * core_radius in magnitude; default 1</summary>
        public float Circulation;
        /// <summary>m, &gt;= 1e-4; default 1</summary>
        public float CoreRadius;
        /// <summary>m: fades from half this distance to nothing at it; default 0: no limit</summary>
        public float OuterRadius;
        /// <summary>m: likewise along the axis; default 0: no limit</summary>
        public float HalfLength;

        /// <summary>A struct with its initial values and its size.</summary>
        public static VortexDesc Create()
        {
            var value = default(VortexDesc);
            LangevinLibrary.EnsureLoaded();
            LangevinException.Check(Native.lr_vortex_desc_init(&value, (uint)sizeof(VortexDesc)), "lr_vortex_desc_init");
            return value;
        }
    }

    /// <summary>A blower: a turbulent jet, round or from a slot.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct BlowerDesc
    {
        /// <summary>Size of the struct in bytes, set by <c>Create</c>.</summary>
        public uint StructSize;
        /// <summary>m, the middle of the nozzle; default 0</summary>
        public Float3 Position;
        /// <summary>of the jet, any length but 0; default 1, 0, 0</summary>
        public Float3 Direction;
        /// <summary>along the slot; not parallel to <c>Direction</c>; default 0, 0, 1. Unused by a round jet</summary>
        public Float3 Side;
        /// <summary>m/s, of the blower itself; default 0</summary>
        public Float3 Velocity;
        /// <summary>m/s at the nozzle, 0 to 1000; default 1</summary>
        public float Speed;
        /// <summary>m, &gt;= 1e-4: of a round nozzle, half the width of a slot; default 1</summary>
        public float NozzleRadius;
        /// <summary>m: half the length of the slot; default 0: a round jet</summary>
        public float HalfLength;
        /// <summary>m, &gt;= nozzle_radius: fades from half this distance to nothing at it; default 10</summary>
        public float Range;
        /// <summary>widening of the jet per length, 0 to 1; default 0.1, measured as 0.11</summary>
        public float Spread;

        /// <summary>A struct with its initial values and its size.</summary>
        public static BlowerDesc Create()
        {
            var value = default(BlowerDesc);
            LangevinLibrary.EnsureLoaded();
            LangevinException.Check(Native.lr_blower_desc_init(&value, (uint)sizeof(BlowerDesc)), "lr_blower_desc_init");
            return value;
        }
    }

    /// <summary>Turbulence: random eddies everywhere, divergence-free, carried along by the uniform wind. An update
    /// continues them, also with another velocity; only another size moves them.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct TurbulenceDesc
    {
        /// <summary>Size of the struct in bytes, set by <c>Create</c>.</summary>
        public uint StructSize;
        /// <summary>combined with the world's; default 0</summary>
        public uint Seed;
        /// <summary>each half the size of the one before, 1 to 4; default 2</summary>
        public uint Octaves;
        /// <summary>m/s, of the pattern, besides the uniform wind; default 0</summary>
        public Float3 Velocity;
        /// <summary>m/s, root mean square of each component, 0 to 1000; default 1</summary>
        public float Rms;
        /// <summary>m, &gt;= 1e-4; default 1</summary>
        public float IntegralLength;
        /// <summary>s, of the largest eddies, up to 1e6; default 0: integral_length/rms</summary>
        public float EddyLife;

        /// <summary>A struct with its initial values and its size.</summary>
        public static TurbulenceDesc Create()
        {
            var value = default(TurbulenceDesc);
            LangevinLibrary.EnsureLoaded();
            LangevinException.Check(Native.lr_turbulence_desc_init(&value, (uint)sizeof(TurbulenceDesc)), "lr_turbulence_desc_init");
            return value;
        }
    }

    /// <summary>Samples of wind on a lattice, in one or more frames that are played in a loop, from the first at world
    /// time 0. An update with another frame_time, but as many frames, goes on from the present one.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct WindGridDesc
    {
        /// <summary>Size of the struct in bytes, set by <c>Create</c>.</summary>
        public uint StructSize;
        /// <summary><see cref="WindOutside"/>; default <see cref="WindOutside.Zero"/></summary>
        public WindOutside Outside;
        /// <summary>m, of the first sample; default 0</summary>
        public Float3 Position;
        /// <summary>m/s, of the grid itself; default 0</summary>
        public Float3 Velocity;
        /// <summary>m between samples, &gt;= 1e-4; default 1</summary>
        public Float3 Spacing;
        /// <summary>samples along x, y, z, each &gt;= 1</summary>
        public UInt3 Counts;
        /// <summary>&gt;= 1; default 1</summary>
        public uint Frames;
        /// <summary>s between frames, up to 1e6; default 0: 1 s</summary>
        public float FrameTime;
        /// <summary>m/s, each up to 1000 in magnitude: x y z of each sample; x varies fastest, then y, z, frame;
        /// copied. Null in an update: keeps the samples, if counts and frames are unchanged.
        /// <see cref="Native.lr_world_get_wind_grid"/> gives null</summary>
        public float* Samples;

        /// <summary>A struct with its initial values and its size.</summary>
        public static WindGridDesc Create()
        {
            var value = default(WindGridDesc);
            LangevinLibrary.EnsureLoaded();
            LangevinException.Check(Native.lr_wind_grid_desc_init(&value, (uint)sizeof(WindGridDesc)), "lr_wind_grid_desc_init");
            return value;
        }
    }

    /// <summary>A logarithmic profile over the ground, a plane: scales the uniform wind and the gusts.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct GroundWindDesc
    {
        /// <summary>Size of the struct in bytes, set by <c>Create</c>.</summary>
        public uint StructSize;
        /// <summary>m, a point on the ground; default 0</summary>
        public Float3 Position;
        /// <summary>upward, any length but 0; default 0, 1, 0</summary>
        public Float3 Normal;
        /// <summary>m/s, of the plane itself; default 0</summary>
        public Float3 Velocity;
        /// <summary>m, &gt;= 1e-4; default 0.03, grass (0.0001 water, 1 town)</summary>
        public float RoughnessLength;
        /// <summary>m, &gt;= roughness_length: the height at which the factor is 1; default 10</summary>
        public float ReferenceHeight;

        /// <summary>A struct with its initial values and its size.</summary>
        public static GroundWindDesc Create()
        {
            var value = default(GroundWindDesc);
            LangevinLibrary.EnsureLoaded();
            LangevinException.Check(Native.lr_ground_wind_desc_init(&value, (uint)sizeof(GroundWindDesc)), "lr_ground_wind_desc_init");
            return value;
        }
    }

    /// <summary>Input and output of a wind callback. Arrays hold one value per body.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct WindQuery
    {
        /// <summary>Size of the struct in bytes, set by <c>Create</c>.</summary>
        public uint StructSize;
        /// <summary>bodies, 1 to 256</summary>
        public uint Count;
        /// <summary>of these bodies; id 0 in <see cref="Native.lr_world_sample_wind"/></summary>
        public BatchId Batch;
        /// <summary>0.</summary>
        public uint Reserved;
        /// <summary>s, of the middle of the substep</summary>
        public double Time;
        /// <summary>m: expected positions of the bodies at that time; finite. Element 0 of 3.</summary>
        public float* PositionX;
        /// <summary>m: expected positions of the bodies at that time; finite. Element 1 of 3.</summary>
        public float* PositionY;
        /// <summary>m: expected positions of the bodies at that time; finite. Element 2 of 3.</summary>
        public float* PositionZ;
        /// <summary>m/s, preset to 0: write the velocity to add to the other sources'. Element 0 of 3.</summary>
        public float* VelocityX;
        /// <summary>m/s, preset to 0: write the velocity to add to the other sources'. Element 1 of 3.</summary>
        public float* VelocityY;
        /// <summary>m/s, preset to 0: write the velocity to add to the other sources'. Element 2 of 3.</summary>
        public float* VelocityZ;
        /// <summary>m/s^2, preset to 0: write its partial derivative in time, if known. Element 0 of 3.</summary>
        public float* RateX;
        /// <summary>m/s^2, preset to 0: write its partial derivative in time, if known. Element 1 of 3.</summary>
        public float* RateY;
        /// <summary>m/s^2, preset to 0: write its partial derivative in time, if known. Element 2 of 3.</summary>
        public float* RateZ;
        /// <summary>1/s, preset to 0: write d velocity[i] / d position[j] at 3 i + j, if known. Without rate and
        /// gradient the callback's wind causes drag, but neither shear nor the force of accelerating fluid. Element 0
        /// of 9.</summary>
        public float* Gradient0;
        /// <summary>1/s, preset to 0: write d velocity[i] / d position[j] at 3 i + j, if known. Without rate and
        /// gradient the callback's wind causes drag, but neither shear nor the force of accelerating fluid. Element 1
        /// of 9.</summary>
        public float* Gradient1;
        /// <summary>1/s, preset to 0: write d velocity[i] / d position[j] at 3 i + j, if known. Without rate and
        /// gradient the callback's wind causes drag, but neither shear nor the force of accelerating fluid. Element 2
        /// of 9.</summary>
        public float* Gradient2;
        /// <summary>1/s, preset to 0: write d velocity[i] / d position[j] at 3 i + j, if known. Without rate and
        /// gradient the callback's wind causes drag, but neither shear nor the force of accelerating fluid. Element 3
        /// of 9.</summary>
        public float* Gradient3;
        /// <summary>1/s, preset to 0: write d velocity[i] / d position[j] at 3 i + j, if known. Without rate and
        /// gradient the callback's wind causes drag, but neither shear nor the force of accelerating fluid. Element 4
        /// of 9.</summary>
        public float* Gradient4;
        /// <summary>1/s, preset to 0: write d velocity[i] / d position[j] at 3 i + j, if known. Without rate and
        /// gradient the callback's wind causes drag, but neither shear nor the force of accelerating fluid. Element 5
        /// of 9.</summary>
        public float* Gradient5;
        /// <summary>1/s, preset to 0: write d velocity[i] / d position[j] at 3 i + j, if known. Without rate and
        /// gradient the callback's wind causes drag, but neither shear nor the force of accelerating fluid. Element 6
        /// of 9.</summary>
        public float* Gradient6;
        /// <summary>1/s, preset to 0: write d velocity[i] / d position[j] at 3 i + j, if known. Without rate and
        /// gradient the callback's wind causes drag, but neither shear nor the force of accelerating fluid. Element 7
        /// of 9.</summary>
        public float* Gradient7;
        /// <summary>1/s, preset to 0: write d velocity[i] / d position[j] at 3 i + j, if known. Without rate and
        /// gradient the callback's wind causes drag, but neither shear nor the force of accelerating fluid. Element 8
        /// of 9.</summary>
        public float* Gradient8;
    }

    /// <summary>A long-crested deep-water wave. Heights of waves add up. The frequency in the water, sqrt(2 pi
    /// g/length), uses the world's gravity at the time of <see cref="Native.lr_world_set_water"/>. The current carries
    /// the waves along; a change of it leaves them where they are.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct Wave
    {
        /// <summary>of travel: any vector not along the normal; only its part in the plane counts</summary>
        public Float3 Direction;
        /// <summary>m, crest to crest, 1e-3 to 1e6</summary>
        public float Length;
        /// <summary>m, half of crest to trough, 0 to length/7: steeper waves break</summary>
        public float Amplitude;
        /// <summary>rad, up to 1e6 in magnitude; 0 puts a crest at <c>position</c> at world time 0</summary>
        public float Phase;
    }

    /// <summary>The water surface. Water fills everything below it; above it is the fluid of the world or of each
    /// batch's asset.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct WaterDesc
    {
        /// <summary>Size of the struct in bytes, set by <c>Create</c>.</summary>
        public uint StructSize;
        /// <summary>elements of <c>Waves</c> in use; the others are not kept; default 0</summary>
        public uint WaveCount;
        /// <summary>m, a point of the plane, each up to 1e9 in magnitude; default 0</summary>
        public Float3 Position;
        /// <summary>upward, any length but 0; default 0, 1, 0</summary>
        public Float3 Normal;
        /// <summary>kg/m^3, 1e-3 to 1e6; default 998. A batch whose own fluid is denser keeps its own density</summary>
        public float Density;
        /// <summary>m^2/s, kinematic, 1e-12 to 1e3; default 1e-6</summary>
        public float Viscosity;
        /// <summary>m/s, of the water, and of a plane that you move; each up to 1000 in magnitude; default 0</summary>
        public Float3 Current;
        /// <summary>m, 0 to 1e6: the farthest that a callback's surface lies from the plane; default 0</summary>
        public float Reach;
        /// <summary>Waves. Element 0 of 8.</summary>
        public Wave Waves0;
        /// <summary>Waves. Element 1 of 8.</summary>
        public Wave Waves1;
        /// <summary>Waves. Element 2 of 8.</summary>
        public Wave Waves2;
        /// <summary>Waves. Element 3 of 8.</summary>
        public Wave Waves3;
        /// <summary>Waves. Element 4 of 8.</summary>
        public Wave Waves4;
        /// <summary>Waves. Element 5 of 8.</summary>
        public Wave Waves5;
        /// <summary>Waves. Element 6 of 8.</summary>
        public Wave Waves6;
        /// <summary>Waves. Element 7 of 8.</summary>
        public Wave Waves7;

        /// <summary>Element <paramref name="index"/> of the 8.</summary>
        public ref Wave Waves(int index)
        {
            if ((uint)index >= 8u) throw new ArgumentOutOfRangeException("index");
            fixed (Wave* first = &Waves0) return ref first[index];
        }

        /// <summary>A struct with its initial values and its size.</summary>
        public static WaterDesc Create()
        {
            var value = default(WaterDesc);
            LangevinLibrary.EnsureLoaded();
            LangevinException.Check(Native.lr_water_desc_init(&value, (uint)sizeof(WaterDesc)), "lr_water_desc_init");
            return value;
        }
    }

    /// <summary>Input and output of a water surface callback. Arrays hold one value per body; outputs are preset to the
    /// values of the plane and its waves, each wave as its mean over the body.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct WaterQuery
    {
        /// <summary>Size of the struct in bytes, set by <c>Create</c>.</summary>
        public uint StructSize;
        /// <summary>bodies, 1 to 256</summary>
        public uint Count;
        /// <summary>of these bodies</summary>
        public BatchId Batch;
        /// <summary>0.</summary>
        public uint Reserved;
        /// <summary>s</summary>
        public double Time;
        /// <summary>m; finite. Element 0 of 3.</summary>
        public float* PositionX;
        /// <summary>m; finite. Element 1 of 3.</summary>
        public float* PositionY;
        /// <summary>m; finite. Element 2 of 3.</summary>
        public float* PositionZ;
        /// <summary>m, of the surface above the plane, along the plane's normal</summary>
        public float* Height;
        /// <summary>unit, of the surface, less than 80 degrees from the plane's. Element 0 of 3.</summary>
        public float* NormalX;
        /// <summary>unit, of the surface, less than 80 degrees from the plane's. Element 1 of 3.</summary>
        public float* NormalY;
        /// <summary>unit, of the surface, less than 80 degrees from the plane's. Element 2 of 3.</summary>
        public float* NormalZ;
        /// <summary>m/s, of the water at the position. Element 0 of 3.</summary>
        public float* VelocityX;
        /// <summary>m/s, of the water at the position. Element 1 of 3.</summary>
        public float* VelocityY;
        /// <summary>m/s, of the water at the position. Element 2 of 3.</summary>
        public float* VelocityZ;
        /// <summary>m/s^2, du/dt + u . grad u of the water: lets bodies slide down slopes, follow eddies. Element 0 of
        /// 3.</summary>
        public float* RateX;
        /// <summary>m/s^2, du/dt + u . grad u of the water: lets bodies slide down slopes, follow eddies. Element 1 of
        /// 3.</summary>
        public float* RateY;
        /// <summary>m/s^2, du/dt + u . grad u of the water: lets bodies slide down slopes, follow eddies. Element 2 of
        /// 3.</summary>
        public float* RateZ;
    }

    /// <summary>Work done and postponed by the last step. Batches without bodies are not counted.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct StepReport
    {
        /// <summary>Size of the struct in bytes, set by <c>Create</c>.</summary>
        public uint StructSize;
        /// <summary>Batches stepped.</summary>
        public uint BatchesStepped;
        /// <summary>not due, because of their divisors</summary>
        public uint BatchesWaiting;
        /// <summary>due, but out of budget</summary>
        public uint BatchesPassedOver;
        /// <summary>done in this step</summary>
        public ulong BodySubsteps;
        /// <summary>that the batches which were due would need without a budget</summary>
        public ulong BodySubstepsWanted;
        /// <summary>s: the longest time by which a batch is behind the world</summary>
        public double Behind;
        /// <summary>s: the most simulated time that a batch lost in this step: rather than take substeps that are too
        /// long, bodies move in slow motion</summary>
        public double Lost;

        /// <summary>A struct with its initial values and its size.</summary>
        public static StepReport Create()
        {
            var value = default(StepReport);
            LangevinLibrary.EnsureLoaded();
            LangevinException.Check(Native.lr_step_report_init(&value, (uint)sizeof(StepReport)), "lr_step_report_init");
            return value;
        }
    }

    /// <summary>Seconds that the phases of the last step took on the stepping thread, by a monotonic clock.
    /// <c>Total</c> also includes the work between phases. Phases that did not occur are 0. Neither part of snapshots
    /// nor of the world's hash.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct Timings
    {
        /// <summary>Size of the struct in bytes, set by <c>Create</c>.</summary>
        public uint StructSize;
        /// <summary>0.</summary>
        public uint Reserved;
        /// <summary>Total.</summary>
        public double Total;
        /// <summary>waking bodies about to be hit, moving colliders, sorting them for the search</summary>
        public double Colliders;
        /// <summary>preparing the wind's fields; bodies evaluate them as part of their motion</summary>
        public double Wind;
        /// <summary>of batches without body contact: loads, wind, water, contact with colliders</summary>
        public double Motion;
        /// <summary>of batches with body contact: their motion, and the contact between their bodies</summary>
        public double BodyContact;
        /// <summary>finding sleeping bodies that wind or water moves</summary>
        public double Wake;
        /// <summary>ends, spawns, divergence, and falling asleep</summary>
        public double EmitAndRules;
        /// <summary>listing and sorting them</summary>
        public double Events;

        /// <summary>A struct with its initial values and its size.</summary>
        public static Timings Create()
        {
            var value = default(Timings);
            LangevinLibrary.EnsureLoaded();
            LangevinException.Check(Native.lr_timings_init(&value, (uint)sizeof(Timings)), "lr_timings_init");
            return value;
        }
    }
}
