// SPDX-License-Identifier: MIT
// Written by bindings/generator/csharp.py from include/langevin_rigid.h: change those.
using System;
using System.Runtime.InteropServices;

namespace LangevinRigid
{
    /// <summary>
    /// <para>Each in its own frame, which <c>position</c> and <c>orientation</c> put into the world. size[] is</para>
    /// <code>
    ///   PLANE        nothing: all below its y = 0 is solid, without bounds
    ///   SPHERE       radius
    ///   CAPSULE      radius, half length of its axis: from (0, -size[1], 0) to (0, size[1], 0)
    ///   BOX          half extents along x, y, z
    ///   HULL         nothing: the convex hull of vertices
    ///   HEIGHTFIELD  nothing: solid below its surface, along -y. Sample (i, k) lies at (i spacing[0], heights[i + counts[0] k],
    ///                k spacing[1]); each cell is two triangles, parted from (i, k) to (i + 1, k + 1)
    ///   MESH         nothing: triangles without an inside, met from both sides; which way round they are does not matter
    /// </code>
    /// </summary>
    public enum ColliderKind : int
    {
        /// <summary>The header's <c>LR_COLLIDER_PLANE</c>.</summary>
        Plane = 1,
        /// <summary>The header's <c>LR_COLLIDER_SPHERE</c>.</summary>
        Sphere = 2,
        /// <summary>The header's <c>LR_COLLIDER_CAPSULE</c>.</summary>
        Capsule = 3,
        /// <summary>The header's <c>LR_COLLIDER_BOX</c>.</summary>
        Box = 4,
        /// <summary>The header's <c>LR_COLLIDER_HULL</c>.</summary>
        Hull = 5,
        /// <summary>The header's <c>LR_COLLIDER_HEIGHTFIELD</c>.</summary>
        Heightfield = 6,
        /// <summary>The header's <c>LR_COLLIDER_MESH</c>.</summary>
        Mesh = 7,
    }

    /// <summary>How a collider is moved.</summary>
    public enum MoveMode : int
    {
        /// <summary>Over the next step it goes from where it is to this pose, and stands still afterwards.</summary>
        To = 1,
        /// <summary>It is there at once, and has these velocities from now on.</summary>
        Place = 2,
        /// <summary>It stays where it is, and has these velocities from now on.</summary>
        Velocity = 3,
    }

    /// <summary>Of the contact of a batch.</summary>
    [Flags]
    public enum ContactFlags : uint
    {
        /// <summary>No bit.</summary>
        None = 0,
        /// <summary>Bodies move until they are put to rest by <see cref="Native.lr_body_set_rest"/>.</summary>
        NeverRest = 1,
    }

    /// <summary>Handles are values, 0 is never one, and those of destroyed colliders are recognised.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public readonly struct ColliderId : IEquatable<ColliderId>
    {
        /// <summary>As the library sees it; 0 is none.</summary>
        public readonly ulong Value;
        /// <summary>From a number that was a handle before.</summary>
        public ColliderId(ulong value) { Value = value; }
        /// <summary>Whether it is no handle at all. One of something destroyed is not null: calls refuse it as stale.</summary>
        public bool IsNull { get { return Value == 0; } }
        /// <inheritdoc/>
        public bool Equals(ColliderId other) { return Value == other.Value; }
        /// <inheritdoc/>
        public override bool Equals(object other) { return other is ColliderId && Equals((ColliderId)other); }
        /// <inheritdoc/>
        public override int GetHashCode() { return Value.GetHashCode(); }
        /// <inheritdoc/>
        public override string ToString() { return "ColliderId(0x" + Value.ToString("x") + ")"; }
        /// <summary>Whether both are the same.</summary>
        public static bool operator ==(ColliderId left, ColliderId right) { return left.Value == right.Value; }
        /// <summary>Whether they differ.</summary>
        public static bool operator !=(ColliderId left, ColliderId right) { return left.Value != right.Value; }
    }

    /// <summary>Fields that a kind does not have are not used.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct ColliderDesc
    {
        /// <summary>Size of the struct in bytes, set by <c>Create</c>. The same in all elements of an array: it is the
        /// array's stride.</summary>
        public uint StructSize;
        /// <summary><see cref="ColliderKind"/>; initially 0, which is none of them</summary>
        public ColliderKind Kind;
        /// <summary>m, up to 1e9 in magnitude; initially 0</summary>
        public Float3 Position;
        /// <summary>quaternion x y z w, normalised when taken; initially 0 0 0 1</summary>
        public Float4 Orientation;
        /// <summary>m/s, of the frame's origin, up to 1e6; initially 0. It moves so until told otherwise</summary>
        public Float3 LinearVelocity;
        /// <summary>rad/s, world frame, up to 1e6; initially 0</summary>
        public Float3 AngularVelocity;
        /// <summary>m, &gt; 0, up to 1e6; initially 0</summary>
        public Float3 Size;
        /// <summary>0 to 10; initially 0.5</summary>
        public float Friction;
        /// <summary>0 to 1; initially 0.2</summary>
        public float Restitution;
        /// <summary>bits: it meets bodies that have one of them; initially 1</summary>
        public uint Layers;
        /// <summary>0</summary>
        public uint Flags;
        /// <summary>hull: 4 to <see cref="Limits.MaxHullVertices"/>; mesh: 3 to
        /// <see cref="Limits.MaxColliderVertices"/></summary>
        public uint VertexCount;
        /// <summary>mesh: 1 to <see cref="Limits.MaxColliderVertices"/></summary>
        public uint TriangleCount;
        /// <summary>heightfield: samples along x and z, each &gt;= 2</summary>
        public UInt2 Counts;
        /// <summary>heightfield: m between samples, 1e-6 to 1e6; initially 1</summary>
        public Float2 Spacing;
        /// <summary>m, x y z each, up to 1e6 in magnitude; copied, as are the others</summary>
        public float* Vertices;
        /// <summary>3 a triangle, each &lt; vertex_count</summary>
        public uint* Indices;
        /// <summary>m, up to 1e6 in magnitude; x varies fastest</summary>
        public float* Heights;

        /// <summary>One with its initial values and its size.</summary>
        public static ColliderDesc Create()
        {
            var value = default(ColliderDesc);
            LangevinLibrary.EnsureLoaded();
            LangevinException.Check(Native.lr_collider_desc_init(&value, (uint)sizeof(ColliderDesc)), "lr_collider_desc_init");
            return value;
        }
    }

    /// <summary>How one collider moves. Within a step its position goes evenly from where it begins to where it ends,
    /// and its orientation by the normalised linear quaternion, the shorter way round: what turns by more than half a
    /// turn in a step seems to turn by less.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct ColliderMotion
    {
        /// <summary>Size of the struct in bytes, set by <c>Create</c>. The same in all elements of an array: it is the
        /// array's stride.</summary>
        public uint StructSize;
        /// <summary><see cref="MoveMode"/>; initially <see cref="MoveMode.To"/></summary>
        public MoveMode Mode;
        /// <summary>Collider.</summary>
        public ColliderId Collider;
        /// <summary>m, as in <see cref="ColliderDesc"/>; <see cref="MoveMode.To"/>, <see cref="MoveMode.Place"/>;
        /// initially 0</summary>
        public Float3 Position;
        /// <summary>alike; initially 0 0 0 1</summary>
        public Float4 Orientation;
        /// <summary>m/s; <see cref="MoveMode.Place"/>, <see cref="MoveMode.Velocity"/>; initially 0</summary>
        public Float3 LinearVelocity;
        /// <summary>rad/s; alike</summary>
        public Float3 AngularVelocity;
        /// <summary>0.</summary>
        public uint Reserved;

        /// <summary>One with its initial values and its size.</summary>
        public static ColliderMotion Create()
        {
            var value = default(ColliderMotion);
            LangevinLibrary.EnsureLoaded();
            LangevinException.Check(Native.lr_collider_motion_init(&value, (uint)sizeof(ColliderMotion)), "lr_collider_motion_init");
            return value;
        }
    }

    /// <summary>The header's <c>struct lr_collider_state</c>.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct ColliderState
    {
        /// <summary>Size of the struct in bytes, set by <c>Create</c>.</summary>
        public uint StructSize;
        /// <summary><see cref="ColliderKind"/></summary>
        public ColliderKind Kind;
        /// <summary>m, world frame</summary>
        public Float3 Position;
        /// <summary>unit quaternion x y z w, collider to world</summary>
        public Float4 Orientation;
        /// <summary>m/s, that it has until told otherwise; 0 while <see cref="MoveMode.To"/> is pending</summary>
        public Float3 LinearVelocity;
        /// <summary>rad/s, world frame; alike</summary>
        public Float3 AngularVelocity;
        /// <summary>Friction.</summary>
        public float Friction;
        /// <summary>Restitution.</summary>
        public float Restitution;
        /// <summary>Layers.</summary>
        public uint Layers;
        /// <summary>0</summary>
        public uint Flags;

        /// <summary>One with its initial values and its size.</summary>
        public static ColliderState Create()
        {
            var value = default(ColliderState);
            LangevinLibrary.EnsureLoaded();
            LangevinException.Check(Native.lr_collider_state_init(&value, (uint)sizeof(ColliderState)), "lr_collider_state_init");
            return value;
        }
    }

    /// <summary>What can be changed of a collider besides its motion.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct ColliderSurface
    {
        /// <summary>Size of the struct in bytes, set by <c>Create</c>.</summary>
        public uint StructSize;
        /// <summary>as in <see cref="ColliderDesc"/>; initially 1</summary>
        public uint Layers;
        /// <summary>initially 0.5</summary>
        public float Friction;
        /// <summary>initially 0.2</summary>
        public float Restitution;

        /// <summary>One with its initial values and its size.</summary>
        public static ColliderSurface Create()
        {
            var value = default(ColliderSurface);
            LangevinLibrary.EnsureLoaded();
            LangevinException.Check(Native.lr_collider_surface_init(&value, (uint)sizeof(ColliderSurface)), "lr_collider_surface_init");
            return value;
        }
    }

    /// <summary>How the bodies of a batch meet colliders. Of a pair, friction is the geometric mean of both and
    /// restitution the larger. Bodies touch with their hull, reduced to 32 points at most, or as the ellipsoid that
    /// they are.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct BatchContact
    {
        /// <summary>Size of the struct in bytes, set by <c>Create</c>.</summary>
        public uint StructSize;
        /// <summary>bit mask: colliders that are in one of these are met; initially all; 0: none</summary>
        public uint Layers;
        /// <summary>coefficient of Coulomb friction, 0 to 10; initially 0.5</summary>
        public float Friction;
        /// <summary>speed after over speed before an impact, 0 to 1; initially 0.1</summary>
        public float Restitution;
        /// <summary>moment against rolling and spinning over normal force and a lever, 0 to 10; initially 0.05. The
        /// lever is the geometric mean of reach and half of the least width: a sphere's radius</summary>
        public float RollingResistance;
        /// <summary><see cref="ContactFlags"/>; initially 0</summary>
        public ContactFlags Flags;
        /// <summary>the air that a sheet must press away before it lies, 0 to 1 of what the flow over planes and
        /// heightfields gives in theory; initially 0. docs/maintainers/contact.md</summary>
        public float GroundEffect;
        /// <summary>0.</summary>
        public uint Reserved;

        /// <summary>One with its initial values and its size.</summary>
        public static BatchContact Create()
        {
            var value = default(BatchContact);
            LangevinLibrary.EnsureLoaded();
            LangevinException.Check(Native.lr_batch_contact_init(&value, (uint)sizeof(BatchContact)), "lr_batch_contact_init");
            return value;
        }
    }
}
