// SPDX-License-Identifier: MIT
using System;
using LangevinRigid;
using UnityEngine;

namespace LangevinUnity
{
    /// <summary>Simulates all bodies of an asset: emitter, rules, contact and drawing.</summary>
    [AddComponentMenu("Langevin Rigid/Langevin Batch")]
    public sealed unsafe partial class LangevinBatch : LangevinMember
    {
        [Header("Bodies")]
        [SerializeField] private LangevinAsset asset = null;
        [Tooltip("Largest number of bodies. Their memory is allocated at once.")]
        [SerializeField, Min(1)] private int capacity = 1000;
        [Tooltip("Bodies that the emitter spawns when the batch joins its world.")]
        [SerializeField, Min(0)] private int startCount = 0;
        [SerializeField] private LoadModel loadModel = LoadModel.Default;
        [SerializeField] private LangevinEmitter emitter = new LangevinEmitter();
        [SerializeField] private LangevinRules rules = new LangevinRules();

        [Header("Drawing")]
        [SerializeField] private LangevinDrawSettings drawing = new LangevinDrawSettings();

        [Header("Contact")]
        [Tooltip("Layers of colliders that bodies touch.")]
        [SerializeField] private LayerMask collidesWith = ~0;
        [SerializeField, Range(0.0f, 10.0f)] private float friction = 0.5f;
        [SerializeField, Range(0.0f, 1.0f)] private float restitution = 0.1f;
        [SerializeField, Range(0.0f, 10.0f)] private float rollingResistance = 0.05f;
        [Tooltip("Strength of the air cushion between a sheet and the ground. 1: physical.")]
        [SerializeField, Range(0.0f, 1.0f)] private float groundEffect = 0.0f;
        [Tooltip("Contact between bodies of this batch, so that they pile up.")]
        [SerializeField] private bool bodyContact = false;

        [Header("Art")]
        [SerializeField, Range(0.0f, 5.0f)] private float drag = 1.0f;
        [SerializeField, Range(0.0f, 5.0f)] private float lift = 1.0f;
        [SerializeField, Range(0.0f, 5.0f)] private float spinDrag = 1.0f;
        [SerializeField, Range(0.0f, 5.0f)] private float turbulence = 1.0f;
        [Tooltip("Natural spread of drag and lift from body to body. 0: all bodies are alike.")]
        [SerializeField, Range(0.0f, 0.5f)] private float variation = 0.15f;

        [Header("Level of detail")]
        [Tooltip("Level of detail: one substep for this number of substeps of the world.")]
        [SerializeField, Range(1, 64)] private int divisor = 1;

        [Header("Events")]
        [SerializeField] private LangevinUnityEvent onEvent = new LangevinUnityEvent();

        private BatchId id;
        private LangevinInstances instances;
        private LangevinGroupDrawing group;
        private Float3 center;
        private MeshMirror mirror;
        private string warned;
        private bool outdated;
        private Vector3 position;
        private Quaternion rotation;
        private Vector3 scale;

        /// <summary>The library's handle; null outside a world.</summary>
        public BatchId Id { get { return id; } }

        /// <summary>The asset of all bodies. Set it while the component is disabled.</summary>
        public LangevinAsset Asset { get { return asset; } set { asset = value; } }

        /// <summary>Largest number of bodies. Set it while the component is disabled.</summary>
        public int Capacity { get { return capacity; } set { capacity = Mathf.Max(1, value); } }

        /// <summary>Number of bodies spawned on joining the world.</summary>
        public int StartCount { get { return startCount; } set { startCount = value; } }

        /// <summary>The emitter. Call Apply after a change.</summary>
        public LangevinEmitter Emitter { get { return emitter; } }

        /// <summary>Rules for the end of bodies. Call Apply after a change.</summary>
        public LangevinRules Rules { get { return rules; } }

        /// <summary>Mesh, materials and mode. A change of mode or mesh takes effect when the component is enabled again.</summary>
        public LangevinDrawSettings Drawing { get { return drawing; } }

        /// <summary>Matrices of all bodies, as of the last frame; null while the batch is in no world.</summary>
        public LangevinInstances Instances { get { return instances; } }

        /// <summary>Spread of drag and lift from body to body, 0 to 0.5. Set it while the component is disabled.</summary>
        public float Variation { get { return variation; } set { variation = Mathf.Clamp(value, 0.0f, 0.5f); } }

        /// <summary>Contact between bodies of this batch. Call Apply after a change.</summary>
        public bool BodyContact { get { return bodyContact; } set { bodyContact = value; } }

        /// <summary>Level of detail. Call Apply after a change.</summary>
        public int Divisor { get { return divisor; } set { divisor = Mathf.Clamp(value, 1, 1024); } }

        /// <summary>Raised for this batch's events, after the world's Happened.</summary>
        public event Action<LangevinEvent> Happened;

        /// <summary>The same event, for handlers set in the inspector.</summary>
        public LangevinUnityEvent OnEvent { get { return onEvent; } }

        internal void Raise(LangevinEvent e)
        {
            if (Happened != null) Happened(e);
            onEvent.Invoke(e);
        }

        internal override void OnJoin(LangevinSimulation simulation)
        {
            if (asset == null)
                throw new InvalidOperationException("LangevinBatch \"" + name + "\" has no asset. Drag an imported .lrb onto its Asset field.");
            BatchDesc desc = BatchDesc.Create();
            desc.Asset = simulation.AssetOf(asset);
            desc.Capacity = (uint)capacity;
            desc.LoadModel = loadModel;
            desc.Variation = variation;
            BatchId created;
            LangevinSimulation.Check(Native.lr_batch_create(simulation.Handle, &desc, &created), "lr_batch_create");
            id = created;
            AssetInfo info = AssetInfo.Create();
            LangevinSimulation.Check(Native.lr_asset_get_info(desc.Asset, &info), "lr_asset_get_info");
            center = new Float3((float)info.CenterOfMass.X, (float)info.CenterOfMass.Y, (float)info.CenterOfMass.Z);
            mirror = asset.Mirror;
            ApplyTo(simulation);
            if (startCount > 0 && emitter.enabled) Emit(Mathf.Min(startCount, capacity));
            bool wantsGroup = drawing.mode == LangevinDrawMode.BatchRendererGroup && drawing.Problem() == null;
            bool packed = wantsGroup && LangevinGroupDrawing.Supported;
            if (wantsGroup && !packed)
                Debug.LogWarning("This graphics API has no raw buffers for BatchRendererGroup: \"" + name +
                    "\" is drawn by RenderMeshInstanced.", this);
            instances = new LangevinInstances(capacity, packed);
            if (packed) group = new LangevinGroupDrawing(drawing, instances, capacity, gameObject.layer);
            AfterStep(simulation);
        }

        internal override void OnLeave(LangevinSimulation simulation)
        {
            try
            {
                if (!id.IsNull) LangevinSimulation.Check(Native.lr_batch_destroy(simulation.Handle, id), "lr_batch_destroy");
            }
            finally
            {
                id = default(BatchId);
                FreeBuffers();
            }
        }

        // Also if the world left first, and OnLeave did not run.
        protected override void OnDisable()
        {
            base.OnDisable();
            FreeBuffers();
        }

        private void FreeBuffers()
        {
            if (group != null) group.Dispose();
            group = null;
            if (instances != null) instances.Dispose();
            instances = null;
        }

        /// <summary>Passes the values of all fields to the library; they take effect in the next step.</summary>
        public void Apply()
        {
            LangevinSimulation simulation = Simulation;
            if (simulation == null || id.IsNull) return;
            World.CompleteStep();
            ApplyTo(simulation);
        }

        private void ApplyTo(LangevinSimulation simulation)
        {
            IntPtr world = simulation.Handle;
            BatchContact contact = BatchContact.Create();
            contact.Layers = (uint)collidesWith.value;
            contact.Friction = friction;
            contact.Restitution = restitution;
            contact.RollingResistance = rollingResistance;
            contact.GroundEffect = groundEffect;
            LangevinSimulation.Check(Native.lr_batch_set_contact(world, id, &contact), "lr_batch_set_contact");
            LangevinSimulation.Check(Native.lr_batch_set_body_contact(world, id, id, bodyContact ? 1 : 0), "lr_batch_set_body_contact");
            LoadGains gains = LoadGains.Create();
            gains.Drag = drag;
            gains.Lift = lift;
            gains.SpinDrag = spinDrag;
            gains.Turbulence = turbulence;
            LangevinSimulation.Check(Native.lr_batch_set_load_gains(world, id, &gains), "lr_batch_set_load_gains");
            LangevinSimulation.Check(Native.lr_batch_set_rate(world, id, (uint)divisor), "lr_batch_set_rate");
            ApplyLife(world);
        }

        // Rules that respawn need an emitter: remove them before it, set them after it.
        private void ApplyLife(IntPtr world)
        {
            if (!rules.enabled) LangevinSimulation.Check(Native.lr_batch_set_rules(world, id, null), "lr_batch_set_rules");
            if (emitter.enabled) PlaceEmitter(world);
            if (rules.enabled)
            {
                if (!emitter.enabled && rules.action == EndAction.Respawn)
                    throw new InvalidOperationException("LangevinBatch \"" + name + "\": rules that respawn need an emitter.");
                BatchRules desc = rules.ToLibrary();
                LangevinSimulation.Check(Native.lr_batch_set_rules(world, id, &desc), "lr_batch_set_rules");
            }
            if (!emitter.enabled) LangevinSimulation.Check(Native.lr_batch_set_emitter(world, id, null), "lr_batch_set_emitter");
        }

        internal override void BeforeStep(LangevinSimulation simulation, float dt)
        {
            if (id.IsNull) return;
            if (outdated)
            {
                outdated = false;
                ApplyTo(simulation);
            }
            else if (emitter.enabled && !IsPlaced()) PlaceEmitter(simulation.Handle);
        }

        // Not by Transform.hasChanged, whose one flag would be the game's and that of other batches on the object too.
        private bool IsPlaced()
        {
            return transform.position.Equals(position) && transform.rotation.Equals(rotation) && transform.lossyScale.Equals(scale);
        }

        private void PlaceEmitter(IntPtr world)
        {
            position = transform.position;
            rotation = transform.rotation;
            scale = transform.lossyScale;
            EmitterDesc desc = emitter.ToLibrary(transform, mirror);
            LangevinSimulation.Check(Native.lr_batch_set_emitter(world, id, &desc), "lr_batch_set_emitter");
        }

        internal override void AfterStep(LangevinSimulation simulation)
        {
            if (instances == null) return;
            instances.Refresh(simulation.Handle, id, center, mirror);
            if (group != null) group.Upload();
        }

        internal override void Draw()
        {
            if (instances == null || group != null || drawing.mode == LangevinDrawMode.None || instances.Count == 0) return;
            string problem = drawing.Problem();
            if (problem == null)
            {
                LangevinInstancedDrawing.Draw(drawing, instances, gameObject.layer);
            }
            else if (problem != warned)
            {
                // Warn once, not each frame.
                warned = problem;
                Debug.LogWarning("LangevinBatch \"" + name + "\" is not drawn. " + problem, this);
            }
        }

#if UNITY_EDITOR
        private void OnValidate() { outdated = true; }

        private void OnDrawGizmosSelected()
        {
            Gizmos.color = new Color(0.4f, 0.8f, 0.3f, 0.8f);
            Gizmos.matrix = Matrix4x4.TRS(transform.position, transform.rotation, transform.lossyScale);
            bool round = emitter.shape == EmitterShape.Sphere || emitter.shape == EmitterShape.SphereSurface;
            if (emitter.enabled && round) Gizmos.DrawWireSphere(Vector3.zero, emitter.size.x);
            else if (emitter.enabled && emitter.shape != EmitterShape.Point) Gizmos.DrawWireCube(Vector3.zero, emitter.size * 2.0f);
            Gizmos.matrix = Matrix4x4.identity;
            if (emitter.enabled) Gizmos.DrawRay(transform.position, transform.rotation * emitter.direction);
            Gizmos.color = new Color(0.9f, 0.3f, 0.2f, 0.8f);
            if (rules.enabled)
                foreach (LangevinKillVolume volume in rules.volumes)
                {
                    if (volume.shape == VolumeShape.Box) Gizmos.DrawWireCube(volume.center, volume.size * 2.0f);
                    if (volume.shape == VolumeShape.Sphere) Gizmos.DrawWireSphere(volume.center, volume.size.x);
                    if (volume.shape == VolumeShape.Plane) Gizmos.DrawRay(volume.center, volume.size.normalized);
                }
        }
#endif
    }
}
