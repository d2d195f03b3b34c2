// SPDX-License-Identifier: MIT
using UnityEditor;
using UnityEngine;

namespace LangevinUnity.Editor
{
    /// <summary>GameObject > Langevin Rigid: creates the parts of a scene.</summary>
    internal static class CreateMenu
    {
        [MenuItem("GameObject/Langevin Rigid/World", false, 10)]
        private static void World(MenuCommand command) { Make(command, "Langevin World", typeof(LangevinWorld)); }

        [MenuItem("GameObject/Langevin Rigid/Batch", false, 11)]
        private static void Batch(MenuCommand command)
        {
            GameObject made = Make(command, "Langevin Batch", typeof(LangevinBatch));
            made.transform.position = new Vector3(0.0f, 10.0f, 0.0f);
        }

        [MenuItem("GameObject/Langevin Rigid/Wind", false, 12)]
        private static void Wind(MenuCommand command) { Make(command, "Langevin Wind", typeof(WindZone), typeof(LangevinWind)); }

        [MenuItem("GameObject/Langevin Rigid/Add Collider to Selection", false, 13)]
        private static void Colliders()
        {
            foreach (GameObject selected in Selection.gameObjects)
                foreach (Collider collider in selected.GetComponentsInChildren<Collider>())
                    if (collider.GetComponent<LangevinCollider>() == null) Undo.AddComponent<LangevinCollider>(collider.gameObject);
        }

        private static GameObject Make(MenuCommand command, string name, params System.Type[] components)
        {
            var made = new GameObject(name, components);
            GameObjectUtility.SetParentAndAlign(made, command.context as GameObject);
            Undo.RegisterCreatedObjectUndo(made, "Create " + name);
            Selection.activeObject = made;
            return made;
        }
    }
}
