// SPDX-License-Identifier: MIT
using System;
using System.Runtime.InteropServices;

namespace UnityEngine
{
    [StructLayout(LayoutKind.Sequential)]
    public struct Vector2
    {
        public float x, y;
        public Vector2(float x, float y) { this.x = x; this.y = y; }
        public static Vector2 zero { get { return new Vector2(0.0f, 0.0f); } }
        public static Vector2 one { get { return new Vector2(1.0f, 1.0f); } }
    }

    [StructLayout(LayoutKind.Sequential)]
    public struct Vector3 : IEquatable<Vector3>
    {
        public float x, y, z;
        public Vector3(float x, float y, float z) { this.x = x; this.y = y; this.z = z; }
        public static Vector3 zero { get { return new Vector3(0.0f, 0.0f, 0.0f); } }
        public static Vector3 one { get { return new Vector3(1.0f, 1.0f, 1.0f); } }
        public static Vector3 up { get { return new Vector3(0.0f, 1.0f, 0.0f); } }
        public static Vector3 down { get { return new Vector3(0.0f, -1.0f, 0.0f); } }
        public static Vector3 right { get { return new Vector3(1.0f, 0.0f, 0.0f); } }
        public static Vector3 forward { get { return new Vector3(0.0f, 0.0f, 1.0f); } }
        public float sqrMagnitude { get { return x * x + y * y + z * z; } }
        public float magnitude { get { return (float)Math.Sqrt(sqrMagnitude); } }
        public Vector3 normalized { get { float m = magnitude; return m > 1e-5f ? this / m : zero; } }
        public static float Dot(Vector3 a, Vector3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
        public static Vector3 Cross(Vector3 a, Vector3 b)
        {
            return new Vector3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
        }
        public static Vector3 Scale(Vector3 a, Vector3 b) { return new Vector3(a.x * b.x, a.y * b.y, a.z * b.z); }
        public static Vector3 operator +(Vector3 a, Vector3 b) { return new Vector3(a.x + b.x, a.y + b.y, a.z + b.z); }
        public static Vector3 operator -(Vector3 a, Vector3 b) { return new Vector3(a.x - b.x, a.y - b.y, a.z - b.z); }
        public static Vector3 operator -(Vector3 a) { return new Vector3(-a.x, -a.y, -a.z); }
        public static Vector3 operator *(Vector3 a, float s) { return new Vector3(a.x * s, a.y * s, a.z * s); }
        public static Vector3 operator *(float s, Vector3 a) { return a * s; }
        public static Vector3 operator /(Vector3 a, float s) { return new Vector3(a.x / s, a.y / s, a.z / s); }
        public static bool operator ==(Vector3 a, Vector3 b) { return (a - b).sqrMagnitude < 9.99999944e-11f; }
        public static bool operator !=(Vector3 a, Vector3 b) { return !(a == b); }
        public bool Equals(Vector3 o) { return x == o.x && y == o.y && z == o.z; }
        public override bool Equals(object o) { return o is Vector3 && Equals((Vector3)o); }
        public override int GetHashCode() { return x.GetHashCode() ^ y.GetHashCode() << 2 ^ z.GetHashCode() >> 2; }
        public override string ToString() { return ToString("F2"); }
        public string ToString(string format) { return "(" + x.ToString(format) + ", " + y.ToString(format) + ", " + z.ToString(format) + ")"; }
    }

    [StructLayout(LayoutKind.Sequential)]
    public struct Quaternion : IEquatable<Quaternion>
    {
        public float x, y, z, w;
        public Quaternion(float x, float y, float z, float w) { this.x = x; this.y = y; this.z = z; this.w = w; }
        public static Quaternion identity { get { return new Quaternion(0.0f, 0.0f, 0.0f, 1.0f); } }
        public static Quaternion AngleAxis(float degrees, Vector3 axis)
        {
            double half = degrees * Math.PI / 360.0;
            Vector3 v = axis.normalized * (float)Math.Sin(half);
            return new Quaternion(v.x, v.y, v.z, (float)Math.Cos(half));
        }
        public static Quaternion Euler(float ex, float ey, float ez)
        {
            return AngleAxis(ey, Vector3.up) * AngleAxis(ex, Vector3.right) * AngleAxis(ez, Vector3.forward);
        }
        public static Quaternion Inverse(Quaternion q) { return new Quaternion(-q.x, -q.y, -q.z, q.w); }
        public static float Dot(Quaternion a, Quaternion b) { return a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w; }
        public static Quaternion operator *(Quaternion a, Quaternion b)
        {
            return new Quaternion(a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y, a.w * b.y + a.y * b.w + a.z * b.x - a.x * b.z,
                a.w * b.z + a.z * b.w + a.x * b.y - a.y * b.x, a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z);
        }
        public static Vector3 operator *(Quaternion q, Vector3 v)
        {
            var u = new Vector3(q.x, q.y, q.z);
            Vector3 t = 2.0f * Vector3.Cross(u, v);
            return v + q.w * t + Vector3.Cross(u, t);
        }
        public bool Equals(Quaternion o) { return x == o.x && y == o.y && z == o.z && w == o.w; }
        public override bool Equals(object o) { return o is Quaternion && Equals((Quaternion)o); }
        public override int GetHashCode() { return x.GetHashCode() ^ y.GetHashCode() << 2 ^ z.GetHashCode() >> 2 ^ w.GetHashCode() >> 1; }
    }

    // Column-major in memory, as in the engine.
    [StructLayout(LayoutKind.Sequential)]
    public struct Matrix4x4
    {
        public float m00, m10, m20, m30, m01, m11, m21, m31, m02, m12, m22, m32, m03, m13, m23, m33;
        public static Matrix4x4 identity { get { return new Matrix4x4 { m00 = 1.0f, m11 = 1.0f, m22 = 1.0f, m33 = 1.0f }; } }
        public static Matrix4x4 TRS(Vector3 t, Quaternion q, Vector3 s)
        {
            Vector3 x = q * Vector3.right * s.x, y = q * Vector3.up * s.y, z = q * Vector3.forward * s.z;
            return new Matrix4x4
            {
                m00 = x.x, m10 = x.y, m20 = x.z, m01 = y.x, m11 = y.y, m21 = y.z, m02 = z.x, m12 = z.y, m22 = z.z,
                m03 = t.x, m13 = t.y, m23 = t.z, m33 = 1.0f,
            };
        }
        public Vector3 MultiplyPoint3x4(Vector3 p)
        {
            return new Vector3(m00 * p.x + m01 * p.y + m02 * p.z + m03, m10 * p.x + m11 * p.y + m12 * p.z + m13, m20 * p.x + m21 * p.y + m22 * p.z + m23);
        }
    }

    public struct Bounds
    {
        public Bounds(Vector3 center, Vector3 size) { this.center = center; extents = size * 0.5f; }
        public Vector3 center { get; set; }
        public Vector3 extents { get; set; }
        public Vector3 size { get { return extents * 2.0f; } set { extents = value * 0.5f; } }
        public Vector3 min { get { return center - extents; } }
        public Vector3 max { get { return center + extents; } }
        public void SetMinMax(Vector3 low, Vector3 high) { extents = (high - low) * 0.5f; center = low + extents; }
        public void Encapsulate(Bounds b)
        {
            Vector3 a = min, c = max, d = b.min, e = b.max;
            SetMinMax(new Vector3(Math.Min(a.x, d.x), Math.Min(a.y, d.y), Math.Min(a.z, d.z)),
                new Vector3(Math.Max(c.x, e.x), Math.Max(c.y, e.y), Math.Max(c.z, e.z)));
        }
        public bool Contains(Vector3 p)
        {
            Vector3 a = min, b = max;
            return p.x >= a.x && p.y >= a.y && p.z >= a.z && p.x <= b.x && p.y <= b.y && p.z <= b.z;
        }
    }

    public struct Plane
    {
        public Plane(Vector3 normal, float distance) { this.normal = normal; this.distance = distance; }
        public Vector3 normal { get; set; }
        public float distance { get; set; }
    }

    public struct Color
    {
        public float r, g, b, a;
        public Color(float r, float g, float b) { this.r = r; this.g = g; this.b = b; a = 1.0f; }
        public Color(float r, float g, float b, float a) { this.r = r; this.g = g; this.b = b; this.a = a; }
    }

    public struct LayerMask
    {
        public int value { get; set; }
        public static implicit operator LayerMask(int v) { return new LayerMask { value = v }; }
        public static implicit operator int(LayerMask m) { return m.value; }
    }

    public struct Mathf
    {
        public const float PI = (float)Math.PI;
        public const float Deg2Rad = PI / 180.0f;
        public static float Abs(float f) { return Math.Abs(f); }
        public static float Sin(float f) { return (float)Math.Sin(f); }
        public static float Cos(float f) { return (float)Math.Cos(f); }
        public static float Min(float a, float b) { return a < b ? a : b; }
        public static float Max(float a, float b) { return a > b ? a : b; }
        public static int Min(int a, int b) { return a < b ? a : b; }
        public static int Max(int a, int b) { return a > b ? a : b; }
        public static float Clamp(float v, float a, float b) { return v < a ? a : v > b ? b : v; }
        public static int Clamp(int v, int a, int b) { return v < a ? a : v > b ? b : v; }
        public static float Clamp01(float v) { return Clamp(v, 0.0f, 1.0f); }
        public static int NextPowerOfTwo(int v) { int p = 1; while (p < v) p <<= 1; return p; }
    }
}
