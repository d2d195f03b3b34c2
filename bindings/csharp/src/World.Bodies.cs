// SPDX-License-Identifier: MIT
using System;

namespace LangevinRigid
{
    public sealed unsafe partial class World
    {
        /// <summary>State of a body, world frame.</summary>
        public BodyState GetState(BodyId body)
        {
            var state = new BodyState { StructSize = (uint)sizeof(BodyState) };
            Leave(Native.lr_body_get_state(Enter(), body, &state), "lr_body_get_state");
            return state;
        }

        /// <summary>Whether a body is there; false for one that was destroyed, and for none.</summary>
        public bool IsAlive(BodyId body)
        {
            var state = new BodyState { StructSize = (uint)sizeof(BodyState) };
            Status status = Native.lr_body_get_state(Enter(), body, &state);
            Leave(status == Status.StaleBody ? Status.Ok : status, "lr_body_get_state");
            return status == Status.Ok;
        }

        /// <summary>Sets everything but the key, and wakes the body.</summary>
        public void SetState(BodyId body, BodyState state)
        {
            Leave(Native.lr_body_set_state(EnterChange(), body, &state), "lr_body_set_state");
        }

        /// <summary>Destroys a body.</summary>
        public void DestroyBody(BodyId body)
        {
            DestroyBodies(&body, 1);
        }

        /// <summary>Destroys bodies of any batches, all or none.</summary>
        public void DestroyBodies(BodyId* bodies, int count)
        {
            uint number = Counts.Of(count);
            Leave(Native.lr_body_destroy(EnterChange(), bodies, number), "lr_body_destroy");
        }

        /// <summary>The same for an array.</summary>
        public void DestroyBodies(BodyId[] bodies)
        {
            if (bodies == null) throw new ArgumentNullException("bodies");
            fixed (BodyId* first = bodies) DestroyBodies(first, bodies.Length);
        }

        /// <summary>Puts a body to rest, or wakes it.</summary>
        public void SetRest(BodyId body, RestState rest)
        {
            SetRest(&body, 1, rest);
        }

        /// <summary>Puts bodies of any batches to rest, or wakes them, all or none.</summary>
        public void SetRest(BodyId* bodies, int count, RestState rest)
        {
            uint number = Counts.Of(count);
            Leave(Native.lr_body_set_rest(EnterChange(), bodies, number, rest), "lr_body_set_rest");
        }

        /// <summary>The same for an array.</summary>
        public void SetRest(BodyId[] bodies, RestState rest)
        {
            if (bodies == null) throw new ArgumentNullException("bodies");
            fixed (BodyId* first = bodies) SetRest(first, bodies.Length, rest);
        }

        /// <summary>Wakes all bodies at rest that reach into a box; returns how many.</summary>
        public int WakeBox(Float3 low, Float3 high)
        {
            uint woken;
            Leave(Native.lr_world_wake_box(EnterChange(), &low.X, &high.X, &woken), "lr_world_wake_box");
            return (int)woken;
        }

        /// <summary>A force on a body.</summary>
        public void AddForce(BodyForce force)
        {
            AddForces(&force, 1);
        }

        /// <summary>Forces on bodies of any batches, all or none; a body may be there more than once.</summary>
        public void AddForces(BodyForce* forces, int count)
        {
            uint number = Counts.Of(count);
            Leave(Native.lr_body_add_force(EnterChange(), forces, number), "lr_body_add_force");
        }

        /// <summary>The same for an array.</summary>
        public void AddForces(BodyForce[] forces)
        {
            if (forces == null) throw new ArgumentNullException("forces");
            fixed (BodyForce* first = forces) AddForces(first, forces.Length);
        }
    }
}
