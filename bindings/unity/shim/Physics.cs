// SPDX-License-Identifier: MIT
namespace UnityEngine
{
    // Not used by the package. These types have names of the binding, so that ambiguities appear here as in Unity.
    public struct Ray { public Vector3 origin, direction; }
    public enum ForceMode { Force = 0, Impulse = 1, VelocityChange = 2, Acceleration = 5 }

    public static class Physics
    {
        public static Vector3 gravity { get; set; }
        static Physics() { gravity = new Vector3(0.0f, -9.81f, 0.0f); }
    }

    // PhysicsMaterial in Unity 6: the package uses neither name.
    public class PhysicMaterial : Object
    {
        public float dynamicFriction { get; set; }
        public float bounciness { get; set; }
    }

    public class Collider : Component
    {
        public Collider() { enabled = true; }
        public bool enabled { get; set; }
        public PhysicMaterial sharedMaterial { get; set; }
        public Bounds bounds { get { return new Bounds(transform.position, Vector3.one); } }
    }

    public class BoxCollider : Collider
    {
        public BoxCollider() { size = Vector3.one; }
        public Vector3 center { get; set; }
        public Vector3 size { get; set; }
    }

    public class SphereCollider : Collider
    {
        public SphereCollider() { radius = 0.5f; }
        public Vector3 center { get; set; }
        public float radius { get; set; }
    }

    public class CapsuleCollider : Collider
    {
        public CapsuleCollider() { radius = 0.5f; height = 2.0f; direction = 1; }
        public Vector3 center { get; set; }
        public float radius { get; set; }
        public float height { get; set; }
        public int direction { get; set; }
    }

    public class MeshCollider : Collider
    {
        public Mesh sharedMesh { get; set; }
        public bool convex { get; set; }
    }

    public class CharacterController : Collider { }

    public class TerrainData : Object
    {
        private float[,] heights = new float[2, 2];
        public Vector3 size { get; set; }
        public int heightmapResolution
        {
            get { return heights.GetLength(0); }
            set { heights = new float[value, value]; }
        }
        public float[,] GetHeights(int xBase, int yBase, int width, int height)
        {
            var part = new float[height, width];
            for (int y = 0; y < height; ++y)
                for (int x = 0; x < width; ++x) part[y, x] = heights[yBase + y, xBase + x];
            return part;
        }
        public void SetHeights(int xBase, int yBase, float[,] values)
        {
            for (int y = 0; y < values.GetLength(0); ++y)
                for (int x = 0; x < values.GetLength(1); ++x) heights[yBase + y, xBase + x] = values[y, x];
        }
    }

    public class TerrainCollider : Collider { public TerrainData terrainData { get; set; } }

    public enum WindZoneMode { Directional, Spherical }

    public class WindZone : Component
    {
        public WindZone() { radius = 20.0f; windMain = 1.0f; windTurbulence = 1.0f; windPulseMagnitude = 0.5f; windPulseFrequency = 0.01f; }
        public WindZoneMode mode { get; set; }
        public float radius { get; set; }
        public float windMain { get; set; }
        public float windTurbulence { get; set; }
        public float windPulseMagnitude { get; set; }
        public float windPulseFrequency { get; set; }
    }
}
