// SPDX-License-Identifier: MIT
using System.Collections.Generic;
using UnityEngine;

namespace LangevinUnity
{
    /// <summary>A part of a world: a batch, wind or collider. A member joins its world when both are enabled, in any order, and leaves when
    /// either is disabled.</summary>
    public abstract class LangevinMember : MonoBehaviour
    {
        private static readonly List<LangevinMember> Enabled = new List<LangevinMember>();

        [Tooltip("The world to join. Empty: the world in a parent, else the first enabled world of its scene, else of all.")]
        [SerializeField] private LangevinWorld world = null;

        private LangevinWorld joined;

        /// <summary>The joined world, or null.</summary>
        public LangevinWorld World { get { return joined; } }

        /// <summary>The world to join. Set it while the component or its world is disabled.</summary>
        public LangevinWorld PreferredWorld { get { return world; } set { world = value; } }

        internal LangevinSimulation Simulation { get { return joined == null ? null : joined.Simulation; } }

        protected virtual void OnEnable()
        {
            Enabled.Add(this);
            LangevinWorld wanted = Wanted();
            if (wanted != null && wanted.Simulation != null) Join(wanted);
        }

        protected virtual void OnDisable()
        {
            Enabled.Remove(this);
            Leave();
        }

        private LangevinWorld Wanted()
        {
            if (world != null) return world;
            var parent = GetComponentInParent<LangevinWorld>();
            return parent != null ? parent : LangevinWorld.FirstFor(gameObject.scene);
        }

        /// <summary>Makes all waiting members join a world.</summary>
        internal static void JoinAll(LangevinWorld to)
        {
            foreach (LangevinMember member in Enabled.ToArray())
                if (member.joined == null && member.Wanted() == to) member.Join(to);
        }

        internal static void ForgetAll() { Enabled.Clear(); }

        private void Join(LangevinWorld to)
        {
            to.CompleteStep();
            joined = to;
            to.Members.Add(this);
            try
            {
                OnJoin(to.Simulation);
            }
            catch (System.Exception e)
            {
                Leave();
                Debug.LogException(e, this);
            }
        }

        internal void Leave()
        {
            if (joined == null) return;
            LangevinWorld from = joined;
            from.CompleteStep();
            try
            {
                if (from.Simulation != null) OnLeave(from.Simulation);
            }
            finally
            {
                from.Members.Remove(this);
                joined = null;
            }
        }

        /// <summary>Creates the member's objects in the world.</summary>
        internal abstract void OnJoin(LangevinSimulation simulation);

        /// <summary>Called before the world is disabled, or the member leaves it.</summary>
        internal abstract void OnLeave(LangevinSimulation simulation);

        /// <summary>Called before each step of `dt` seconds.</summary>
        internal virtual void BeforeStep(LangevinSimulation simulation, float dt) { }

        /// <summary>Called after a snapshot was restored: the member's objects have its state, or are from after it and gone.</summary>
        internal virtual void OnRestored(LangevinSimulation simulation) { }

        /// <summary>Called once in each frame with a step, after the step.</summary>
        internal virtual void AfterStep(LangevinSimulation simulation) { }

        /// <summary>Called each frame, after AfterStep.</summary>
        internal virtual void Draw() { }
    }
}
