// SPDX-License-Identifier: MIT
// Written by bindings/generator/csharp.py from include/langevin_rigid.h: do not edit.
namespace LangevinRigid
{
    public sealed unsafe partial class World
    {
        /// <summary>Reads counts, time and settings of the world. <see cref="Native.lr_world_get_info"/></summary>
        public WorldInfo Info
        {
            get
            {
                WorldInfo value = new WorldInfo { StructSize = (uint)sizeof(WorldInfo) };
                Leave(Native.lr_world_get_info(Enter(), &value), "lr_world_get_info");
                return value;
            }
        }

        /// <summary>Sets the instruction set from the next step on. <see cref="Native.lr_world_set_simd_target"/></summary>
        /// <param name="target"><see cref="SimdTarget"/>.</param>
        public void SetSimdTarget(SimdTarget target)
        {
            Leave(Native.lr_world_set_simd_target(EnterChange(), target), "lr_world_set_simd_target");
        }

        /// <summary>Sets the water from the next step on. <see cref="Native.lr_world_set_water"/></summary>
        public void SetWater(WaterDesc desc)
        {
            Leave(Native.lr_world_set_water(EnterChange(), &desc), "lr_world_set_water");
        }

        /// <summary>Undoes <see cref="SetWater(WaterDesc)"/>.</summary>
        public void ClearWater()
        {
            Leave(Native.lr_world_set_water(EnterChange(), null), "lr_world_set_water");
        }

        /// <summary>Limits the work of each step to a number of substeps of single bodies.
        /// <see cref="Native.lr_world_set_budget"/></summary>
        /// <param name="bodySubsteps">at most 2^48; 0, the default, for no limit.</param>
        public void SetBudget(ulong bodySubsteps)
        {
            Leave(Native.lr_world_set_budget(EnterChange(), bodySubsteps), "lr_world_set_budget");
        }

        /// <summary>Reads the report of the last step. <see cref="Native.lr_world_get_step_report"/></summary>
        public StepReport StepReport
        {
            get
            {
                StepReport value = new StepReport { StructSize = (uint)sizeof(StepReport) };
                Leave(Native.lr_world_get_step_report(Enter(), &value), "lr_world_get_step_report");
                return value;
            }
        }

        /// <summary>Reads the timings of the last step. <see cref="Native.lr_world_get_timings"/></summary>
        public Timings Timings
        {
            get
            {
                Timings value = new Timings { StructSize = (uint)sizeof(Timings) };
                Leave(Native.lr_world_get_timings(Enter(), &value), "lr_world_get_timings");
                return value;
            }
        }

        /// <summary>Reads the state of a body. <see cref="Native.lr_body_get_state"/></summary>
        public BodyState GetState(BodyId body)
        {
            BodyState value = new BodyState { StructSize = (uint)sizeof(BodyState) };
            Leave(Native.lr_body_get_state(Enter(), body, &value), "lr_body_get_state");
            return value;
        }

        /// <summary>Sets everything but the noise seed, and wakes the body. <see cref="Native.lr_body_set_state"/></summary>
        public void SetState(BodyId body, BodyState state)
        {
            Leave(Native.lr_body_set_state(EnterChange(), body, &state), "lr_body_set_state");
        }

        /// <summary>Reads the state of a collider. <see cref="Native.lr_collider_get_state"/></summary>
        public ColliderState GetState(ColliderId collider)
        {
            ColliderState value = new ColliderState { StructSize = (uint)sizeof(ColliderState) };
            Leave(Native.lr_collider_get_state(Enter(), collider, &value), "lr_collider_get_state");
            return value;
        }

        /// <summary>Enables events; at most <c>capacity</c> are stored per step.
        /// <see cref="Native.lr_world_set_events"/></summary>
        /// <param name="capacity">number of elements that fit</param>
        /// <param name="kinds">bits <see cref="EventKinds"/>.</param>
        public void SetEvents(int capacity, EventKinds kinds)
        {
            uint number = Counts.Of(capacity);
            Leave(Native.lr_world_set_events(EnterChange(), number, kinds), "lr_world_set_events");
        }

        /// <summary>Gets the events of the last step. <see cref="Native.lr_world_get_events"/></summary>
        public EventList GetEvents()
        {
            EventList value = new EventList { StructSize = (uint)sizeof(EventList) };
            Leave(Native.lr_world_get_events(Enter(), &value), "lr_world_get_events");
            return value;
        }

        /// <summary>Computes the loads on a body from its present state, wind and water; on a sleeping body as if its wake had
        /// ended. <see cref="Native.lr_body_get_loads"/></summary>
        public BodyLoads GetLoads(BodyId body)
        {
            BodyLoads value = new BodyLoads { StructSize = (uint)sizeof(BodyLoads) };
            Leave(Native.lr_body_get_loads(Enter(), body, &value), "lr_body_get_loads");
            return value;
        }
    }
}
