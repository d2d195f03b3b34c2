// SPDX-License-Identifier: MIT
using System.Collections.Generic;
using UnityEngine;

namespace LangevinUnity
{
    /// <summary>What belongs to a world: batches, wind, colliders. A member joins its world when both are enabled, in whichever order Unity
    /// enables them, and leaves when either goes.</summary>
    public abstract class LangevinMember : MonoBehaviour
    {
        private static readonly List<LangevinMember> Enabled = new List<LangevinMember>();

        [Tooltip("The world that this belongs to. Empty: the one in a parent, else the first that was enabled.")]
        [SerializeField] private LangevinWorld world = null;

        private LangevinWorld joined;

        /// <summary>The world that this has joined; null while there is none.</summary>
        public LangevinWorld World { get { return joined; } }

        /// <summary>The world to join. Set it while the component is disabled, or before its world is enabled.</summary>
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
            return parent != null ? parent : LangevinWorld.First;
        }

        /// <summary>Has all members that wait for a world join it.</summary>
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

        /// <summary>Called when there is a world to put things into.</summary>
        internal abstract void OnJoin(LangevinSimulation simulation);

        /// <summary>Called before the world goes, or the member leaves it.</summary>
        internal abstract void OnLeave(LangevinSimulation simulation);

        /// <summary>Called before each step of `dt` seconds.</summary>
        internal virtual void BeforeStep(LangevinSimulation simulation, float dt) { }

        /// <summary>Called once a frame in which the world was stepped, and no step runs.</summary>
        internal virtual void AfterStep(LangevinSimulation simulation) { }

        /// <summary>Called each frame, after AfterStep.</summary>
        internal virtual void Draw() { }
    }
}
