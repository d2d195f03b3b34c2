// SPDX-License-Identifier: MIT
// Written by bindings/generator/csharp.py from include/langevin_rigid.h: do not edit.
using System;
using System.Runtime.InteropServices;

namespace LangevinRigid
{
    /// <summary>Kinds of events.</summary>
    public enum EventKind : int
    {
        /// <summary>An emitter, <see cref="Native.lr_batch_spawn"/> or <see cref="Native.lr_batch_spawn_box"/> added it
        /// since the previous step.</summary>
        Spawned = 1,
        /// <summary>The body touches a collider that it did not touch at the end of the step before.</summary>
        Hit = 2,
        /// <summary>It no longer touches the collider, or the collider was destroyed: its id is stale.</summary>
        Lifted = 3,
        /// <summary>It fell asleep by itself.</summary>
        Landed = 4,
        /// <summary>It woke since the previous step, for any reason.</summary>
        Woke = 5,
        /// <summary>Its batch's rules or its divergence destroyed it: its id is stale.</summary>
        Killed = 6,
        /// <summary>Its batch's rules or its divergence ended it, and it restarted with its id.</summary>
        Respawned = 7,
        /// <summary>It diverged: <see cref="Native.lr_batch_set_divergence_policy"/>.</summary>
        Diverged = 8,
    }

    /// <summary>Bits for <see cref="Native.lr_world_set_events"/>.</summary>
    [Flags]
    public enum EventKinds : uint
    {
        /// <summary>No bit.</summary>
        None = 0,
        /// <summary>The header's <c>LR_EVENTS_SPAWNED</c>.</summary>
        Spawned = 1,
        /// <summary>The header's <c>LR_EVENTS_HIT</c>.</summary>
        Hit = 2,
        /// <summary>The header's <c>LR_EVENTS_LIFTED</c>.</summary>
        Lifted = 4,
        /// <summary>The header's <c>LR_EVENTS_LANDED</c>.</summary>
        Landed = 8,
        /// <summary>The header's <c>LR_EVENTS_WOKE</c>.</summary>
        Woke = 16,
        /// <summary>The header's <c>LR_EVENTS_KILLED</c>.</summary>
        Killed = 32,
        /// <summary>The header's <c>LR_EVENTS_RESPAWNED</c>.</summary>
        Respawned = 64,
        /// <summary>The header's <c>LR_EVENTS_DIVERGED</c>.</summary>
        Diverged = 128,
        /// <summary>The header's <c>LR_EVENTS_ALL</c>.</summary>
        All = 255,
    }

    /// <summary>One event: 64 bytes in arrays without gaps. This struct never changes after 0.2.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct BodyEvent
    {
        /// <summary><see cref="EventKind"/></summary>
        public EventKind Kind;
        /// <summary>Batch.</summary>
        public BatchId Batch;
        /// <summary>stale if it was destroyed</summary>
        public BodyId Body;
        /// <summary>the body's: <see cref="BodyDesc.User"/></summary>
        public ulong User;
        /// <summary><see cref="EventKind.Hit"/>, <see cref="EventKind.Lifted"/>; else id 0</summary>
        public ColliderId Collider;
        /// <summary>m, world frame: the point of contact in <see cref="EventKind.Hit"/>; where it ended in
        /// <see cref="EventKind.Killed"/> and <see cref="EventKind.Respawned"/>; the last valid centre of mass in
        /// <see cref="EventKind.Diverged"/>; else the centre of mass</summary>
        public Float3 Position;
        /// <summary><see cref="EventKind.Hit"/>: unit, world frame, from the collider to the body; else 0</summary>
        public Float3 Normal;
        /// <summary>m/s, <see cref="EventKind.Hit"/>: approach speed along the normal, &gt;= 0; else 0</summary>
        public float Speed;
        /// <summary>N s, <see cref="EventKind.Hit"/>: along the normal, in the substep of first contact; else
        /// 0</summary>
        public float Impulse;
    }

    /// <summary>The header's <c>struct lr_event_list</c>.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct EventList
    {
        /// <summary>Size of the struct in bytes, set by <c>Create</c>.</summary>
        public uint StructSize;
        /// <summary>Count.</summary>
        public uint Count;
        /// <summary>of the last step; null before <see cref="Native.lr_world_set_events"/></summary>
        public BodyEvent* Events;
        /// <summary>events of the last step beyond capacity: those last in order are dropped</summary>
        public ulong Lost;
        /// <summary>since <see cref="Native.lr_world_set_events"/></summary>
        public ulong TotalLost;
        /// <summary>as set by <see cref="Native.lr_world_set_events"/></summary>
        public uint Capacity;
        /// <summary><see cref="EventKinds"/>, likewise</summary>
        public EventKinds Kinds;

        /// <summary>A struct with its initial values and its size.</summary>
        public static EventList Create()
        {
            var value = default(EventList);
            LangevinLibrary.EnsureLoaded();
            LangevinException.Check(Native.lr_event_list_init(&value, (uint)sizeof(EventList)), "lr_event_list_init");
            return value;
        }
    }
}
