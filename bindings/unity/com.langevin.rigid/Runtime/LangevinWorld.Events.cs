// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using LangevinRigid;
using UnityEngine;
using UnityEngine.Events;

namespace LangevinUnity
{
    /// <summary>An event of a step, in Unity's world.</summary>
    public struct LangevinEvent
    {
        /// <summary>The kind of event.</summary>
        public EventKind kind;
        /// <summary>The batch of the body.</summary>
        public LangevinBatch batch;
        /// <summary>The body; stale if it was destroyed.</summary>
        public BodyId body;
        /// <summary>The body's user number.</summary>
        public ulong user;
        /// <summary>The touched or left collider; null for other events and for colliders without a component.</summary>
        public LangevinCollider collider;
        /// <summary>The contact point, or else the centre of mass, m.</summary>
        public Vector3 position;
        /// <summary>Unit normal from the collider to the body; 0 except for hits.</summary>
        public Vector3 normal;
        /// <summary>Approach speed, m/s.</summary>
        public float speed;
        /// <summary>Impulse, N s.</summary>
        public float impulse;
    }

    /// <summary>An event of LangevinEvent for handlers set in the inspector.</summary>
    [Serializable]
    public sealed class LangevinUnityEvent : UnityEvent<LangevinEvent> { }

    public sealed unsafe partial class LangevinWorld
    {
        [Header("Events")]
        [Tooltip("Largest number of events kept per step, 64 bytes each. 0: no events.")]
        [SerializeField, Min(0)] private int eventCapacity = 0;
        [SerializeField] private EventKinds eventKinds = EventKinds.Hit | EventKinds.Landed | EventKinds.Killed | EventKinds.Respawned;
        [SerializeField] private LangevinUnityEvent onEvent = new LangevinUnityEvent();

        private readonly Dictionary<BatchId, LangevinBatch> batchesById = new Dictionary<BatchId, LangevinBatch>();
        private readonly Dictionary<ColliderId, LangevinCollider> collidersById = new Dictionary<ColliderId, LangevinCollider>();
        private static readonly LangevinEvent[] none = new LangevinEvent[0];
        private LangevinEvent[] buffer = none;

        /// <summary>Raised on the main thread after a step, for each of its events, in the same order in every run. Handlers can change the
        /// world.</summary>
        public event Action<LangevinEvent> Happened;

        /// <summary>The same event, for handlers set in the inspector.</summary>
        public LangevinUnityEvent OnEvent { get { return onEvent; } }

        /// <summary>Number of events beyond the capacity since the last SetEvents.</summary>
        public long LostEvents { get; private set; }

        /// <summary>Keeps at most `capacity` events of each step; 0 disables events.</summary>
        public void SetEvents(int capacity, EventKinds kinds)
        {
            eventCapacity = capacity;
            eventKinds = kinds;
            if (Simulation == null) return;
            CompleteStep();
            ApplyEvents();
        }

        private void ApplyEvents()
        {
            // "Everything" in the inspector sets all 32 bits.
            EventKinds kinds = eventKinds & EventKinds.All;
            bool on = eventCapacity > 0 && kinds != EventKinds.None;
            Status status = Native.lr_world_set_events(simulation.Handle, on ? (uint)eventCapacity : 0u,
                on ? kinds : EventKinds.None);
            LangevinSimulation.Check(status, "lr_world_set_events");
            LostEvents = 0;
        }

        private void ForgetEvents()
        {
            batchesById.Clear();
            collidersById.Clear();
        }

        private void DispatchEvents()
        {
            if (eventCapacity <= 0 || Simulation == null) return;
            EventList list = EventList.Create();
            LangevinSimulation.Check(Native.lr_world_get_events(simulation.Handle, &list), "lr_world_get_events");
            LostEvents = (long)list.TotalLost;
            int count = (int)list.Count;
            if (count == 0) return;
            ForgetEvents();
            foreach (LangevinMember member in Members)
            {
                var batch = member as LangevinBatch;
                if (batch != null) batchesById[batch.Id] = batch;
                var collider = member as LangevinCollider;
                if (collider != null && !collider.Id.IsNull) collidersById[collider.Id] = collider;
            }
            // Copied before the first handler runs: a handler that changes the world invalidates the library's list. One that steps it dispatches events
            // from within, with a buffer of its own.
            LangevinEvent[] events = buffer.Length < count ? new LangevinEvent[Mathf.NextPowerOfTwo(count)] : buffer;
            buffer = none;
            for (int i = 0; i < count; ++i) events[i] = Convert(list.Events + i);
            for (int i = 0; i < count; ++i)
            {
                try
                {
                    if (Happened != null) Happened(events[i]);
                    onEvent.Invoke(events[i]);
                    if (events[i].batch != null) events[i].batch.Raise(events[i]);
                    if (events[i].collider != null) events[i].collider.Raise(events[i]);
                }
                catch (Exception e)
                {
                    Debug.LogException(e, this);
                }
            }
            Array.Clear(events, 0, count);
            buffer = events;
        }

        private LangevinEvent Convert(BodyEvent* from)
        {
            LangevinBatch batch;
            LangevinCollider collider = null;
            batchesById.TryGetValue(from->Batch, out batch);
            if (!from->Collider.IsNull) collidersById.TryGetValue(from->Collider, out collider);
            return new LangevinEvent
            {
                kind = from->Kind,
                batch = batch,
                body = from->Body,
                user = from->User,
                collider = collider,
                position = LangevinConversion.ToUnity(from->Position),
                normal = LangevinConversion.ToUnity(from->Normal),
                speed = from->Speed,
                impulse = from->Impulse,
            };
        }
    }
}
