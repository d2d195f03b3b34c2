// SPDX-License-Identifier: MIT
using System;

namespace LangevinRigid
{
    public sealed unsafe partial class World
    {
        /// <summary>Whether a body exists; false for a destroyed body and for the null handle.</summary>
        public bool IsValid(BodyId body)
        {
            int valid = Native.lr_body_is_valid(Enter(), body);
            Leave(Status.Ok, "lr_body_is_valid");
            return valid != 0;
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

        /// <summary>Destroys the bodies of an array, all or none.</summary>
        public void DestroyBodies(BodyId[] bodies)
        {
            if (bodies == null) throw new ArgumentNullException("bodies");
            fixed (BodyId* first = bodies) DestroyBodies(first, bodies.Length);
        }

        /// <summary>Puts a body to sleep, or wakes it.</summary>
        public void SetSleep(BodyId body, SleepState rest)
        {
            SetSleep(&body, 1, rest);
        }

        /// <summary>Puts bodies of any batches to sleep, or wakes them, all or none.</summary>
        public void SetSleep(BodyId* bodies, int count, SleepState rest)
        {
            uint number = Counts.Of(count);
            Leave(Native.lr_body_set_sleep(EnterChange(), bodies, number, rest), "lr_body_set_sleep");
        }

        /// <summary>Puts the bodies of an array to sleep, or wakes them, all or none.</summary>
        public void SetSleep(BodyId[] bodies, SleepState rest)
        {
            if (bodies == null) throw new ArgumentNullException("bodies");
            fixed (BodyId* first = bodies) SetSleep(first, bodies.Length, rest);
        }

        /// <summary>Wakes all sleeping bodies that overlap a box; returns their number.</summary>
        public int WakeBox(Float3 low, Float3 high)
        {
            uint woken;
            Leave(Native.lr_world_wake_box(EnterChange(), &low.X, &high.X, &woken), "lr_world_wake_box");
            return (int)woken;
        }

        /// <summary>Adds a force to a body.</summary>
        public void AddForce(BodyForce force)
        {
            AddForces(&force, 1);
        }

        /// <summary>Adds forces to bodies of any batches, all or none; a body can occur more than once.</summary>
        public void AddForces(BodyForce* forces, int count)
        {
            uint number = Counts.Of(count);
            Leave(Native.lr_body_add_force(EnterChange(), forces, number), "lr_body_add_force");
        }

        /// <summary>Adds the forces of an array, all or none.</summary>
        public void AddForces(BodyForce[] forces)
        {
            if (forces == null) throw new ArgumentNullException("forces");
            fixed (BodyForce* first = forces) AddForces(first, forces.Length);
        }
    }
}
