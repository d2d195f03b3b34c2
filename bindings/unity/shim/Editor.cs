// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using System.Reflection;
using UnityEngine;

namespace UnityEditor
{
    [AttributeUsage(AttributeTargets.Class)]
    public sealed class InitializeOnLoadAttribute : Attribute { }

    [AttributeUsage(AttributeTargets.Class)]
    public sealed class CustomEditor : Attribute { public CustomEditor(Type inspectedType) { } }

    [AttributeUsage(AttributeTargets.Method, AllowMultiple = true)]
    public sealed class MenuItem : Attribute
    {
        public MenuItem(string itemName) { }
        public MenuItem(string itemName, bool isValidateFunction, int priority) { }
    }

    public sealed class MenuCommand
    {
        public UnityEngine.Object context;
        public MenuCommand(UnityEngine.Object inContext) { context = inContext; }
    }

    public class Editor : ScriptableObject
    {
        public UnityEngine.Object target { get; set; }
        public virtual void OnInspectorGUI() { }
    }

    public class EditorWindow : ScriptableObject
    {
        public static T GetWindow<T>(string title) where T : EditorWindow { return CreateInstance<T>(); }
        public void Repaint() { }
    }

    public static class AssemblyReloadEvents
    {
        public delegate void AssemblyReloadCallback();
        public static event AssemblyReloadCallback beforeAssemblyReload;
        public static void ShimReload() { if (beforeAssemblyReload != null) beforeAssemblyReload(); }
    }

    public enum PlayModeStateChange { EnteredEditMode, ExitingEditMode, EnteredPlayMode, ExitingPlayMode }

    public sealed class EditorApplication
    {
        public delegate void CallbackFunction();
        public static CallbackFunction update;
        public static event Action<PlayModeStateChange> playModeStateChanged;
        public static event Action quitting;
        public static double timeSinceStartup { get { return System.Diagnostics.Stopwatch.GetTimestamp() / (double)System.Diagnostics.Stopwatch.Frequency; } }
        public static void ShimPlayMode(PlayModeStateChange to) { if (playModeStateChanged != null) playModeStateChanged(to); }
        public static void ShimQuit() { if (quitting != null) quitting(); }
    }

    public sealed class EditorPrefs
    {
        private static readonly Dictionary<string, string> Values = new Dictionary<string, string>();
        public static string GetString(string key, string defaultValue) { string v; return Values.TryGetValue(key, out v) ? v : defaultValue; }
        public static void SetString(string key, string value) { Values[key] = value; }
    }

    public static class EditorUtility
    {
        public static bool Cancel;
        public static int Bars;
        public static bool DisplayCancelableProgressBar(string title, string info, float progress) { ++Bars; return Cancel; }
        public static void ClearProgressBar() { }
        public static string OpenFilePanel(string title, string directory, string extension) { return ""; }
        public static void SetDirty(UnityEngine.Object target) { }
    }

    public static class FileUtil { public static string GetUniqueTempPathInProject() { return System.IO.Path.GetTempFileName(); } }

    public static class AssetDatabase
    {
        public static readonly List<string> Imported = new List<string>();
        public static void ImportAsset(string path) { Imported.Add(path); }
        public static readonly Dictionary<string, UnityEngine.Object> Assets = new Dictionary<string, UnityEngine.Object>();
        public static string ScriptPath;
        public static UnityEngine.Object LoadMainAssetAtPath(string assetPath) { return LoadAssetAtPath<UnityEngine.Object>(assetPath); }
        public static T LoadAssetAtPath<T>(string assetPath) where T : UnityEngine.Object
        {
            UnityEngine.Object found;
            return Assets.TryGetValue(assetPath, out found) ? found as T : null;
        }
        public static string GetAssetPath(UnityEngine.Object assetObject) { return assetObject is MonoScript ? ScriptPath : ""; }
    }

    public class AssetImporter : UnityEngine.Object
    {
        public static readonly Dictionary<string, AssetImporter> ShimImporters = new Dictionary<string, AssetImporter>();
        public static AssetImporter GetAtPath(string path) { AssetImporter i; return ShimImporters.TryGetValue(path, out i) ? i : null; }
        public void SaveAndReimport() { }
    }

    public class MonoScript : UnityEngine.Object
    {
        public static MonoScript FromMonoBehaviour(MonoBehaviour behaviour) { return new MonoScript(); }
    }

    public static class EditorGUIUtility { public static void PingObject(UnityEngine.Object obj) { } }

    public static class Selection
    {
        public static UnityEngine.Object activeObject { get; set; }
        public static GameObject[] gameObjects { get { return new GameObject[0]; } }
    }

    public static class Undo
    {
        public static void RegisterCreatedObjectUndo(UnityEngine.Object objectToUndo, string name) { }
        public static T AddComponent<T>(GameObject gameObject) where T : Component { return gameObject.AddComponent<T>(); }
    }

    public static class GameObjectUtility { public static void SetParentAndAlign(GameObject child, GameObject parent) { } }

    public enum MessageType { None, Info, Warning, Error }

    public static class EditorStyles { public static GUIStyle textArea { get { return new GUIStyle(); } } }

    public static class EditorGUI
    {
        public class DisabledScope : IDisposable
        {
            public DisabledScope(bool disabled) { }
            public void Dispose() { }
        }
    }

    public static class EditorGUILayout
    {
        public static void LabelField(string label, string label2, params GUILayoutOption[] options) { }
        public static bool Toggle(GUIContent label, bool value, params GUILayoutOption[] options) { return value; }
        public static UnityEngine.Object ObjectField(string label, UnityEngine.Object obj, Type objType, bool allowSceneObjects, params GUILayoutOption[] options) { return obj; }
        public static double DoubleField(GUIContent label, double value, params GUILayoutOption[] options) { return value; }
        public static string TextField(GUIContent label, string text, params GUILayoutOption[] options) { return text; }
        public static string TextField(string label, string text, params GUILayoutOption[] options) { return text; }
        public static void HelpBox(string message, MessageType type) { }
        public static Vector2 BeginScrollView(Vector2 scrollPosition, params GUILayoutOption[] options) { return scrollPosition; }
        public static void EndScrollView() { }
        public static void SelectableLabel(string text, GUIStyle style, params GUILayoutOption[] options) { }
        public static Rect BeginHorizontal(params GUILayoutOption[] options) { return new Rect(); }
        public static void EndHorizontal() { }
    }
}

namespace UnityEditor.AssetImporters
{
    [AttributeUsage(AttributeTargets.Class)]
    public class ScriptedImporterAttribute : Attribute { public ScriptedImporterAttribute(int version, string ext) { } }

    public abstract class ScriptedImporter : AssetImporter
    {
        public abstract void OnImportAsset(AssetImportContext ctx);
    }

    public class AssetImportContext
    {
        public AssetImportContext(string path) { assetPath = path; }
        public string assetPath { get; private set; }
        public UnityEngine.Object mainObject { get; private set; }
        public readonly List<string> Errors = new List<string>();
        public readonly List<UnityEngine.Object> Objects = new List<UnityEngine.Object>();
        public void AddObjectToAsset(string identifier, UnityEngine.Object obj) { Objects.Add(obj); }
        public void SetMainObject(UnityEngine.Object obj) { mainObject = obj; }
        public void LogImportError(string msg, UnityEngine.Object obj = null) { Errors.Add(msg); }
    }
}

namespace UnityEditor.PackageManager
{
    public class PackageInfo
    {
        public static string ShimPath;
        public string resolvedPath { get { return ShimPath; } }
        public static PackageInfo FindForAssembly(Assembly assembly) { return ShimPath == null ? null : new PackageInfo(); }
    }
}

namespace UnityEngine
{
    public struct Rect { }
    public class GUIStyle { }
    public class GUILayoutOption { }
    public class GUIContent { public GUIContent(string text, string tooltip) { } }

    public static class GUILayout
    {
        public static bool Button(string text, params GUILayoutOption[] options) { return false; }
        public static GUILayoutOption Width(float width) { return new GUILayoutOption(); }
        public static GUILayoutOption ExpandHeight(bool expand) { return new GUILayoutOption(); }
    }
}
