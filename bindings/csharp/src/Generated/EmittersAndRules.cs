// SPDX-License-Identifier: MIT
// Written by bindings/generator/csharp.py from include/langevin_rigid.h: do not edit.
using System;
using System.Runtime.InteropServices;

namespace LangevinRigid
{
    /// <summary>The fate of a body that its batch's rules end.</summary>
    public enum EndAction : int
    {
        /// <summary>The body is destroyed and its id becomes stale.</summary>
        Destroy = 0,
        /// <summary>The body restarts where the batch's emitter puts it, at age 0, with its id and noise
        /// seed.</summary>
        Respawn = 1,
    }

    /// <summary>Shapes of kill volumes.</summary>
    public enum VolumeShape : int
    {
        /// <summary><c>size</c> is its normal, <c>center</c> a point of it; inside: behind it, away from the
        /// normal.</summary>
        Plane = 0,
        /// <summary>Axis-aligned; size: half extents.</summary>
        Box = 1,
        /// <summary>Size[0]: radius.</summary>
        Sphere = 2,
    }

    /// <summary>The side of a kill volume on which bodies end.</summary>
    public enum KillSide : int
    {
        /// <summary>The header's <c>LR_KILL_INSIDE</c>.</summary>
        Inside = 0,
        /// <summary>The header's <c>LR_KILL_OUTSIDE</c>.</summary>
        Outside = 1,
    }

    /// <summary>The fate of a diverged body.</summary>
    public enum DivergencePolicy : int
    {
        /// <summary><see cref="DivergencePolicy.Remove"/> in a batch with rules, else
        /// <see cref="DivergencePolicy.Freeze"/>.</summary>
        Auto = 0,
        /// <summary>The body is held where it was last valid.</summary>
        Freeze = 1,
        /// <summary>The body respawns if the batch's rules respawn, else it is destroyed.</summary>
        Remove = 2,
    }

    /// <summary>Shapes in which an emitter spawns bodies.</summary>
    public enum EmitterShape : int
    {
        /// <summary>The header's <c>LR_EMIT_POINT</c>.</summary>
        Point = 0,
        /// <summary>Filled evenly.</summary>
        Box = 1,
        /// <summary>Filled evenly.</summary>
        Sphere = 2,
        /// <summary>Filled evenly, in the plane of the shape's x and y axes.</summary>
        Disc = 3,
        /// <summary>Covered evenly.</summary>
        BoxSurface = 4,
        /// <summary>Covered evenly if its three sizes are equal.</summary>
        SphereSurface = 5,
    }

    /// <summary>Orientations of spawned bodies.</summary>
    public enum EmitterPose : int
    {
        /// <summary>Every orientation is equally likely.</summary>
        Random = 0,
        /// <summary>Body_orientation.</summary>
        Fixed = 1,
    }

    /// <summary>The header's <c>struct lr_kill_volume</c>.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct KillVolume
    {
        /// <summary><see cref="VolumeShape"/></summary>
        public VolumeShape Shape;
        /// <summary><see cref="KillSide"/>: the side on which bodies end</summary>
        public KillSide Side;
        /// <summary>m, up to 1e9 in magnitude</summary>
        public Float3 Center;
        /// <summary>m; of a plane its normal, any length but 0</summary>
        public Float3 Size;
    }

    /// <summary>When the bodies of a batch end. Diverged bodies end under any rules, unless
    /// <see cref="Native.lr_batch_set_divergence_policy"/> holds them.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct BatchRules
    {
        /// <summary>Size of the struct in bytes, set by <c>Create</c>.</summary>
        public uint StructSize;
        /// <summary><see cref="EndAction"/>; default <see cref="EndAction.Destroy"/></summary>
        public EndAction Action;
        /// <summary>s, up to 1e9; default 0: no limit</summary>
        public float MaxAge;
        /// <summary>elements of <c>Volumes</c> in use; default 0</summary>
        public uint VolumeCount;
        /// <summary>tested with the centre of mass. Element 0 of 8.</summary>
        public KillVolume Volumes0;
        /// <summary>tested with the centre of mass. Element 1 of 8.</summary>
        public KillVolume Volumes1;
        /// <summary>tested with the centre of mass. Element 2 of 8.</summary>
        public KillVolume Volumes2;
        /// <summary>tested with the centre of mass. Element 3 of 8.</summary>
        public KillVolume Volumes3;
        /// <summary>tested with the centre of mass. Element 4 of 8.</summary>
        public KillVolume Volumes4;
        /// <summary>tested with the centre of mass. Element 5 of 8.</summary>
        public KillVolume Volumes5;
        /// <summary>tested with the centre of mass. Element 6 of 8.</summary>
        public KillVolume Volumes6;
        /// <summary>tested with the centre of mass. Element 7 of 8.</summary>
        public KillVolume Volumes7;

        /// <summary>Element <paramref name="index"/> of the 8.</summary>
        public ref KillVolume Volumes(int index)
        {
            if ((uint)index >= 8u) throw new ArgumentOutOfRangeException("index");
            fixed (KillVolume* first = &Volumes0) return ref first[index];
        }

        /// <summary>A struct with its initial values and its size.</summary>
        public static BatchRules Create()
        {
            var value = default(BatchRules);
            LangevinLibrary.EnsureLoaded();
            LangevinException.Check(Native.lr_batch_rules_init(&value, (uint)sizeof(BatchRules)), "lr_batch_rules_init");
            return value;
        }
    }

    /// <summary>How bodies of a batch spawn. Random values depend only on the world's seed, the body's noise seed, and
    /// the number of times it has respawned.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct EmitterDesc
    {
        /// <summary>Size of the struct in bytes, set by <c>Create</c>.</summary>
        public uint StructSize;
        /// <summary><see cref="EmitterShape"/>; default <see cref="EmitterShape.Point"/></summary>
        public EmitterShape Shape;
        /// <summary>m, centre of the shape; default 0</summary>
        public Float3 Position;
        /// <summary>of the shape, x y z w, normalised by the call; default 0 0 0 1</summary>
        public Float4 Orientation;
        /// <summary>m, half extents or semi-axes along the shape's own axes, 0 to 1e9; default 0</summary>
        public Float3 Size;
        /// <summary><see cref="EmitterPose"/>, of the bodies; default <see cref="EmitterPose.Random"/></summary>
        public EmitterPose Pose;
        /// <summary>body to world, normalised by the call; default 0 0 0 1</summary>
        public Float4 BodyOrientation;
        /// <summary>of the velocity, world frame, any length but 0; default 0, -1, 0</summary>
        public Float3 Direction;
        /// <summary>rad, half angle of a cone about <c>Direction</c>, filled evenly, 0 to pi; default 0</summary>
        public float Spread;
        /// <summary>m/s, uniform in this range; default 0</summary>
        public float SpeedMin;
        /// <summary>m/s, uniform in this range; default 0</summary>
        public float SpeedMax;
        /// <summary>rad/s, uniform in this range, about a random axis; default 0</summary>
        public float SpinMin;
        /// <summary>rad/s, uniform in this range, about a random axis; default 0</summary>
        public float SpinMax;
        /// <summary>uniform in this range; default 1</summary>
        public float ScaleMin;
        /// <summary>uniform in this range; default 1</summary>
        public float ScaleMax;
        /// <summary>spawns per second, 0 to 1e9; default 0: bodies respawn, but none are added</summary>
        public float Rate;
        /// <summary>s between bursts, &gt;= 1e-4</summary>
        public float BurstInterval;
        /// <summary>spawns in each burst; default 0: no bursts</summary>
        public uint BurstCount;
        /// <summary>0.</summary>
        public uint Reserved;

        /// <summary>A struct with its initial values and its size.</summary>
        public static EmitterDesc Create()
        {
            var value = default(EmitterDesc);
            LangevinLibrary.EnsureLoaded();
            LangevinException.Check(Native.lr_emitter_desc_init(&value, (uint)sizeof(EmitterDesc)), "lr_emitter_desc_init");
            return value;
        }
    }

    /// <summary>Numbers of bodies that rules ended and the emitter spawned in the last step, and totals since the batch
    /// was created. <see cref="Native.lr_world_get_events"/> names the bodies.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct BatchCounts
    {
        /// <summary>Size of the struct in bytes, set by <c>Create</c>.</summary>
        public uint StructSize;
        /// <summary>by rate and bursts</summary>
        public uint Spawned;
        /// <summary>by the rules</summary>
        public uint Destroyed;
        /// <summary>Respawned.</summary>
        public uint Respawned;
        /// <summary>spawns dropped for lack of room</summary>
        public uint Missed;
        /// <summary>diverged: <see cref="Native.lr_batch_set_divergence_policy"/></summary>
        public uint ByDivergence;
        /// <summary>By age.</summary>
        public uint ByAge;
        /// <summary>By volume.</summary>
        public fixed uint ByVolume[8];
        /// <summary>bodies that diverged in the last step, held or ended</summary>
        public uint Diverged;
        /// <summary>including <see cref="Native.lr_batch_spawn"/>, <see cref="Native.lr_batch_spawn_box"/></summary>
        public ulong TotalSpawned;
        /// <summary>Total destroyed.</summary>
        public ulong TotalDestroyed;
        /// <summary>Total respawned.</summary>
        public ulong TotalRespawned;
        /// <summary>Total missed.</summary>
        public ulong TotalMissed;
        /// <summary>Total diverged.</summary>
        public ulong TotalDiverged;

        /// <summary>A struct with its initial values and its size.</summary>
        public static BatchCounts Create()
        {
            var value = default(BatchCounts);
            LangevinLibrary.EnsureLoaded();
            LangevinException.Check(Native.lr_batch_counts_init(&value, (uint)sizeof(BatchCounts)), "lr_batch_counts_init");
            return value;
        }
    }
}
