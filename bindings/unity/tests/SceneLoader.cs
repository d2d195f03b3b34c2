// SPDX-License-Identifier: MIT
using System;
using System.Collections;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Reflection;
using System.Text.RegularExpressions;
using UnityEngine;

// Loads a scene as Unity saves it: enough of its YAML for the sample. Fields of scripts are set by their names, as Unity does; one that the
// script does not have is an error.
public sealed class SceneLoader
{
    private readonly Dictionary<string, UnityEngine.Object> imported;
    private readonly Dictionary<string, string> files = new Dictionary<string, string>();
    public readonly List<GameObject> Made = new List<GameObject>();

    // imported: by file name, the objects that importers would make.
    public SceneLoader(string package, Dictionary<string, UnityEngine.Object> imported)
    {
        this.imported = imported;
        foreach (string meta in Directory.GetFiles(package, "*.meta", SearchOption.AllDirectories))
            files[Regex.Match(File.ReadAllText(meta), "guid: (\\w+)").Groups[1].Value] = meta.Substring(0, meta.Length - 5);
    }

    private sealed class Document
    {
        public string Kind, Id;
        public Dictionary<string, object> Fields;
        public UnityEngine.Object Object;
    }

    // Maps, lists and texts of indented lines. A list is at its key's indentation, and its first line at the dash.
    private static object Parse(List<string> lines, ref int at, int indent)
    {
        if (at < lines.Count && Indent(lines[at]) == indent && lines[at].TrimStart().StartsWith("- "))
        {
            var list = new List<object>();
            while (at < lines.Count && Indent(lines[at]) == indent && lines[at].TrimStart().StartsWith("- "))
            {
                string item = lines[at].Substring(indent + 2);
                if (item.StartsWith("{")) { list.Add(Flow(item)); ++at; continue; }
                lines[at] = new string(' ', indent + 2) + item;
                list.Add(Parse(lines, ref at, indent + 2));
            }
            return list;
        }
        var map = new Dictionary<string, object>();
        while (at < lines.Count && Indent(lines[at]) == indent && !lines[at].TrimStart().StartsWith("- "))
        {
            string line = lines[at++].Substring(indent);
            int colon = line.IndexOf(':');
            string key = line.Substring(0, colon), value = line.Substring(colon + 1).Trim();
            if (value.Length == 0 && at < lines.Count && (Indent(lines[at]) > indent || (Indent(lines[at]) == indent && lines[at].TrimStart().StartsWith("- "))))
                map[key] = Parse(lines, ref at, Indent(lines[at]));
            else map[key] = Flow(value);
        }
        return map;
    }

    private static int Indent(string line) { return line.Length - line.TrimStart().Length; }

    private static object Flow(string value)
    {
        if (value == "[]") return new List<object>();
        if (!value.StartsWith("{")) return value;
        return value.Trim('{', '}').Split(',').Select(p => p.Split(':')).ToDictionary(p => p[0].Trim(), p => (object)p[1].Trim());
    }

    private static Dictionary<string, object> Map(object o) { return (Dictionary<string, object>)o; }

    public void Load(string path) { Load(path, null); }

    private void Load(string path, Transform parent)
    {
        var documents = new Dictionary<string, Document>();
        foreach (string part in Regex.Split(File.ReadAllText(path), "^--- ", RegexOptions.Multiline).Skip(1))
        {
            List<string> lines = part.Split('\n').Where(l => l.Length > 0).ToList();
            Match head = Regex.Match(lines[0], "^!u!(\\d+) &(\\d+)( stripped)?$");
            if (!head.Success) throw new InvalidDataException(lines[0]);
            if (head.Groups[3].Success) continue;
            int at = 2;
            var document = new Document { Kind = head.Groups[1].Value, Id = head.Groups[2].Value, Fields = Map(Parse(lines, ref at, 2)) };
            if (at != lines.Count) throw new InvalidDataException(path + ": " + lines[at]);
            documents.Add(document.Id, document);
        }
        var objects = new List<GameObject>();
        foreach (Document o in documents.Values.Where(d => d.Kind == "1"))
        {
            var made = new GameObject((string)o.Fields["m_Name"]);
            made.SetActive(false);
            objects.Add(made);
            o.Object = made;
            foreach (object entry in (List<object>)o.Fields["m_Component"])
                Add(made, documents[(string)Map(Map(entry)["component"])["fileID"]]);
        }
        foreach (Document d in documents.Values)
        {
            if (d.Kind == "4") Place((Transform)d.Object, d.Fields, documents, parent);
            else if (d.Object is MonoBehaviour)
                Fill(d.Object, d.Fields.Where(f => !f.Key.StartsWith("m_")).ToDictionary(f => f.Key, f => f.Value), documents);
            else if (d.Object is WindZone || d.Object is Collider) Native(d.Object, d.Fields);
        }
        foreach (Document d in documents.Values.Where(d => d.Kind == "1001"))
        {
            string father = (string)Map(Map(d.Fields["m_Modification"])["m_TransformParent"])["fileID"];
            Load(files[(string)Map(d.Fields["m_SourcePrefab"])["guid"]], father == "0" ? null : (Transform)documents[father].Object);
        }
        foreach (GameObject o in objects) o.SetActive(true);
        Made.AddRange(objects);
    }

    private void Add(GameObject to, Document d)
    {
        Type type = null;
        switch (d.Kind)
        {
            case "4": d.Object = to.transform; return;
            case "23": type = typeof(MeshRenderer); break;
            case "65": type = typeof(BoxCollider); break;
            case "135": type = typeof(SphereCollider); break;
            case "182": type = typeof(WindZone); break;
            case "114":
                string name = Path.GetFileNameWithoutExtension(files[(string)Map(d.Fields["m_Script"])["guid"]]);
                type = AppDomain.CurrentDomain.GetAssemblies().SelectMany(a => a.GetTypes()).First(t => t.Name == name && typeof(MonoBehaviour).IsAssignableFrom(t));
                break;
            default: return; // camera, light, mesh filter
        }
        d.Object = to.AddComponent(type);
    }

    private static void Place(Transform t, Dictionary<string, object> f, Dictionary<string, Document> documents, Transform outside)
    {
        t.position = (Vector3)Value(typeof(Vector3), f["m_LocalPosition"]);
        t.localScale = (Vector3)Value(typeof(Vector3), f["m_LocalScale"]);
        t.rotation = (Quaternion)Value(typeof(Quaternion), f["m_LocalRotation"]);
        string father = (string)Map(f["m_Father"])["fileID"];
        Transform parent = father == "0" ? outside : (Transform)documents[father].Object;
        if (parent != null) t.SetParent(parent);
    }

    // m_WindMain is the property windMain.
    private static void Native(object to, Dictionary<string, object> fields)
    {
        foreach (KeyValuePair<string, object> f in fields.Where(f => f.Key.StartsWith("m_")))
        {
            PropertyInfo p = to.GetType().GetProperty(char.ToLower(f.Key[2]) + f.Key.Substring(3));
            if (p != null && p.CanWrite && p.Name != "gameObject") p.SetValue(to, Value(p.PropertyType, f.Value), null);
        }
    }

    private void Fill(object to, Dictionary<string, object> fields, Dictionary<string, Document> documents)
    {
        foreach (KeyValuePair<string, object> f in fields)
        {
            FieldInfo field = null;
            for (Type type = to.GetType(); type != null && field == null; type = type.BaseType)
                field = type.GetField(f.Key, BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly);
            if (field == null || !(field.IsPublic || field.GetCustomAttributes(typeof(SerializeField), false).Any()))
                throw new InvalidDataException(to.GetType().Name + " has no field " + f.Key);
            field.SetValue(to, Value(field.FieldType, f.Value, field.GetValue(to), documents));
        }
    }

    private static object Value(Type type, object from)
    {
        var map = from as Dictionary<string, object>;
        if (map != null)
        {
            object made = Activator.CreateInstance(type);
            foreach (KeyValuePair<string, object> f in map) type.GetField(f.Key).SetValue(made, Value(typeof(float), f.Value));
            return made;
        }
        var text = (string)from;
        if (type == typeof(bool)) return text == "1";
        if (type.IsEnum) return Enum.ToObject(type, int.Parse(text));
        return Convert.ChangeType(text, type, CultureInfo.InvariantCulture);
    }

    private object Value(Type type, object from, object before, Dictionary<string, Document> documents)
    {
        if (typeof(UnityEngine.Object).IsAssignableFrom(type))
        {
            Dictionary<string, object> map = Map(from);
            object guid;
            if (map.TryGetValue("guid", out guid)) return imported[Path.GetFileName(files[(string)guid])];
            return (string)map["fileID"] == "0" ? null : documents[(string)map["fileID"]].Object;
        }
        if (type.IsArray)
        {
            var items = (List<object>)from;
            Array made = Array.CreateInstance(type.GetElementType(), items.Count);
            for (int i = 0; i < items.Count; ++i)
                made.SetValue(Value(type.GetElementType(), items[i], type.GetElementType().IsValueType ? Activator.CreateInstance(type.GetElementType()) : null, documents), i);
            return made;
        }
        if (from is Dictionary<string, object> && type.Namespace != "UnityEngine")
        {
            Fill(before, Map(from), documents);
            return before;
        }
        return Value(type, from);
    }
}
