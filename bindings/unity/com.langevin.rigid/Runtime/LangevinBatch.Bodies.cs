// SPDX-License-Identifier: MIT
using System;
using LangevinRigid;
using UnityEngine;

namespace LangevinUnity
{
    /// <summary>Where a body is and how it moves, in Unity's world.</summary>
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
        /// <summary>Uniform.</summary>
        public float scale;
        /// <summary>s.</summary>
        public float age;
        /// <summary>Whether it is at rest.</summary>
        public bool resting;
    }

    public sealed unsafe partial class LangevinBatch
    {
        private IntPtr Ready()
        {
            if (Simulation == null || id.IsNull)
                throw new InvalidOperationException("LangevinBatch \"" + name +
                    "\" is in no world: there is none that is enabled, or it could not join (see the console).");
            World.CompleteStep();
            return Simulation.Handle;
        }

        /// <summary>Bodies at present.</summary>
        public int Count
        {
            get
            {
                BatchView view = BatchView.Create();
                LangevinSimulation.Check(Native.lr_batch_get_view(Ready(), id, &view), "lr_batch_get_view");
                return (int)view.Count;
            }
        }

        /// <summary>Arrays of the state of all bodies where they lie, in the LIBRARY's frame (z mirrored); valid until the world's next
        /// change.</summary>
        public BatchView View()
        {
            BatchView view = BatchView.Create();
            LangevinSimulation.Check(Native.lr_batch_get_view(Ready(), id, &view), "lr_batch_get_view");
            return view;
        }

        /// <summary>One body with its centre of mass there.</summary>
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

        /// <summary>One body at rest in the air.</summary>
        public BodyId Spawn(Vector3 position, Quaternion rotation)
        {
            return Spawn(position, rotation, Vector3.zero, Vector3.zero, 1.0f);
        }

        /// <summary>Bears `count` bodies by the emitter now, all or none.</summary>
        public void Emit(int count)
        {
            LangevinSimulation.Check(Native.lr_batch_spawn(Ready(), id, (uint)Mathf.Max(0, count), null), "lr_batch_spawn");
        }

        /// <summary>Ends a body of this world.</summary>
        public void Despawn(BodyId body)
        {
            LangevinSimulation.Check(Native.lr_body_destroy(Ready(), &body, 1), "lr_body_destroy");
        }

        /// <summary>The state of a body; false if it is there no more.</summary>
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

        /// <summary>A force and a torque on a body over the next step, or an impulse now, at its centre of mass.</summary>
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

        /// <summary>An acceleration of all bodies, m/s^2, until changed.</summary>
        public void SetAcceleration(Vector3 acceleration)
        {
            IntPtr world = Ready();
            BatchForce native = BatchForce.Create();
            native.Acceleration = LangevinConversion.ToLibrary(acceleration);
            LangevinSimulation.Check(Native.lr_batch_set_force(world, id, &native), "lr_batch_set_force");
        }

        /// <summary>Puts a body to rest where it is, or wakes it.</summary>
        public void SetSleep(BodyId body, bool resting)
        {
            Status status = Native.lr_body_set_sleep(Ready(), &body, 1, resting ? SleepState.Asleep : SleepState.Awake);
            LangevinSimulation.Check(status, "lr_body_set_sleep");
        }

        /// <summary>Whether bodies of this batch and of another meet.</summary>
        public void SetMeets(LangevinBatch other, bool meet)
        {
            if (other == null) throw new ArgumentNullException("other");
            if (other.World != World) throw new ArgumentException("The batches are in different worlds.", "other");
            Status status = Native.lr_batch_set_body_contact(Ready(), id, other.id, meet ? 1 : 0);
            LangevinSimulation.Check(status, "lr_batch_set_body_contact");
        }

        /// <summary>How many bodies rules and emitter ended and spawned in the last step, and in total.</summary>
        public BatchCounts Counts()
        {
            BatchCounts counts = BatchCounts.Create();
            LangevinSimulation.Check(Native.lr_batch_get_counts(Ready(), id, &counts), "lr_batch_get_counts");
            return counts;
        }

        /// <summary>A box around all bodies, in Unity's world; its size is 0 where there are none.</summary>
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
