// SPDX-License-Identifier: MIT
using System;
using LangevinRigid;
using UnityEngine;

namespace LangevinUnity
{
    /// <summary>The state of a body, in Unity's world.</summary>
    public struct LangevinBodyState
    {
        /// <summary>m, of the centre of mass.</summary>
        public Vector3 position;
        /// <summary>Body to world.</summary>
        public Quaternion rotation;
        /// <summary>m/s.</summary>
        public Vector3 velocity;
        /// <summary>rad/s.</summary>
        public Vector3 angularVelocity;
        /// <summary>The uniform scale.</summary>
        public float scale;
        /// <summary>s.</summary>
        public float age;
        /// <summary>Whether it is asleep.</summary>
        public bool resting;
    }

    public sealed unsafe partial class LangevinBatch
    {
        private IntPtr Ready()
        {
            if (Simulation == null || id.IsNull)
                throw new InvalidOperationException("LangevinBatch \"" + name +
                    "\" is in no world: no world is enabled, or the batch could not join (see the console).");
            World.CompleteStep();
            return Simulation.Handle;
        }

        /// <summary>The number of bodies.</summary>
        public int Count
        {
            get
            {
                BatchView view = BatchView.Create();
                LangevinSimulation.Check(Native.lr_batch_get_view(Ready(), id, &view), "lr_batch_get_view");
                return (int)view.Count;
            }
        }

        /// <summary>The state of all bodies as arrays in the library's memory and in the LIBRARY's frame (z mirrored). Valid until the world's
        /// next change.</summary>
        public BatchView View()
        {
            BatchView view = BatchView.Create();
            LangevinSimulation.Check(Native.lr_batch_get_view(Ready(), id, &view), "lr_batch_get_view");
            return view;
        }

        /// <summary>Creates a body with its centre of mass at `position`.</summary>
        public BodyId Spawn(Vector3 position, Quaternion rotation, Vector3 velocity, Vector3 angularVelocity, float scale)
        {
            IntPtr world = Ready();
            BodyDesc desc = BodyDesc.Create();
            desc.Position = LangevinConversion.ToLibrary(position);
            desc.Orientation = LangevinConversion.ToLibrary(rotation, mirror);
            desc.LinearVelocity = LangevinConversion.ToLibrary(velocity);
            desc.AngularVelocity = LangevinConversion.SpinToLibrary(angularVelocity);
            desc.Scale = scale;
            BodyId body;
            LangevinSimulation.Check(Native.lr_body_create(world, id, &desc, 1, &body), "lr_body_create");
            return body;
        }

        /// <summary>Creates a body without velocity, at scale 1.</summary>
        public BodyId Spawn(Vector3 position, Quaternion rotation)
        {
            return Spawn(position, rotation, Vector3.zero, Vector3.zero, 1.0f);
        }

        /// <summary>Spawns `count` bodies from the emitter now, all or none.</summary>
        public void Emit(int count)
        {
            LangevinSimulation.Check(Native.lr_batch_spawn(Ready(), id, (uint)Mathf.Max(0, count), null), "lr_batch_spawn");
        }

        /// <summary>Destroys a body of this world.</summary>
        public void Despawn(BodyId body)
        {
            LangevinSimulation.Check(Native.lr_body_destroy(Ready(), &body, 1), "lr_body_destroy");
        }

        /// <summary>Reads the state of a body; false if it no longer exists.</summary>
        public bool TryGetState(BodyId body, out LangevinBodyState state)
        {
            BodyState native = BodyState.Create();
            Status status = Native.lr_body_get_state(Ready(), body, &native);
            state = default(LangevinBodyState);
            bool gone = status == Status.StaleBody;
            LangevinSimulation.Check(gone ? Status.Ok : status, "lr_body_get_state");
            if (gone) return false;
            state.position = LangevinConversion.ToUnity(native.Position);
            state.rotation = LangevinConversion.ToUnity(native.Orientation, mirror);
            state.velocity = LangevinConversion.ToUnity(native.LinearVelocity);
            state.angularVelocity = LangevinConversion.SpinToUnity(native.AngularVelocity);
            state.scale = native.Scale;
            state.age = native.Age;
            state.resting = native.SleepState == SleepState.Asleep;
            return true;
        }

        /// <summary>Adds a force and a torque at a body's centre of mass, over the next step or, as an impulse, now.</summary>
        public void AddForce(BodyId body, Vector3 force, Vector3 torque, LangevinRigid.ForceMode mode)
        {
            IntPtr world = Ready();
            BodyForce native = BodyForce.Create();
            native.Body = body;
            native.Mode = mode;
            native.Force = LangevinConversion.ToLibrary(force);
            native.Torque = LangevinConversion.SpinToLibrary(torque);
            LangevinSimulation.Check(Native.lr_body_add_force(world, &native, 1), "lr_body_add_force");
        }

        /// <summary>Accelerates all bodies, m/s^2, until changed.</summary>
        public void SetAcceleration(Vector3 acceleration)
        {
            IntPtr world = Ready();
            BatchForce native = BatchForce.Create();
            native.Acceleration = LangevinConversion.ToLibrary(acceleration);
            LangevinSimulation.Check(Native.lr_batch_set_force(world, id, &native), "lr_batch_set_force");
        }

        /// <summary>Puts a body to sleep in its place, or wakes it.</summary>
        public void SetSleep(BodyId body, bool resting)
        {
            Status status = Native.lr_body_set_sleep(Ready(), &body, 1, resting ? SleepState.Asleep : SleepState.Awake);
            LangevinSimulation.Check(status, "lr_body_set_sleep");
        }

        /// <summary>Switches contact between bodies of this batch and of another.</summary>
        public void SetBodyContact(LangevinBatch other, bool enabled)
        {
            if (other == null) throw new ArgumentNullException("other");
            if (other.World != World) throw new ArgumentException("The batches are in different worlds.", "other");
            Status status = Native.lr_batch_set_body_contact(Ready(), id, other.id, enabled ? 1 : 0);
            LangevinSimulation.Check(status, "lr_batch_set_body_contact");
        }

        /// <summary>Bodies spawned and ended by emitter and rules, in the last step and in total.</summary>
        public BatchCounts Counts()
        {
            BatchCounts counts = BatchCounts.Create();
            LangevinSimulation.Check(Native.lr_batch_get_counts(Ready(), id, &counts), "lr_batch_get_counts");
            return counts;
        }

        /// <summary>A box around all bodies, in Unity's world; of size 0 without bodies.</summary>
        public Bounds GetBounds()
        {
            Float3 low = default(Float3), high = default(Float3);
            LangevinSimulation.Check(Native.lr_batch_get_bounds(Ready(), id, &low.X, &high.X), "lr_batch_get_bounds");
            var bounds = new Bounds();
            if (low.X <= high.X) bounds.SetMinMax(new Vector3(low.X, low.Y, -high.Z), new Vector3(high.X, high.Y, -low.Z));
            return bounds;
        }
    }
}
