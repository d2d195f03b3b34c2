// SPDX-License-Identifier: MIT
// Written by bindings/generator/csharp.py from include/langevin_rigid.h: change those.
using System;
using System.Runtime.InteropServices;

namespace LangevinRigid
{
    /// <summary>What becomes of a body that its batch's rules end.</summary>
    public enum EndAction : int
    {
        /// <summary>The body is destroyed, its id stale.</summary>
        Destroy = 0,
        /// <summary>The body begins anew where the batch's emitter says, at age 0, with the same id and key.</summary>
        Respawn = 1,
    }

    /// <summary>What becomes of a body that has left physics.</summary>
    public enum FaultPolicy : int
    {
        /// <summary>As <see cref="FaultPolicy.Remove"/> in a batch with rules, as <see cref="FaultPolicy.Freeze"/> in
        /// others.</summary>
        Auto = 0,
        /// <summary>It is held where it last was sane.</summary>
        Freeze = 1,
        /// <summary>It ends: respawns where the batch's rules do that, else is destroyed.</summary>
        Remove = 2,
    }

    /// <summary>Shapes of kill volumes.</summary>
    public enum VolumeShape : int
    {
        /// <summary>Inside: behind the plane through <c>center</c>, away from its normal <c>size</c>.</summary>
        Plane = 0,
        /// <summary>Axis-aligned; size: half extents.</summary>
        Box = 1,
        /// <summary>Size[0]: radius.</summary>
        Sphere = 2,
    }

    /// <summary>On which side of a kill volume bodies end.</summary>
    public enum KillSide : int
    {
        /// <summary>The header's <c>LR_KILL_INSIDE</c>.</summary>
        Inside = 0,
        /// <summary>The header's <c>LR_KILL_OUTSIDE</c>.</summary>
        Outside = 1,
    }

    /// <summary>Where an emitter bears bodies.</summary>
    public enum EmitterShape : int
    {
        /// <summary>The header's <c>LR_EMIT_POINT</c>.</summary>
        Point = 0,
        /// <summary>The first three fill their shape evenly.</summary>
        Box = 1,
        /// <summary>The header's <c>LR_EMIT_SPHERE</c>.</summary>
        Sphere = 2,
        /// <summary>In the plane of the shape's own x and y.</summary>
        Disc = 3,
        /// <summary>Evenly.</summary>
        BoxSurface = 4,
        /// <summary>Evenly if its three sizes are equal.</summary>
        SphereSurface = 5,
    }

    /// <summary>How bodies are turned at birth.</summary>
    public enum EmitterPose : int
    {
        /// <summary>Every orientation alike.</summary>
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
        /// <summary><see cref="KillSide"/>: where bodies end</summary>
        public KillSide Side;
        /// <summary>m, up to 1e9 in magnitude</summary>
        public Float3 Center;
        /// <summary>m; of a plane its normal, of any length but 0</summary>
        public Float3 Size;
    }

    /// <summary>When the bodies of a batch end. A body that has left physics ends under any rules, unless
    /// <see cref="Native.lr_batch_set_fault_policy"/> says that it is held.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct BatchRules
    {
        /// <summary>Size of the struct in bytes, set by <c>Create</c>.</summary>
        public uint StructSize;
        /// <summary><see cref="EndAction"/>; initially <see cref="EndAction.Destroy"/></summary>
        public EndAction Action;
        /// <summary>s, up to 1e9; initially 0: no limit</summary>
        public float MaxAge;
        /// <summary>used part of <c>Volumes</c>; initially 0</summary>
        public uint VolumeCount;
        /// <summary>by the centre of mass. Element 0 of 8.</summary>
        public KillVolume Volumes0;
        /// <summary>by the centre of mass. Element 1 of 8.</summary>
        public KillVolume Volumes1;
        /// <summary>by the centre of mass. Element 2 of 8.</summary>
        public KillVolume Volumes2;
        /// <summary>by the centre of mass. Element 3 of 8.</summary>
        public KillVolume Volumes3;
        /// <summary>by the centre of mass. Element 4 of 8.</summary>
        public KillVolume Volumes4;
        /// <summary>by the centre of mass. Element 5 of 8.</summary>
        public KillVolume Volumes5;
        /// <summary>by the centre of mass. Element 6 of 8.</summary>
        public KillVolume Volumes6;
        /// <summary>by the centre of mass. Element 7 of 8.</summary>
        public KillVolume Volumes7;

        /// <summary>Element <paramref name="index"/> of the 8.</summary>
        public ref KillVolume Volumes(int index)
        {
            if ((uint)index >= 8u) throw new ArgumentOutOfRangeException("index");
            fixed (KillVolume* first = &Volumes0) return ref first[index];
        }

        /// <summary>One with its initial values and its size.</summary>
        public static BatchRules Create()
        {
            var value = default(BatchRules);
            LangevinLibrary.EnsureLoaded();
            LangevinException.Check(Native.lr_batch_rules_init(&value, (uint)sizeof(BatchRules)), "lr_batch_rules_init");
            return value;
        }
    }

    /// <summary>How bodies of a batch are born. What is drawn for a body depends on the world's seed, its key, and how
    /// often it has respawned, and on nothing else.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct EmitterDesc
    {
        /// <summary>Size of the struct in bytes, set by <c>Create</c>.</summary>
        public uint StructSize;
        /// <summary><see cref="EmitterShape"/>; initially <see cref="EmitterShape.Point"/></summary>
        public EmitterShape Shape;
        /// <summary>m, centre of the shape; initially 0</summary>
        public Float3 Position;
        /// <summary>of the shape, x y z w, normalised when taken; initially 0 0 0 1</summary>
        public Float4 Orientation;
        /// <summary>m, half extents or semi-axes along the shape's own axes, 0 to 1e9; initially 0</summary>
        public Float3 Size;
        /// <summary><see cref="EmitterPose"/>, of the bodies; initially <see cref="EmitterPose.Random"/></summary>
        public EmitterPose Pose;
        /// <summary>body to world, normalised when taken; initially 0 0 0 1</summary>
        public Float4 BodyOrientation;
        /// <summary>of the velocity, world frame, of any length but 0; initially 0, -1, 0</summary>
        public Float3 Direction;
        /// <summary>rad, half angle of a cone about <c>Direction</c>, filled evenly, 0 to pi; initially 0</summary>
        public float Spread;
        /// <summary>m/s, evenly between; initially 0</summary>
        public float SpeedMin;
        /// <summary>m/s, evenly between; initially 0</summary>
        public float SpeedMax;
        /// <summary>rad/s, evenly between, about any axis alike; initially 0</summary>
        public float SpinMin;
        /// <summary>rad/s, evenly between, about any axis alike; initially 0</summary>
        public float SpinMax;
        /// <summary>evenly between; initially 1</summary>
        public float ScaleMin;
        /// <summary>evenly between; initially 1</summary>
        public float ScaleMax;
        /// <summary>births per second, 0 to 1e9; initially 0: bodies respawn, but none are added</summary>
        public float Rate;
        /// <summary>s between bursts, &gt;= 1e-4</summary>
        public float BurstInterval;
        /// <summary>births at once in each burst; initially 0: no bursts</summary>
        public uint BurstCount;
        /// <summary>0.</summary>
        public uint Reserved;

        /// <summary>One with its initial values and its size.</summary>
        public static EmitterDesc Create()
        {
            var value = default(EmitterDesc);
            LangevinLibrary.EnsureLoaded();
            LangevinException.Check(Native.lr_emitter_desc_init(&value, (uint)sizeof(EmitterDesc)), "lr_emitter_desc_init");
            return value;
        }
    }

    /// <summary>What rules and emitter did in the last step, and since the batch began.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct BatchEvents
    {
        /// <summary>Size of the struct in bytes, set by <c>Create</c>.</summary>
        public uint StructSize;
        /// <summary>by rate and bursts</summary>
        public uint Born;
        /// <summary>by the rules</summary>
        public uint Destroyed;
        /// <summary>Respawned.</summary>
        public uint Respawned;
        /// <summary>births for which there was no room</summary>
        public uint Missed;
        /// <summary>bodies that have left physics: <see cref="Native.lr_batch_set_fault_policy"/></summary>
        public uint ByNotFinite;
        /// <summary>By age.</summary>
        public uint ByAge;
        /// <summary>By volume.</summary>
        public fixed uint ByVolume[8];
        /// <summary>0.</summary>
        public uint Reserved;
        /// <summary>with those of <see cref="Native.lr_batch_emit"/></summary>
        public ulong TotalBorn;
        /// <summary>Total destroyed.</summary>
        public ulong TotalDestroyed;
        /// <summary>Total respawned.</summary>
        public ulong TotalRespawned;
        /// <summary>Total missed.</summary>
        public ulong TotalMissed;
        /// <summary>destroyed or respawned in the last step: destroyed + respawned of them, in no order</summary>
        public BodyId* EndedIds;
        /// <summary><c>Born</c> of them</summary>
        public BodyId* BornIds;
        /// <summary>bodies that have left physics in the last step, held or ended</summary>
        public uint Faulted;
        /// <summary>0.</summary>
        public uint Reserved1;
        /// <summary>since the batch began</summary>
        public ulong TotalFaulted;

        /// <summary>One with its initial values and its size.</summary>
        public static BatchEvents Create()
        {
            var value = default(BatchEvents);
            LangevinLibrary.EnsureLoaded();
            LangevinException.Check(Native.lr_batch_events_init(&value, (uint)sizeof(BatchEvents)), "lr_batch_events_init");
            return value;
        }
    }
}
