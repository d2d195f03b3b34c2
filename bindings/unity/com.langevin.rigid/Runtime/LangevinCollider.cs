// SPDX-License-Identifier: MIT
using System;
using LangevinRigid;
using UnityEngine;

namespace LangevinUnity
{
    /// <summary>Adds a Unity collider of the same GameObject to the world: Box, Sphere, Capsule, Mesh or Terrain. It follows the transform and
    /// carries, pushes and throws bodies. Bodies do not push it. It has the layer of the GameObject.</summary>
    [AddComponentMenu("Langevin Rigid/Langevin Collider")]
    public sealed unsafe class LangevinCollider : LangevinMember
    {
        [Tooltip("The Unity collider to use. Empty: the first of this GameObject.")]
        [SerializeField] private Collider source = null;
        [Tooltip("Takes dynamic friction and bounciness from the collider's physics material, if it has one.")]
        [SerializeField] private bool usePhysicsMaterial = true;
        [SerializeField, Range(0.0f, 10.0f)] private float friction = 0.5f;
        [SerializeField, Range(0.0f, 1.0f)] private float restitution = 0.2f;
        [Tooltip("Metres. If the collider moves farther in a step, it teleports instead of sweeping bodies along.")]
        [SerializeField, Min(0.0f)] private float teleportDistance = 5.0f;
        [Tooltip("The collider and its shape never change, so no step checks them. For thousands of scenery objects.")]
        [SerializeField] private bool neverMoves = false;
        [SerializeField] private LangevinUnityEvent onEvent = new LangevinUnityEvent();

        private ColliderId id;
        private LangevinShape shape;
        private Vector3 position;
        private Quaternion rotation;
        private uint layers;
        private float frictionSet;
        private float restitutionSet;
        private bool refused;
        private int refusedKey;

        /// <summary>The library's handle; null outside a world.</summary>
        public ColliderId Id { get { return id; } }

        /// <summary>The Unity collider that gives the shape. Set it while the component is disabled.</summary>
        public Collider Source { get { return source; } set { source = value; } }

        /// <summary>Whether it is read once, when it joins the world, and never checked again.</summary>
        public bool NeverMoves { get { return neverMoves; } set { neverMoves = value; } }

        /// <summary>Raised when a body starts or stops touching it.</summary>
        public event Action<LangevinEvent> Happened;

        internal void Raise(LangevinEvent e)
        {
            if (Happened != null) Happened(e);
            onEvent.Invoke(e);
        }

        internal override void OnJoin(LangevinSimulation simulation)
        {
            if (source == null) source = GetComponent<Collider>();
            if (source == null) throw new InvalidOperationException("LangevinCollider \"" + name + "\" has no Unity collider beside it.");
            Create(simulation);
        }

        internal override void OnLeave(LangevinSimulation simulation)
        {
            if (id.IsNull) return;
            ColliderId gone = id;
            id = default(ColliderId);
            simulation.GoneColliders.Add(gone);
            LangevinSimulation.Check(Native.lr_collider_destroy(simulation.Handle, &gone, 1), "lr_collider_destroy");
        }

        // The next step moves it to its transform, or creates it again.
        internal override void OnRestored(LangevinSimulation simulation)
        {
            if (id.IsNull) return;
            if (Native.lr_collider_is_valid(simulation.Handle, id) == 0)
            {
                id = default(ColliderId);
                return;
            }
            ColliderState state = ColliderState.Create();
            LangevinSimulation.Check(Native.lr_collider_get_state(simulation.Handle, id, &state), "lr_collider_get_state");
            position = LangevinConversion.ToUnity(state.Position);
            rotation = LangevinConversion.ToUnity(state.Orientation);
            layers = state.Layers;
            frictionSet = state.Friction;
            restitutionSet = state.Restitution;
        }

        protected override void OnDisable()
        {
            base.OnDisable();
            id = default(ColliderId);
            shape = null;
        }

        /// <summary>Reads the Unity collider again. Needed after a change of a terrain's heights or a mesh's vertices, which are not detected
        /// automatically.</summary>
        public void Rebuild()
        {
            if (Simulation == null || source == null) return;
            World.CompleteStep();
            OnLeave(Simulation);
            Create(Simulation);
        }

        private void Create(LangevinSimulation simulation)
        {
            shape = LangevinColliderShapes.Of(source);
            ReadSurface();
            ColliderDesc desc = ColliderDesc.Create();
            desc.Kind = shape.Kind;
            desc.Size = shape.Size;
            desc.Friction = frictionSet;
            desc.Restitution = restitutionSet;
            desc.Layers = layers;
            desc.Counts = shape.Counts;
            desc.Spacing = shape.Spacing;
            position = shape.PositionOf(transform);
            rotation = shape.RotationOf(transform);
            desc.Position = LangevinConversion.ToLibrary(position);
            desc.Orientation = LangevinConversion.ToLibrary(rotation);
            ColliderId created;
            Status status;
            fixed (Float3* vertices = shape.Vertices)
            fixed (uint* indices = shape.Indices)
            fixed (float* heights = shape.Heights)
            {
                desc.Vertices = (float*)vertices;
                desc.VertexCount = shape.Vertices == null ? 0u : (uint)shape.Vertices.Length;
                desc.Indices = indices;
                desc.TriangleCount = shape.Indices == null ? 0u : (uint)shape.Indices.Length / 3u;
                desc.Heights = heights;
                status = Native.lr_collider_create(simulation.Handle, &desc, 1, &created);
            }
            // The library has its own copy.
            shape.Vertices = null;
            shape.Indices = null;
            shape.Heights = null;
            if (status != Status.Ok)
                throw new LangevinException(status, "lr_collider_create", source.GetType().Name + " of \"" + name + "\"" +
                    (shape.Kind == ColliderKind.Hull ? ": if its mesh is flat, turn off Convex." : ": check its size."));
            id = created;
            simulation.GoneColliders.Remove(created); // handles are given again after a restored snapshot
        }

        private void ReadSurface()
        {
            layers = 1u << gameObject.layer;
            frictionSet = friction;
            restitutionSet = restitution;
            var material = source.sharedMaterial;
            if (!usePhysicsMaterial || material == null) return;
            frictionSet = Mathf.Clamp(material.dynamicFriction, 0.0f, 10.0f);
            restitutionSet = Mathf.Clamp01(material.bounciness);
        }

        internal override void BeforeStep(LangevinSimulation simulation, float dt)
        {
            if (neverMoves && !id.IsNull) return;
            if (source == null || !source.enabled)
            {
                OnLeave(simulation);
                return;
            }
            int key = LangevinColliderShapes.KeyOf(source);
            if (id.IsNull || key != shape.Key)
            {
                // Retry a refused shape only after a change, not in every step.
                if (refused && key == refusedKey) return;
                OnLeave(simulation);
                refused = true;
                refusedKey = key;
                Create(simulation);
                refused = false;
                return;
            }
            SynchronizeSurface(simulation);
            SynchronizeMotion(simulation);
        }

        private void SynchronizeSurface(LangevinSimulation simulation)
        {
            uint layersBefore = layers;
            float frictionBefore = frictionSet, restitutionBefore = restitutionSet;
            ReadSurface();
            if (layers == layersBefore && frictionSet == frictionBefore && restitutionSet == restitutionBefore) return;
            ColliderMaterial surface = ColliderMaterial.Create();
            surface.Layers = layers;
            surface.Friction = frictionSet;
            surface.Restitution = restitutionSet;
            ColliderId self = id;
            LangevinSimulation.Check(Native.lr_collider_set_material(simulation.Handle, &self, 1, &surface), "lr_collider_set_material");
        }

        // The collider follows the transform's last motion during the next step: this gives it a velocity.
        private void SynchronizeMotion(LangevinSimulation simulation)
        {
            Vector3 to = shape.PositionOf(transform);
            Quaternion turned = shape.RotationOf(transform);
            if (to.Equals(position) && turned.Equals(rotation)) return;
            ColliderMotion motion = ColliderMotion.Create();
            motion.Collider = id;
            motion.Mode = (to - position).magnitude > teleportDistance ? MoveMode.Place : MoveMode.To;
            motion.Position = LangevinConversion.ToLibrary(to);
            motion.Orientation = LangevinConversion.ToLibrary(turned);
            LangevinSimulation.Check(Native.lr_collider_move(simulation.Handle, &motion, 1), "lr_collider_move");
            position = to;
            rotation = turned;
        }

#if UNITY_EDITOR
        private void OnDrawGizmosSelected()
        {
            var seen = source != null ? source : GetComponent<Collider>();
            if (seen == null) return;
            Gizmos.color = new Color(0.9f, 0.7f, 0.2f, 0.6f);
            Gizmos.DrawWireCube(seen.bounds.center, seen.bounds.size);
        }
#endif
    }
}
