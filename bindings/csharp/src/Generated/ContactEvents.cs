// SPDX-License-Identifier: MIT
// Written by bindings/generator/csharp.py from include/langevin_rigid.h: change those.
using System;
using System.Runtime.InteropServices;

namespace LangevinRigid
{
    /// <summary>What happened to a body.</summary>
    public enum ContactEventKind : int
    {
        /// <summary>A body touches a collider that it did not touch at the end of the step before.</summary>
        ContactBegin = 1,
        /// <summary>It no longer does, or the collider has been destroyed, whose id is then stale.</summary>
        ContactEnd = 2,
        /// <summary>It has come to rest by itself.</summary>
        BodyLanded = 3,
        /// <summary>It has left rest since the step before, whatever for.</summary>
        BodyWoke = 4,
        /// <summary>Its batch's rules have ended it; with <see cref="EndAction.Respawn"/> it goes on with the same
        /// id.</summary>
        BodyKilled = 5,
        /// <summary>It has left physics: <see cref="Native.lr_batch_set_fault_policy"/>.</summary>
        BodyFaulted = 6,
    }

    /// <summary>Bits for <see cref="Native.lr_world_set_contact_events"/>.</summary>
    [Flags]
    public enum ContactEvents : uint
    {
        /// <summary>No bit.</summary>
        None = 0,
        /// <summary>The header's <c>LR_EVENTS_BEGIN</c>.</summary>
        Begin = 1,
        /// <summary>The header's <c>LR_EVENTS_END</c>.</summary>
        End = 2,
        /// <summary>The header's <c>LR_EVENTS_LANDED</c>.</summary>
        Landed = 4,
        /// <summary>The header's <c>LR_EVENTS_WOKE</c>.</summary>
        Woke = 8,
        /// <summary>The header's <c>LR_EVENTS_KILLED</c>.</summary>
        Killed = 16,
        /// <summary>The header's <c>LR_EVENTS_FAULTED</c>.</summary>
        Faulted = 32,
        /// <summary>The header's <c>LR_EVENTS_ALL</c>.</summary>
        All = 63,
    }

    /// <summary>Never changes: 64 bytes, an element of arrays without gaps.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct ContactEvent
    {
        /// <summary><see cref="ContactEventKind"/></summary>
        public ContactEventKind Kind;
        /// <summary>Batch.</summary>
        public BatchId Batch;
        /// <summary>stale where it has been destroyed</summary>
        public BodyId Body;
        /// <summary><see cref="ContactFlags"/>; else 0</summary>
        public ColliderId Collider;
        /// <summary>m, world frame: of <see cref="ContactEventKind.ContactBegin"/> where they touch, else of the centre
        /// of mass; of one that has left physics where that was last sane</summary>
        public Float3 Position;
        /// <summary><see cref="ContactEventKind.ContactBegin"/>: unit, world frame, from the collider to the body; else
        /// 0</summary>
        public Float3 Normal;
        /// <summary>m/s, <see cref="ContactEventKind.ContactBegin"/>: at which they approach each other along the
        /// normal, &gt;= 0; else 0</summary>
        public float Speed;
        /// <summary>N s, <see cref="ContactEventKind.ContactBegin"/>: along the normal, of the substep in which they
        /// meet; else 0</summary>
        public float Impulse;
        /// <summary>0.</summary>
        public UInt2 Reserved;
    }

    /// <summary>The header's <c>struct lr_contact_event_list</c>.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct ContactEventList
    {
        /// <summary>Size of the struct in bytes, set by <c>Create</c>.</summary>
        public uint StructSize;
        /// <summary>Count.</summary>
        public uint Count;
        /// <summary>of the last step; null before <see cref="Native.lr_world_set_contact_events"/></summary>
        public ContactEvent* Events;
        /// <summary>events of the last step for which there was no room: the last ones in their order</summary>
        public ulong Lost;
        /// <summary>since <see cref="Native.lr_world_set_contact_events"/></summary>
        public ulong TotalLost;

        /// <summary>One with its initial values and its size.</summary>
        public static ContactEventList Create()
        {
            var value = default(ContactEventList);
            LangevinLibrary.EnsureLoaded();
            LangevinException.Check(Native.lr_contact_event_list_init(&value, (uint)sizeof(ContactEventList)), "lr_contact_event_list_init");
            return value;
        }
    }
}
