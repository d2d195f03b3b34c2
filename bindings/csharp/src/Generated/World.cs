// SPDX-License-Identifier: MIT
// Written by bindings/generator/csharp.py from include/langevin_rigid.h: change those.
using System;
using System.Runtime.InteropServices;

namespace LangevinRigid
{
    /// <summary>
    /// <para>Wind sources: up to <see cref="Limits.MaxWindSources"/> at a time, whose velocities add to the uniform
    /// wind. Formulas: docs/reference/wind_and_water.md. Time is that of the world (<see cref="WorldInfo.Time"/>). A
    /// source's position is where it is when it is added or updated; from then on it moves with its own
    /// <c>velocity</c>. Gusts have a mean of 0. They begin at 0 when they are added, the quick ones first, and have
    /// their full speed after 4 periods; an update goes on with them. Fields that each kind has:</para>
    /// <code>
    ///   GUSTS         speed direction spread period seed
    ///   RANKINE       position direction velocity circulation size radius half_length
    ///   LAMB_OSEEN    the same
    ///   POINT_BLOWER  position direction velocity speed size spread range
    ///   LINE_BLOWER   the same, and side half_length
    ///   TURBULENCE    speed size period octaves seed velocity
    ///   GRID          position velocity spacing counts frames period outside samples
    ///   GROUND        position direction velocity size reference_height
    /// </code>
    /// </summary>
    public enum WindSourceKind : int
    {
        /// <summary>Fluctuations of the uniform wind in time.</summary>
        Gusts = 1,
        /// <summary>A straight vortex with a core that turns as a solid.</summary>
        Rankine = 2,
        /// <summary>A straight vortex with a smooth core.</summary>
        LambOseen = 3,
        /// <summary>A round jet.</summary>
        PointBlower = 4,
        /// <summary>A plane jet from a slot.</summary>
        LineBlower = 5,
        /// <summary>Random, without divergence, everywhere; carried along by the uniform wind.</summary>
        Turbulence = 6,
        /// <summary>Samples on a lattice, in one or more frames.</summary>
        Grid = 7,
        /// <summary>A factor of the uniform wind and the gusts: logarithmic over a plane.</summary>
        Ground = 8,
    }

    /// <summary>What a grid of wind is outside its samples.</summary>
    public enum WindOutside : int
    {
        /// <summary>A grid adds nothing outside its samples.</summary>
        Zero = 0,
        /// <summary>It goes on as at its border.</summary>
        Clamp = 1,
        /// <summary>It repeats itself; the first sample follows the last.</summary>
        Repeat = 2,
    }

    /// <summary>Kinds of the uniform part of the wind.</summary>
    public enum WindKind : int
    {
        /// <summary>The header's <c>LR_WIND_NONE</c>.</summary>
        None = 0,
        /// <summary>The same velocity everywhere.</summary>
        Uniform = 1,
    }

    /// <summary>Misuse that is found at run time.</summary>
    [Flags]
    public enum WorldChecks : uint
    {
        /// <summary>No bit.</summary>
        None = 0,
        /// <summary>The header's <c>LR_CHECK_THREADS</c>.</summary>
        Threads = 1,
    }

    /// <summary>Handle; 0 is never one.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public readonly struct WindSourceId : IEquatable<WindSourceId>
    {
        /// <summary>As the library sees it; 0 is none.</summary>
        public readonly uint Value;
        /// <summary>From a number that was a handle before.</summary>
        public WindSourceId(uint value) { Value = value; }
        /// <summary>Whether it is no handle at all. One of something destroyed is not null: calls refuse it as stale.</summary>
        public bool IsNull { get { return Value == 0; } }
        /// <inheritdoc/>
        public bool Equals(WindSourceId other) { return Value == other.Value; }
        /// <inheritdoc/>
        public override bool Equals(object other) { return other is WindSourceId && Equals((WindSourceId)other); }
        /// <inheritdoc/>
        public override int GetHashCode() { return Value.GetHashCode(); }
        /// <inheritdoc/>
        public override string ToString() { return "WindSourceId(0x" + Value.ToString("x") + ")"; }
        /// <summary>Whether both are the same.</summary>
        public static bool operator ==(WindSourceId left, WindSourceId right) { return left.Value == right.Value; }
        /// <summary>Whether they differ.</summary>
        public static bool operator !=(WindSourceId left, WindSourceId right) { return left.Value != right.Value; }
    }

    /// <summary>Called once for each body and substep, in no certain order, from the thread that steps and from the
    /// world's workers, or the job system's, at the same time (with worker_count 0 from the stepping thread alone).
    /// Results must depend on nothing but position, time and batch for the world to be deterministic. Must not call the
    /// library on the same world, throw, or keep pointers. A body whose values are not finite, or over 1000 m/s, gets 0
    /// for all of them, and a warning is logged once after the step.</summary>
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate void WindFn(IntPtr user, WindQuery* query);

    /// <summary>Called for bodies near the surface: once, and twice more for each substep; on what terms: as
    /// <see cref="WindFn"/>. A body whose values are not finite, too large (heights over <c>reach</c>, velocities over
    /// 1000 m/s, accelerations over 1e6 m/s^2), or whose normal is none gets those of the plane, and a warning is
    /// logged once after the step.</summary>
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate void SurfaceFn(IntPtr user, SurfaceQuery* query);

    /// <summary>The header's <c>struct lr_world_desc</c>.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct WorldDesc
    {
        /// <summary>Size of the struct in bytes, set by <c>Create</c>.</summary>
        public uint StructSize;
        /// <summary>threads besides the caller's, 0 to 64; initially 0: everything runs in the caller. With
        /// <c>Jobs</c>: the most indices in one enqueue, as many as its threads but the caller's; 0: one less than this
        /// machine has threads, from 1 to 64, and a warning that it is a guess</summary>
        public uint WorkerCount;
        /// <summary>of all noise; initially 0</summary>
        public ulong Seed;
        /// <summary>m/s^2; initially 0, -9.81, 0</summary>
        public Float3 Gravity;
        /// <summary>kg/m^3, &gt;= 0; initially 0: each batch in the fluid its asset was baked in</summary>
        public float FluidDensity;
        /// <summary><see cref="SimdTarget"/>; initially <see cref="SimdTarget.Auto"/></summary>
        public SimdTarget SimdTarget;
        /// <summary>m^2/s, kinematic, &gt;= 0; initially 0: as each batch's asset was baked</summary>
        public float FluidViscosity;
        /// <summary>copied; initially null functions: the C library's</summary>
        public Allocator Allocator;
        /// <summary>initially null: silence A function pointer of a <see cref="LogFn"/>.</summary>
        public IntPtr Log;
        /// <summary>Log user.</summary>
        public IntPtr LogUser;
        /// <summary>copied; initially null functions: worker_count threads of the world's own</summary>
        public JobSystem Jobs;
        /// <summary><see cref="WorldChecks"/>; initially 0</summary>
        public WorldChecks Checks;
        /// <summary>0.</summary>
        public uint Reserved;

        /// <summary>One with its initial values and its size.</summary>
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
        /// <summary>what <see cref="SimdTarget.Auto"/> became</summary>
        public SimdTarget SimdTarget;
        /// <summary>as in the desc; with jobs what 0 became</summary>
        public uint WorkerCount;
        /// <summary>Batch count.</summary>
        public uint BatchCount;
        /// <summary>Body count.</summary>
        public ulong BodyCount;
        /// <summary>substeps since creation; the time index of the noise</summary>
        public ulong SubstepCount;
        /// <summary>s since creation: the sum of all dt, in double</summary>
        public double Time;
        /// <summary>taken from the allocator at present</summary>
        public ulong MemoryBytes;
        /// <summary>Collider count.</summary>
        public ulong ColliderCount;
        /// <summary>bodies that are not at rest: <see cref="Native.lr_body_set_rest"/></summary>
        public ulong AwakeCount;

        /// <summary>One with its initial values and its size.</summary>
        public static WorldInfo Create()
        {
            var value = default(WorldInfo);
            LangevinLibrary.EnsureLoaded();
            LangevinException.Check(Native.lr_world_info_init(&value, (uint)sizeof(WorldInfo)), "lr_world_info_init");
            return value;
        }
    }

    /// <summary>The header's <c>struct lr_wind_desc</c>.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct WindDesc
    {
        /// <summary>Size of the struct in bytes, set by <c>Create</c>.</summary>
        public uint StructSize;
        /// <summary><see cref="WindKind"/>; initially <see cref="WindKind.Uniform"/></summary>
        public WindKind Kind;
        /// <summary>m/s, each up to 1000 in magnitude; initially 0</summary>
        public Float3 Velocity;
        /// <summary>0.</summary>
        public uint Reserved;

        /// <summary>One with its initial values and its size.</summary>
        public static WindDesc Create()
        {
            var value = default(WindDesc);
            LangevinLibrary.EnsureLoaded();
            LangevinException.Check(Native.lr_wind_desc_init(&value, (uint)sizeof(WindDesc)), "lr_wind_desc_init");
            return value;
        }
    }

    /// <summary>Fields that a kind does not have are not used, but must be in range. Lengths up to 1e6 m, speeds up to
    /// 1000 m/s.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct WindSourceDesc
    {
        /// <summary>Size of the struct in bytes, set by <c>Create</c>.</summary>
        public uint StructSize;
        /// <summary><see cref="WindSourceKind"/>; initially 0, which is none of them</summary>
        public WindSourceKind Kind;
        /// <summary>m: a point of the vortex axis (its middle, if half_length &gt; 0), the nozzle's middle, the grid's
        /// first sample, a point of the ground; initially 0</summary>
        public Float3 Position;
        /// <summary>any length but 0: the vortex axis (right-hand rule), where a blower blows, about where gusts blow,
        /// the ground's upward normal; initially 1, 0, 0</summary>
        public Float3 Direction;
        /// <summary>along the slot of a line blower, not along its direction; initially 0, 0, 1</summary>
        public Float3 Side;
        /// <summary>m/s, of the source itself; initially 0</summary>
        public Float3 Velocity;
        /// <summary>m/s: of a blower at its nozzle; root mean square of gusts in all, of turbulence for each component;
        /// &gt;= 0; initially 1</summary>
        public float Speed;
        /// <summary>m^2/s, up to 1e6 in magnitude; initially 1</summary>
        public float Circulation;
        /// <summary>m, &gt;= 1e-4: core radius, radius of the nozzle or half width of the slot, integral length of
        /// turbulence, roughness length of the ground (0.0001 water, 0.03 grass, 1 town); initially 1</summary>
        public float Size;
        /// <summary>m: a vortex fades out from half of it on, to nothing at it; 0: no limit; initially 0</summary>
        public float Radius;
        /// <summary>m: of a vortex, which fades likewise, 0 for no limit; of a slot; initially 0</summary>
        public float HalfLength;
        /// <summary>m, &gt;= size: a blower fades out from half of it on, to nothing at it; initially 10</summary>
        public float Range;
        /// <summary>0 to 1: widening of a jet per length, 0.11 as measured; gusts: root mean square angle in radians
        /// from <c>Direction</c>; initially 0.1</summary>
        public float Spread;
        /// <summary>s: integral time of gusts, 0 for 4, as 2 m over the ground in 3 m/s (IEC 61400-1: 5.67 times the
        /// height over the speed); life of the largest eddies, 0 for size/speed; time from one frame to the next, 0 for
        /// 1; up to 1e6; initially 0</summary>
        public float Period;
        /// <summary>m: where the ground's factor is 1; &gt;= size; initially 10</summary>
        public float ReferenceHeight;
        /// <summary>of turbulence, each half as large as the one before, 1 to 4; initially 2</summary>
        public uint Octaves;
        /// <summary>of gusts and turbulence, together with the world's; initially 0</summary>
        public uint Seed;
        /// <summary><see cref="WindOutside"/>; initially <see cref="WindOutside.Zero"/></summary>
        public WindOutside Outside;
        /// <summary>samples of a grid along x, y, z, each &gt;= 1</summary>
        public UInt3 Counts;
        /// <summary>of a grid, shown one after the other and again from the first; &gt;= 1; initially 1</summary>
        public uint Frames;
        /// <summary>m between samples, &gt;= 1e-4; initially 1</summary>
        public Float3 Spacing;
        /// <summary>0.</summary>
        public uint Reserved;
        /// <summary>m/s, x y z of each sample; x varies fastest, then y, z, frame; copied</summary>
        public float* Samples;

        /// <summary>One with its initial values and its size.</summary>
        public static WindSourceDesc Create()
        {
            var value = default(WindSourceDesc);
            LangevinLibrary.EnsureLoaded();
            LangevinException.Check(Native.lr_wind_source_desc_init(&value, (uint)sizeof(WindSourceDesc)), "lr_wind_source_desc_init");
            return value;
        }
    }

    /// <summary>What a wind callback is asked. Arrays have one value a body.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct WindQuery
    {
        /// <summary>Size of the struct in bytes, set by <c>Create</c>.</summary>
        public uint StructSize;
        /// <summary>bodies, 1 to 256</summary>
        public uint Count;
        /// <summary>whose bodies they are; 0 when asked by <see cref="Native.lr_world_sample_wind"/></summary>
        public BatchId Batch;
        /// <summary>0.</summary>
        public uint Reserved;
        /// <summary>s, of the middle of the substep</summary>
        public double Time;
        /// <summary>m: where the bodies are expected to be at that time; finite. Element 0 of 3.</summary>
        public float* PositionX;
        /// <summary>m: where the bodies are expected to be at that time; finite. Element 1 of 3.</summary>
        public float* PositionY;
        /// <summary>m: where the bodies are expected to be at that time; finite. Element 2 of 3.</summary>
        public float* PositionZ;
        /// <summary>m/s, 0 at first: the velocity that is added to the other sources'. Element 0 of 3.</summary>
        public float* VelocityX;
        /// <summary>m/s, 0 at first: the velocity that is added to the other sources'. Element 1 of 3.</summary>
        public float* VelocityY;
        /// <summary>m/s, 0 at first: the velocity that is added to the other sources'. Element 2 of 3.</summary>
        public float* VelocityZ;
        /// <summary>m/s^2, 0 at first: its partial derivative in time, if it is known. Element 0 of 3.</summary>
        public float* RateX;
        /// <summary>m/s^2, 0 at first: its partial derivative in time, if it is known. Element 1 of 3.</summary>
        public float* RateY;
        /// <summary>m/s^2, 0 at first: its partial derivative in time, if it is known. Element 2 of 3.</summary>
        public float* RateZ;
        /// <summary>1/s, 0 at first: d velocity[i] / d position[j] at 3 i + j, if it is known. Without rate and
        /// gradient the callback's part gives drag, but neither the force of the fluid's acceleration nor shear.
        /// Element 0 of 9.</summary>
        public float* Gradient0;
        /// <summary>1/s, 0 at first: d velocity[i] / d position[j] at 3 i + j, if it is known. Without rate and
        /// gradient the callback's part gives drag, but neither the force of the fluid's acceleration nor shear.
        /// Element 1 of 9.</summary>
        public float* Gradient1;
        /// <summary>1/s, 0 at first: d velocity[i] / d position[j] at 3 i + j, if it is known. Without rate and
        /// gradient the callback's part gives drag, but neither the force of the fluid's acceleration nor shear.
        /// Element 2 of 9.</summary>
        public float* Gradient2;
        /// <summary>1/s, 0 at first: d velocity[i] / d position[j] at 3 i + j, if it is known. Without rate and
        /// gradient the callback's part gives drag, but neither the force of the fluid's acceleration nor shear.
        /// Element 3 of 9.</summary>
        public float* Gradient3;
        /// <summary>1/s, 0 at first: d velocity[i] / d position[j] at 3 i + j, if it is known. Without rate and
        /// gradient the callback's part gives drag, but neither the force of the fluid's acceleration nor shear.
        /// Element 4 of 9.</summary>
        public float* Gradient4;
        /// <summary>1/s, 0 at first: d velocity[i] / d position[j] at 3 i + j, if it is known. Without rate and
        /// gradient the callback's part gives drag, but neither the force of the fluid's acceleration nor shear.
        /// Element 5 of 9.</summary>
        public float* Gradient5;
        /// <summary>1/s, 0 at first: d velocity[i] / d position[j] at 3 i + j, if it is known. Without rate and
        /// gradient the callback's part gives drag, but neither the force of the fluid's acceleration nor shear.
        /// Element 6 of 9.</summary>
        public float* Gradient6;
        /// <summary>1/s, 0 at first: d velocity[i] / d position[j] at 3 i + j, if it is known. Without rate and
        /// gradient the callback's part gives drag, but neither the force of the fluid's acceleration nor shear.
        /// Element 7 of 9.</summary>
        public float* Gradient7;
        /// <summary>1/s, 0 at first: d velocity[i] / d position[j] at 3 i + j, if it is known. Without rate and
        /// gradient the callback's part gives drag, but neither the force of the fluid's acceleration nor shear.
        /// Element 8 of 9.</summary>
        public float* Gradient8;
    }

    /// <summary>A long-crested wave of deep water. Heights add; its frequency sqrt(2 pi g/length) is that of the
    /// world's gravity when the surface is set.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct Wave
    {
        /// <summary>where it goes: any vector not along the normal; its part in the plane counts</summary>
        public Float3 Direction;
        /// <summary>m, crest to crest, 1e-3 to 1e6</summary>
        public float Length;
        /// <summary>m, half of crest to trough, 0 to length/7: steeper ones break</summary>
        public float Amplitude;
        /// <summary>rad, up to 1e6 in magnitude: 0 has a crest at <c>position</c> at the world's time 0</summary>
        public float Phase;
    }

    /// <summary>The lower fluid fills everything below a plane, or below the waves on it. Above is the fluid of the
    /// world or of each batch's asset. Bodies float, sink, and go through; surface tension is ignored.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct SurfaceDesc
    {
        /// <summary>Size of the struct in bytes, set by <c>Create</c>.</summary>
        public uint StructSize;
        /// <summary>used part of <c>Waves</c>; initially 0</summary>
        public uint WaveCount;
        /// <summary>m, a point of the plane, each up to 1e9 in magnitude; initially 0</summary>
        public Float3 Position;
        /// <summary>upward, any length but 0; initially 0, 1, 0</summary>
        public Float3 Normal;
        /// <summary>kg/m^3, 1e-3 to 1e6; initially 998. A batch whose own fluid is denser keeps that one's</summary>
        public float Density;
        /// <summary>m^2/s, kinematic, 1e-12 to 1e3; initially 1e-6</summary>
        public float Viscosity;
        /// <summary>m/s, velocity of the lower fluid, each up to 1000 in magnitude; initially 0</summary>
        public Float3 Current;
        /// <summary>m, 0 to 1e6: a callback's surface lies at most so far from the plane; initially 0</summary>
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

        /// <summary>One with its initial values and its size.</summary>
        public static SurfaceDesc Create()
        {
            var value = default(SurfaceDesc);
            LangevinLibrary.EnsureLoaded();
            LangevinException.Check(Native.lr_surface_desc_init(&value, (uint)sizeof(SurfaceDesc)), "lr_surface_desc_init");
            return value;
        }
    }

    /// <summary>What a surface callback is asked. Arrays have one value a body, and hold what plane and waves give at
    /// first.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct SurfaceQuery
    {
        /// <summary>Size of the struct in bytes, set by <c>Create</c>.</summary>
        public uint StructSize;
        /// <summary>bodies, 1 to 256</summary>
        public uint Count;
        /// <summary>whose bodies they are</summary>
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
        /// <summary>m above the plane of the surface there, along the plane's normal</summary>
        public float* Height;
        /// <summary>unit, of the surface, less than 80 degrees from the plane's. Element 0 of 3.</summary>
        public float* NormalX;
        /// <summary>unit, of the surface, less than 80 degrees from the plane's. Element 1 of 3.</summary>
        public float* NormalY;
        /// <summary>unit, of the surface, less than 80 degrees from the plane's. Element 2 of 3.</summary>
        public float* NormalZ;
        /// <summary>m/s, of the lower fluid at the position. Element 0 of 3.</summary>
        public float* VelocityX;
        /// <summary>m/s, of the lower fluid at the position. Element 1 of 3.</summary>
        public float* VelocityY;
        /// <summary>m/s, of the lower fluid at the position. Element 2 of 3.</summary>
        public float* VelocityZ;
        /// <summary>m/s^2, its acceleration. Where the surface is steep it is what lets bodies slide down. Element 0 of
        /// 3.</summary>
        public float* RateX;
        /// <summary>m/s^2, its acceleration. Where the surface is steep it is what lets bodies slide down. Element 1 of
        /// 3.</summary>
        public float* RateY;
        /// <summary>m/s^2, its acceleration. Where the surface is steep it is what lets bodies slide down. Element 2 of
        /// 3.</summary>
        public float* RateZ;
    }

    /// <summary>What the last step did, and what it left out. Batches without bodies do not count.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct StepReport
    {
        /// <summary>Size of the struct in bytes, set by <c>Create</c>.</summary>
        public uint StructSize;
        /// <summary>Batches stepped.</summary>
        public uint BatchesStepped;
        /// <summary>not due, by their own divisors</summary>
        public uint BatchesWaiting;
        /// <summary>due, but the budget did not reach them</summary>
        public uint BatchesPassedOver;
        /// <summary>done</summary>
        public ulong BodySubsteps;
        /// <summary>of the batches that were due, without a budget</summary>
        public ulong BodySubstepsWanted;
        /// <summary>s: how far the bodies that have waited longest are behind the world's time</summary>
        public double Behind;
        /// <summary>s: the most that a batch lost in this step: bodies go in slow motion rather than in too long
        /// substeps</summary>
        public double Lost;

        /// <summary>One with its initial values and its size.</summary>
        public static StepReport Create()
        {
            var value = default(StepReport);
            LangevinLibrary.EnsureLoaded();
            LangevinException.Check(Native.lr_step_report_init(&value, (uint)sizeof(StepReport)), "lr_step_report_init");
            return value;
        }
    }
}
