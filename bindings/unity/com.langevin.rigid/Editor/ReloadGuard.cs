// SPDX-License-Identifier: MIT
using UnityEditor;

namespace LangevinUnity.Editor
{
    /// <summary>Disposes of simulations before scripts are reloaded and when play mode ends. Unity disables components first. Simulations left
    /// after that were made by scripts; their native memory and threads would leak in the editor's process.</summary>
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
