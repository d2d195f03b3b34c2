// SPDX-License-Identifier: MIT
using UnityEditor;

namespace LangevinUnity.Editor
{
    /// <summary>Ends simulations before scripts are reloaded and when play mode ends. Unity disables components first; what is left then was
    /// made by hand, and its native memory and threads would stay in the editor's process for ever.</summary>
    [InitializeOnLoad]
    internal static class ReloadGuard
    {
        static ReloadGuard()
        {
            AssemblyReloadEvents.beforeAssemblyReload += LangevinSimulation.DisposeAll;
            EditorApplication.playModeStateChanged += OnPlayMode;
            EditorApplication.quitting += LangevinSimulation.DisposeAll;
        }

        private static void OnPlayMode(PlayModeStateChange change)
        {
            if (change == PlayModeStateChange.EnteredEditMode) LangevinSimulation.DisposeAll();
        }
    }
}
