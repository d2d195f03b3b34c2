// SPDX-License-Identifier: MIT
using UnityEditor;

namespace LangevinUnity.Editor
{
    /// <summary>Shows the properties of an asset.</summary>
    [CustomEditor(typeof(LangevinAsset))]
    public sealed class LangevinAssetEditor : UnityEditor.Editor
    {
        /// <inheritdoc/>
        public override void OnInspectorGUI()
        {
            var asset = (LangevinAsset)target;
            LangevinAssetNumbers n = asset.Numbers;
            EditorGUILayout.LabelField("Baked as", n.bakedName);
            EditorGUILayout.LabelField("Mass", LangevinUnits.Mass(n.mass));
            EditorGUILayout.LabelField("Volume", (n.volume * 1e6).ToString("G4") + " cm³");
            EditorGUILayout.LabelField("Density", n.density.ToString("G4") + " kg/m³");
            EditorGUILayout.LabelField("Length, thickness", LangevinUnits.Length(n.length) + ", " + LangevinUnits.Length(n.thickness));
            EditorGUILayout.LabelField("Fall speed, about", n.fallSpeed.ToString("G3") + " m/s, Reynolds number " + n.reynolds.ToString("G3"));
            EditorGUILayout.LabelField("Density of the bake's fluid", n.fluidDensity.ToString("G4") + " kg/m³");
            EditorGUILayout.LabelField("Added mass along x, y, z", LangevinUnits.Mass(n.addedMass.x) + ", " + LangevinUnits.Mass(n.addedMass.y) +
                ", " + LangevinUnits.Mass(n.addedMass.z));
            EditorGUILayout.LabelField("Centre of mass", n.centerOfMass.ToString("G4") + " m, baked mesh");
            EditorGUILayout.LabelField("Drawn mesh mirrored along", asset.Mirror.ToString());
            EditorGUILayout.LabelField("File", asset.Bytes.Length + " bytes, format " + n.formatVersion + ", " + n.contentHash);
        }
    }

    /// <summary>Formats numbers with units.</summary>
    internal static class LangevinUnits
    {
        public static string Mass(double kg)
        {
            return kg >= 1.0 ? kg.ToString("G4") + " kg" : kg >= 1e-3 ? (kg * 1e3).ToString("G4") + " g" : (kg * 1e6).ToString("G4") + " mg";
        }

        public static string Length(double m)
        {
            return m >= 1.0 ? m.ToString("G4") + " m" : m >= 1e-2 ? (m * 1e2).ToString("G4") + " cm" : (m * 1e3).ToString("G4") + " mm";
        }
    }
}
