// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using LangevinRigid;
using Unity.Collections;
using Unity.Jobs;
using UnityEngine;
using UnityEngine.SceneManagement;

namespace LangevinUnity
{
    /// <summary>Triggers of a world's steps.</summary>
    public enum LangevinStepMode
    {
        /// <summary>Once per frame, by its duration, at most `maximumStep`. Smooth at any frame rate.</summary>
        Frame = 0,
        /// <summary>In FixedUpdate, by the fixed time step: the same motion in every run.</summary>
        Fixed = 1,
        /// <summary>By calls of Step from your scripts.</summary>
        Manual = 2,
    }

    /// <summary>Threads for a step.</summary>
    public enum LangevinStepThread
    {
        /// <summary>In Update; the main thread waits.</summary>
        Main = 0,
        /// <summary>In a job from Update to LateUpdate, in parallel with other scripts and the physics engine.</summary>
        Job = 1,
    }

    /// <summary>A world of falling bodies. It steps, and updates the batches, winds and colliders that have joined it.</summary>
    [AddComponentMenu("Langevin Rigid/Langevin World")]
    [DefaultExecutionOrder(-50)]
    [DisallowMultipleComponent]
    public sealed unsafe partial class LangevinWorld : MonoBehaviour
    {
        private static readonly List<LangevinWorld> Enabled = new List<LangevinWorld>();

        [Header("Time")]
        [SerializeField] private LangevinStepMode stepMode = LangevinStepMode.Frame;
        [SerializeField] private LangevinStepThread stepThread = LangevinStepThread.Main;
        [Tooltip("At 60 Hz, 2 for leaves and paper of a few centimetres, 4 for petals and confetti.")]
        [SerializeField, Range(1, 32)] private int substeps = 2;
        [Tooltip("Seconds. Limits the step of a long frame, so that a hitch does not cause the next one.")]
        [SerializeField, Range(0.001f, 1.0f)] private float maximumStep = 1.0f / 20.0f;

        [Header("World")]
        [Tooltip("Seed of all random numbers.")]
        [SerializeField] private long seed = 1;
        [Tooltip("Uses Physics.gravity.")]
        [SerializeField] private bool useSceneGravity = true;
        [SerializeField] private Vector3 gravity = new Vector3(0.0f, -9.81f, 0.0f);
        [Tooltip("Fluid density, kg/m^3. 0: each batch uses its asset's fluid.")]
        [SerializeField, Min(0.0f)] private float fluidDensity = 0.0f;
        [Tooltip("Kinematic viscosity, m^2/s. 0: each batch uses its asset's fluid.")]
        [SerializeField, Min(0.0f)] private float fluidViscosity = 0.0f;

        [Header("Work")]
        [Tooltip("Threads of the library besides the caller's. -1: half of the processor's. Results do not depend on it. 0 on WebGL.")]
        [SerializeField, Range(-1, 64)] private int workers = -1;
        [Tooltip("Largest number of body substeps in a step. 0: no limit.")]
        [SerializeField, Min(0)] private long budget = 0;

        private LangevinSimulation simulation;
        private NativeArray<int> jobStatus;
        private bool running;
        private bool stepped;
        private Vector3 gravitySet;

        internal readonly List<LangevinMember> Members = new List<LangevinMember>();

        /// <summary>The first enabled world.</summary>
        public static LangevinWorld First { get { return Enabled.Count > 0 ? Enabled[0] : null; } }

        // One of the scene first: a scene loaded beside another must not lose its members with the other.
        internal static LangevinWorld FirstFor(Scene scene)
        {
            foreach (LangevinWorld world in Enabled)
                if (world.gameObject.scene == scene) return world;
            return First;
        }

        /// <summary>The simulation; null while the component is disabled, and after LangevinSimulation.DisposeAll.</summary>
        public LangevinSimulation Simulation { get { return simulation == null || simulation.IsDisposed ? null : simulation; } }

        /// <summary>The trigger of steps.</summary>
        public LangevinStepMode StepMode { get { return stepMode; } set { stepMode = value; } }

        /// <summary>The thread of steps.</summary>
        public LangevinStepThread StepThread { get { return stepThread; } set { CompleteStep(); stepThread = value; } }

        /// <summary>Substeps per step, 1 to 65536.</summary>
        public int Substeps { get { return substeps; } set { substeps = Mathf.Clamp(value, 1, (int)Limits.MaxSubsteps); } }

        /// <summary>Seed of all random numbers; takes effect when the component is enabled again.</summary>
        public long Seed { get { return seed; } set { seed = value; } }

        /// <summary>Threads besides the caller's; takes effect when the component is enabled again.</summary>
        public int Workers { get { return workers; } set { workers = value; } }

        /// <summary>Gravity, m/s^2. Setting it ends the use of Physics.gravity.</summary>
        public Vector3 Gravity
        {
            get { return useSceneGravity ? Physics.gravity : gravity; }
            set { gravity = value; useSceneGravity = false; }
        }

        private void OnEnable()
        {
            try
            {
                simulation = new LangevinSimulation((ulong)seed, WorkerCount(), Gravity, fluidDensity, fluidViscosity);
                gravitySet = Gravity;
                ApplyBudget();
                ApplyEvents();
            }
            catch (Exception e)
            {
                if (simulation != null) simulation.Dispose();
                simulation = null;
                Debug.LogException(e, this);
                enabled = false;
                return;
            }
            Enabled.Add(this);
            LangevinMember.JoinAll(this);
        }

        // Members leave while the library's world still exists, whatever the order in which Unity disables components. A batch disabled later
        // has no world, and frees only its own memory.
        private void OnDisable()
        {
            Enabled.Remove(this);
            try { CompleteStep(); }
            catch (Exception e) { Debug.LogException(e, this); }
            foreach (LangevinMember member in Members.ToArray())
            {
                try { member.Leave(); }
                catch (Exception e) { Debug.LogException(e, member); }
            }
            if (simulation != null) simulation.Dispose();
            simulation = null;
            if (jobStatus.IsCreated) jobStatus.Dispose();
            ForgetEvents();
        }

        private int WorkerCount()
        {
#if UNITY_WEBGL && !UNITY_EDITOR
            return 0;
#else
            return workers >= 0 ? workers : Mathf.Max(0, SystemInfo.processorCount / 2 - 1);
#endif
        }

        private void Update()
        {
            if (stepMode == LangevinStepMode.Frame) Begin(Mathf.Min(Time.deltaTime, maximumStep));
        }

        private void FixedUpdate()
        {
            if (stepMode == LangevinStepMode.Fixed) Begin(Time.fixedDeltaTime);
        }

        private void LateUpdate()
        {
            Present();
        }

        /// <summary>Steps the world now and waits, in mode Manual. `dt`: s, above 0 and at most `substeps` seconds.</summary>
        public void Step(float dt)
        {
            Begin(dt);
            CompleteStep();
        }

        /// <summary>Waits for a step that runs as a job. All methods of this package call it; call it before your own calls of
        /// LangevinRigid.Native.</summary>
        public void CompleteStep()
        {
            if (!running) return;
            running = false;
            simulation.Stepping.Complete();
            EndStep((Status)jobStatus[0]);
        }

        private void EndStep(Status status)
        {
            // With too little memory for all contacts, the step is still taken.
            if (status == Status.Ok || status == Status.OutOfMemory)
            {
                stepped = true;
                DispatchEvents();
            }
            LangevinSimulation.Check(status, "lr_world_step");
        }

        /// <summary>Updates batches and draws them, as LateUpdate does. For mode Manual in the editor, or before your own camera
        /// renders.</summary>
        public void Present()
        {
            CompleteStep();
            if (Simulation == null) return;
            if (stepped)
                foreach (LangevinMember member in Members) member.AfterStep(simulation);
            stepped = false;
            foreach (LangevinMember member in Members) member.Draw();
        }

        private void Begin(float dt)
        {
            CompleteStep();
            if (Simulation == null || !(dt > 0.0f)) return;
            Vector3 now = Gravity;
            if (now != gravitySet)
            {
                Float3 g = LangevinConversion.ToLibrary(now);
                LangevinSimulation.Check(Native.lr_world_set_gravity(simulation.Handle, &g.X), "lr_world_set_gravity");
                gravitySet = now;
            }
            LangevinWind.Apply(this);
            for (int i = 0; i < Members.Count; ++i)
            {
                // A member with a wrong value must not stop the others.
                try { Members[i].BeforeStep(simulation, dt); }
                catch (Exception e) { Debug.LogException(e, Members[i]); }
            }
            if (stepThread == LangevinStepThread.Main)
            {
                EndStep(Native.lr_world_step(simulation.Handle, dt, (uint)substeps));
                return;
            }
            if (!jobStatus.IsCreated) jobStatus = new NativeArray<int>(1, Unity.Collections.Allocator.Persistent);
            var job = new LangevinStepJob { World = simulation.Handle, Dt = dt, Substeps = (uint)substeps, Status = jobStatus };
            simulation.Stepping = job.Schedule();
            running = true;
            JobHandle.ScheduleBatchedJobs();
        }

        /// <summary>Writes all calls on this world to a file for lr_replay, until StopRecording or until the component is disabled. Send the file
        /// with a bug report. Works at any time, also in a released game: paths below Application.persistentDataPath are always
        /// writable.</summary>
        public void StartRecording(string path)
        {
            CompleteStep();
            if (Simulation == null) throw new InvalidOperationException("The world is disabled.");
            simulation.StartRecording(path);
        }

        /// <summary>Ends the recording, if any. Throws an IOException if the file is incomplete.</summary>
        public void StopRecording()
        {
            CompleteStep();
            if (Simulation != null) simulation.StopRecording();
        }

        /// <summary>Limits the work of each step, in body substeps; 0: no limit.</summary>
        public void SetBudget(long bodySubsteps)
        {
            budget = bodySubsteps;
            if (Simulation == null) return;
            CompleteStep();
            ApplyBudget();
        }

        private void ApplyBudget()
        {
            LangevinSimulation.Check(Native.lr_world_set_budget(simulation.Handle, (ulong)Math.Max(0L, budget)), "lr_world_set_budget");
        }

#if UNITY_EDITOR
        private void OnValidate()
        {
            if (Simulation != null) SetBudget(budget);
        }
#endif

        // With "Enter Play Mode Options", statics keep values of the last session.
        [RuntimeInitializeOnLoadMethod(RuntimeInitializeLoadType.SubsystemRegistration)]
        private static void ResetStatics()
        {
            LangevinSimulation.DisposeAll();
            Enabled.Clear();
            LangevinMember.ForgetAll();
        }
    }
}
