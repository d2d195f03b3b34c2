// SPDX-License-Identifier: MIT
using System;
using System.IO;
using UnityEditor;
using UnityEngine;

namespace LangevinUnity.Editor
{
    /// <summary>Window > Langevin Rigid > Bake: bakes a mesh to a .lrb file by lr_bake, in a process of its own.</summary>
    public sealed class BakeWindow : EditorWindow
    {
        [SerializeField] private Mesh mesh;
        [SerializeField] private string file = "";
        [SerializeField] private bool fromFile;
        [SerializeField] private LangevinBakeSettings settings = new LangevinBakeSettings();
        [SerializeField] private string output = "Assets/leaf.lrb";
        [SerializeField] private string message = "";
        [SerializeField] private bool failed;

        private LangevinBake bake;
        private double begun;
        private string temporary;
        private string target;
        private MeshMirror mirror;
        private Vector2 scroll;

        [MenuItem("Window/Langevin Rigid/Bake")]
        private static void Open() { GetWindow<BakeWindow>("Langevin Bake"); }

        private void OnEnable() { EditorApplication.update += Poll; }

        // Also before scripts are reloaded: otherwise the baker would go on without a window.
        private void OnDisable()
        {
            EditorApplication.update -= Poll;
            if (bake == null) return;
            bake.Dispose();
            bake = null;
            EditorUtility.ClearProgressBar();
            DeleteTemporary();
        }

        private void OnGUI()
        {
            using (new EditorGUI.DisabledScope(bake != null))
            {
                fromFile = EditorGUILayout.Toggle(
                    new GUIContent("From a file", "Bake an OBJ, FBX, glTF, PLY or STL file instead of a Unity mesh."), fromFile);
                if (fromFile) FileField();
                else mesh = (Mesh)EditorGUILayout.ObjectField("Mesh", mesh, typeof(Mesh), false);
                settings.sheet = EditorGUILayout.Toggle(
                    new GUIContent("Sheet", "The mesh is the middle surface of a thin sheet, open or closed."), settings.sheet);
                if (settings.sheet)
                {
                    settings.thickness = EditorGUILayout.DoubleField(
                        new GUIContent("Thickness", "Thickness of the sheet, in the mesh's unit."), settings.thickness);
                    settings.arealDensity = EditorGUILayout.DoubleField(
                        new GUIContent("Mass per area (kg/m²)", "Of a sheet; 0: use density. Paper: 0.08."), settings.arealDensity);
                }
                if (!(settings.sheet && settings.arealDensity > 0.0))
                    settings.density = EditorGUILayout.DoubleField(
                        new GUIContent("Density (kg/m³)", "Dry leaves: 350. Paper: 800."), settings.density);
                settings.fluid = EditorGUILayout.TextField(
                    new GUIContent("Fluid", "air, water, or density (kg/m³) and kinematic viscosity (m²/s): 1.2,1.5e-5"), settings.fluid);
                settings.unit = EditorGUILayout.TextField(
                    new GUIContent("Unit", "Unit of the mesh: m, cm or mm; file: the unit stored in an FBX or Collada file."), settings.unit);
                settings.wake = EditorGUILayout.Toggle(new GUIContent("Turbulence of the wake", "Also computes wake turbulence. Takes seconds longer."), settings.wake);
                output = EditorGUILayout.TextField("Output", output);
                string problem = Problem();
                if (problem != null) EditorGUILayout.HelpBox(problem, MessageType.Info);
                using (new EditorGUI.DisabledScope(problem != null))
                    if (GUILayout.Button("Bake")) Begin();
            }
            ToolField();
            if (message.Length == 0) return;
            EditorGUILayout.HelpBox(failed ? "The bake failed." : "Baked.", failed ? MessageType.Error : MessageType.None);
            scroll = EditorGUILayout.BeginScrollView(scroll);
            EditorGUILayout.SelectableLabel(message, EditorStyles.textArea, GUILayout.ExpandHeight(true));
            EditorGUILayout.EndScrollView();
        }

        private void FileField()
        {
            EditorGUILayout.BeginHorizontal();
            file = EditorGUILayout.TextField("File", file);
            if (GUILayout.Button("...", GUILayout.Width(30.0f)))
            {
                string chosen = EditorUtility.OpenFilePanel("Mesh", "", "");
                if (!string.IsNullOrEmpty(chosen)) file = chosen;
            }
            EditorGUILayout.EndHorizontal();
        }

        private void ToolField()
        {
            string found = LangevinBakerTool.Find();
            EditorGUILayout.LabelField("Baker", found ?? "not found");
            if (!GUILayout.Button("Choose the baker...")) return;
            string chosen = EditorUtility.OpenFilePanel("lr_bake", "", "");
            if (!string.IsNullOrEmpty(chosen)) EditorPrefs.SetString(LangevinBakerTool.PreferenceKey, chosen);
        }

        private string Problem()
        {
            if (fromFile && !File.Exists(file)) return "Choose a mesh file.";
            if (!fromFile && mesh == null) return "Choose a mesh.";
            if (!output.StartsWith("Assets/", StringComparison.Ordinal) || !output.EndsWith(".lrb", StringComparison.Ordinal))
                return "The output path must begin with Assets/ and end with .lrb.";
            if (LangevinBakerTool.Find() == null) return "lr_bake was not found: in the package's Tools~ folder, or on PATH.";
            return settings.Problem();
        }

        private void Begin()
        {
            message = "";
            failed = false;
            target = output;
            try
            {
                string input = file;
                if (!fromFile)
                {
                    temporary = FileUtil.GetUniqueTempPathInProject() + ".obj";
                    MeshWriter.WriteObj(mesh, temporary);
                    input = temporary;
                }
                mirror = fromFile ? MeshMirror.X : MeshMirror.Z;
                Directory.CreateDirectory(Path.GetDirectoryName(target));
                string name = fromFile ? Path.GetFileNameWithoutExtension(file) : mesh.name;
                bake = new LangevinBake(LangevinBakerTool.Find(), settings.Arguments(input, target, name));
                begun = EditorApplication.timeSinceStartup;
            }
            catch (Exception e)
            {
                failed = true;
                message = e.Message;
                DeleteTemporary();
            }
        }

        private void Poll()
        {
            if (bake == null) return;
            double seconds = EditorApplication.timeSinceStartup - begun;
            // The duration of a bake is unknown: the bar approaches its end, and its text names the phase.
            float progress = (float)(1.0 - Math.Exp(-seconds / 3.0));
            string text = bake.Phase + ", " + seconds.ToString("F0") + " s";
            if (EditorUtility.DisplayCancelableProgressBar("Langevin Rigid: baking", text, progress)) bake.Cancel();
            if (bake.Ended) End();
        }

        private void End()
        {
            EditorUtility.ClearProgressBar();
            bake.Wait();
            failed = bake.Cancelled || bake.ExitCode != 0;
            message = bake.Cancelled ? "Cancelled. A file from before is unchanged." : bake.Errors + (failed ? "" : bake.Report);
            bake.Dispose();
            bake = null;
            DeleteTemporary();
            if (!failed) Import();
            else Debug.LogError("Langevin Rigid: " + message);
            Repaint();
        }

        private void Import()
        {
            AssetDatabase.ImportAsset(target);
            var importer = AssetImporter.GetAtPath(target) as LrbImporter;
            if (importer == null) return;
            if (importer.Mirror != mirror)
            {
                importer.Mirror = mirror;
                EditorUtility.SetDirty(importer);
                importer.SaveAndReimport();
            }
            EditorGUIUtility.PingObject(AssetDatabase.LoadMainAssetAtPath(target));
        }

        private void DeleteTemporary()
        {
            if (temporary != null && File.Exists(temporary)) File.Delete(temporary);
            temporary = null;
        }
    }
}
