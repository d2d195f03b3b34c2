// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;

namespace UnityEngine
{
    // Enough for components: the engine's messages by name, and destroyed objects equal to null.
    public class Object
    {
        internal bool Dead;
        public string name { get; set; }
        public Object() { name = ""; }
        public static void Destroy(Object o) { DestroyImmediate(o); }
        public static void DestroyImmediate(Object o)
        {
            var gone = o as GameObject;
            if (gone != null) gone.DestroyAll();
            var component = o as Component;
            if (component != null) component.gameObject.Remove(component);
            if ((object)o != null) o.Dead = true;
        }
        public static bool operator ==(Object a, Object b) { return Same(a, b); }
        public static bool operator !=(Object a, Object b) { return !Same(a, b); }
        private static bool Same(Object a, Object b)
        {
            bool noA = (object)a == null || a.Dead, noB = (object)b == null || b.Dead;
            return noA || noB ? noA && noB : ReferenceEquals(a, b);
        }
        public override bool Equals(object o) { return ReferenceEquals(this, o); }
        public override int GetHashCode() { return System.Runtime.CompilerServices.RuntimeHelpers.GetHashCode(this); }
    }

    public class ScriptableObject : Object
    {
        public static T CreateInstance<T>() where T : ScriptableObject { return Activator.CreateInstance<T>(); }
    }

    public class Component : Object
    {
        public GameObject gameObject { get; internal set; }
        public Transform transform { get { return gameObject.transform; } }
        public new string name { get { return gameObject.name; } set { gameObject.name = value; } }
        public T GetComponent<T>() { return gameObject.GetComponent<T>(); }
        public T GetComponentInParent<T>()
        {
            for (Transform at = transform; at != null; at = at.parent)
            {
                var found = at.gameObject.GetComponent<T>();
                if (found != null) return found;
            }
            return default(T);
        }
        public T[] GetComponentsInChildren<T>() { return gameObject.GetComponentsInChildren<T>(); }
    }

    public class Behaviour : Component
    {
        internal bool On = true;
        internal bool Running;
        internal bool Started;
        public bool enabled { get { return On; } set { On = value; ShimPlayer.Refresh(this); } }
        public bool isActiveAndEnabled { get { return Running; } }
    }

    public class MonoBehaviour : Behaviour { }

    public sealed class Transform : Component
    {
        private Vector3 at;
        private Quaternion turn = Quaternion.identity;
        private Vector3 scale = Vector3.one;
        public Transform() { hasChanged = true; }
        public bool hasChanged { get; set; }
        public Transform parent { get; private set; }
        internal readonly List<Transform> Children = new List<Transform>();
        public Vector3 position { get { return at; } set { at = value; hasChanged = true; } }
        public Quaternion rotation { get { return turn; } set { turn = value; hasChanged = true; } }
        public Vector3 localScale { get { return scale; } set { scale = value; hasChanged = true; } }
        // Parents have no rotation and no scale here.
        public Vector3 lossyScale { get { return scale; } }
        public Vector3 forward { get { return turn * Vector3.forward; } }
        public void SetParent(Transform to) { SetParent(to, true); }
        public void SetParent(Transform to, bool worldPositionStays) { parent = to; if (to != null) to.Children.Add(this); }
        public void SetPositionAndRotation(Vector3 p, Quaternion q) { position = p; rotation = q; }
    }

    public sealed class GameObject : Object
    {
        private readonly List<Component> components = new List<Component>();
        private bool active = true;
        public int layer { get; set; }
        public Transform transform { get; private set; }
        public bool activeInHierarchy { get { return active; } }
        public SceneManagement.Scene scene { get; private set; }
        public GameObject(string name, params Type[] types)
        {
            this.name = name;
            scene = SceneManagement.SceneManager.Active;
            transform = new Transform { gameObject = this };
            components.Add(transform);
            ShimPlayer.Objects.Add(this);
            foreach (Type type in types) AddComponent(type);
        }
        public T AddComponent<T>() where T : Component { return (T)AddComponent(typeof(T)); }
        public Component AddComponent(Type type)
        {
            foreach (RequireComponent need in type.GetCustomAttributes(typeof(RequireComponent), true))
                if (!components.Any(c => need.Type.IsInstanceOfType(c))) AddComponent(need.Type);
            var made = (Component)Activator.CreateInstance(type);
            made.gameObject = this;
            components.Add(made);
            ShimPlayer.Refresh(made as Behaviour);
            return made;
        }
        public T GetComponent<T>() { return components.OfType<T>().FirstOrDefault(); }
        public T[] GetComponentsInChildren<T>()
        {
            return components.OfType<T>().Concat(transform.Children.Where(c => !c.Dead).SelectMany(c => c.gameObject.GetComponentsInChildren<T>())).ToArray();
        }
        public void SetActive(bool value)
        {
            active = value;
            foreach (Component c in components.ToArray()) ShimPlayer.Refresh(c as Behaviour);
        }
        internal IEnumerable<Behaviour> Behaviours { get { return components.OfType<Behaviour>(); } }
        internal void Remove(Component c)
        {
            var behaviour = c as Behaviour;
            if (behaviour != null) { behaviour.On = false; ShimPlayer.Refresh(behaviour); ShimPlayer.Send(c, "OnDestroy"); }
            components.Remove(c);
        }
        internal void DestroyAll()
        {
            foreach (Component c in components.ToArray())
            {
                if (!(c is Transform)) Remove(c);
                c.Dead = true;
            }
            ShimPlayer.Objects.Remove(this);
        }
        public static GameObject CreatePrimitive(PrimitiveType type)
        {
            var made = new GameObject(type.ToString());
            if (type == PrimitiveType.Cube) made.AddComponent<BoxCollider>();
            if (type == PrimitiveType.Sphere) made.AddComponent<SphereCollider>();
            if (type == PrimitiveType.Capsule) made.AddComponent<CapsuleCollider>();
            return made;
        }
    }

    public enum PrimitiveType { Sphere, Capsule, Cylinder, Cube, Plane, Quad }

    // Not in the engine: the loop that calls components in tests.
    public static class ShimPlayer
    {
        public static readonly List<GameObject> Objects = new List<GameObject>();

        public static void Send(object to, string message)
        {
            MethodInfo method = null;
            for (Type type = to.GetType(); type != null && method == null; type = type.BaseType)
                method = type.GetMethod(message, BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly, null, Type.EmptyTypes, null);
            if (method == null) return;
            try { method.Invoke(to, null); }
            catch (TargetInvocationException e) { Debug.LogException(e.InnerException, to as Object); }
        }

        internal static void Refresh(Behaviour b)
        {
            if ((object)b == null) return;
            bool run = b.On && b.gameObject.activeInHierarchy;
            if (run == b.Running) return;
            b.Running = run;
            Send(b, run ? "OnEnable" : "OnDisable");
        }

        private static void All(string message)
        {
            var order = Objects.SelectMany(o => o.Behaviours).Where(b => b.Running).OrderBy(OrderOf).ToArray();
            foreach (Behaviour b in order)
            {
                if (!b.Running) continue;
                if (!b.Started) Send(b, "Start");
                b.Started = true;
                Send(b, message);
            }
        }

        private static int OrderOf(Behaviour b)
        {
            object[] found = b.GetType().GetCustomAttributes(typeof(DefaultExecutionOrder), true);
            return found.Length == 0 ? 0 : ((DefaultExecutionOrder)found[0]).Order;
        }

        public static void Frame(float dt)
        {
            Time.deltaTime = dt;
            Graphics.Calls.Clear();
            All("Update");
            All("LateUpdate");
        }

        public static void FixedFrame()
        {
            All("FixedUpdate");
            Frame(Time.fixedDeltaTime);
        }

        // Statics keep their values; SubsystemRegistration methods run, as with "Enter Play Mode Options".
        public static void EnterPlayModeWithoutReload(Assembly assembly)
        {
            foreach (Type type in assembly.GetTypes())
                foreach (MethodInfo m in type.GetMethods(BindingFlags.Static | BindingFlags.Public | BindingFlags.NonPublic))
                    foreach (RuntimeInitializeOnLoadMethodAttribute a in m.GetCustomAttributes(typeof(RuntimeInitializeOnLoadMethodAttribute), false))
                        if (a.LoadType == RuntimeInitializeLoadType.SubsystemRegistration) m.Invoke(null, null);
        }

        // The engine's behaviour when it loses managed objects: no OnDisable, as after a script crash.
        public static void DropScene() { Objects.Clear(); }

        public static void Clear() { foreach (GameObject o in Objects.ToArray()) Object.DestroyImmediate(o); }
    }

    public static class Time
    {
        public static float deltaTime { get; internal set; }
        public static float fixedDeltaTime { get; set; }
        static Time() { fixedDeltaTime = 0.02f; }
    }

    public static class Debug
    {
        public static readonly List<string> Messages = new List<string>();
        private static void Add(string kind, object message) { lock (Messages) Messages.Add(kind + ": " + message); }
        public static void Log(object message) { Add("log", message); }
        public static void Log(object message, Object context) { Add("log", message); }
        public static void LogWarning(object message) { Add("warning", message); }
        public static void LogWarning(object message, Object context) { Add("warning", message); }
        public static void LogError(object message) { Add("error", message); }
        public static void LogError(object message, Object context) { Add("error", message); }
        public static void LogException(Exception e) { Add("exception", e); }
        public static void LogException(Exception e, Object context) { Add("exception", e); }
    }

    public static class Gizmos
    {
        public static Color color { get; set; }
        public static Matrix4x4 matrix { get; set; }
        public static void DrawRay(Vector3 from, Vector3 direction) { }
        public static void DrawWireCube(Vector3 center, Vector3 size) { }
        public static void DrawWireSphere(Vector3 center, float radius) { }
    }
}

namespace UnityEngine.SceneManagement
{
    public struct Scene
    {
        public int handle { get; internal set; }
        public static bool operator ==(Scene a, Scene b) { return a.handle == b.handle; }
        public static bool operator !=(Scene a, Scene b) { return !(a == b); }
        public override bool Equals(object o) { return o is Scene && (Scene)o == this; }
        public override int GetHashCode() { return handle; }
    }

    public static class SceneManager
    {
        internal static Scene Active;
        public static Scene GetActiveScene() { return Active; }
        public static bool SetActiveScene(Scene to) { Active = to; return true; }
        public static Scene CreateScene(string name) { return new Scene { handle = name.GetHashCode() }; }
    }
}

namespace UnityEngine.Events
{
    public delegate void UnityAction<T0>(T0 arg0);

    public class UnityEvent<T0>
    {
        private UnityAction<T0> calls;
        public void AddListener(UnityAction<T0> call) { calls += call; }
        public void RemoveListener(UnityAction<T0> call) { calls -= call; }
        public void Invoke(T0 arg0) { if (calls != null) calls(arg0); }
    }
}
