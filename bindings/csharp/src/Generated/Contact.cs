// SPDX-License-Identifier: MIT
// Written by bindings/generator/csharp.py from include/langevin_rigid.h: do not edit.
using System;
using System.Runtime.InteropServices;

namespace LangevinRigid
{
    /// <summary>
    /// <para>Shapes of colliders, in a frame of their own that <c>position</c> and <c>orientation</c> place in the
    /// world. size[] holds</para>
    /// <code>
    ///   PLANE        nothing: everything below y = 0 is solid, without bounds
    ///   SPHERE       the radius
    ///   CAPSULE      the radius, and half the length of its axis from (0, -size[1], 0) to (0, size[1], 0)
    ///   BOX          half extents along x, y, z
    ///   HULL         nothing: the convex hull of `vertices`
    ///   HEIGHTFIELD  nothing: solid below its surface, along -y. Sample (i, k) lies at
    ///                (i spacing[0], heights[i + counts[0] k], k spacing[1]); the diagonal from (i, k) to (i + 1, k + 1)
    ///                splits each cell into two triangles
    ///   MESH         nothing: triangles without an inside. Both sides collide, and winding does not matter. A body pays for
    ///                each triangle near it: 2 us a substep on triangles of its own size, 20 us on those of an eighth, 70 us on
    ///                those of a sixteenth, far more on smaller ones. Give scanned scenery a coarser collision mesh
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

    /// <summary>Ways to move a collider.</summary>
    public enum MoveMode : int
    {
        /// <summary>Sweeps to this pose during the next step, then stands still.</summary>
        To = 1,
        /// <summary>Teleports to this pose, and moves with these velocities from now on.</summary>
        Place = 2,
        /// <summary>Keeps its pose, and moves with these velocities from now on.</summary>
        Velocity = 3,
    }

    /// <summary>Options of a batch's contact.</summary>
    [Flags]
    public enum ContactFlags : uint
    {
        /// <summary>No bit.</summary>
        None = 0,
        /// <summary>Bodies never fall asleep by themselves, only by <see cref="Native.lr_body_set_sleep"/>.</summary>
        NeverSleep = 1,
    }

    /// <summary>A collider. Fields that its kind does not use are ignored. Arrays are copied.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct ColliderDesc
    {
        /// <summary>Size of the struct in bytes, set by <c>Create</c>. Equal in all elements of an array: also the
        /// array's stride.</summary>
        public uint StructSize;
        /// <summary><see cref="ColliderKind"/>; must be set: the default 0 is no kind</summary>
        public ColliderKind Kind;
        /// <summary>m, up to 1e9 in magnitude; default 0</summary>
        public Float3 Position;
        /// <summary>quaternion x y z w, normalised by the call; default 0 0 0 1</summary>
        public Float4 Orientation;
        /// <summary>m/s, of the frame's origin, up to 1e6; default 0. Lasts until changed</summary>
        public Float3 LinearVelocity;
        /// <summary>rad/s, world frame, up to 1e6; default 0. Lasts until changed</summary>
        public Float3 AngularVelocity;
        /// <summary>m, &gt; 0, up to 1e6; default 0</summary>
        public Float3 Size;
        /// <summary>0 to 10; default 0.5</summary>
        public float Friction;
        /// <summary>0 to 1; default 0.2</summary>
        public float Restitution;
        /// <summary>bits: collides with bodies that share at least one; default 1</summary>
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
        /// <summary>heightfield: m between samples, 1e-6 to 1e6; default 1</summary>
        public Float2 Spacing;
        /// <summary>m, x y z each, up to 1e6 in magnitude</summary>
        public float* Vertices;
        /// <summary>3 per triangle, each &lt; vertex_count</summary>
        public uint* Indices;
        /// <summary>m, up to 1e6 in magnitude; x varies fastest</summary>
        public float* Heights;

        /// <summary>A struct with its initial values and its size.</summary>
        public static ColliderDesc Create()
        {
            var value = default(ColliderDesc);
            LangevinLibrary.EnsureLoaded();
            LangevinException.Check(Native.lr_collider_desc_init(&value, (uint)sizeof(ColliderDesc)), "lr_collider_desc_init");
            return value;
        }
    }

    /// <summary>A motion of one collider. Within a step its position moves linearly and its orientation follows the
    /// normalised linear quaternion, the shorter way round: rotations of more than half a turn per step appear
    /// shorter.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct ColliderMotion
    {
        /// <summary>Size of the struct in bytes, set by <c>Create</c>. Equal in all elements of an array: also the
        /// array's stride.</summary>
        public uint StructSize;
        /// <summary><see cref="MoveMode"/>; default <see cref="MoveMode.To"/></summary>
        public MoveMode Mode;
        /// <summary>Collider.</summary>
        public ColliderId Collider;
        /// <summary>m, as in <see cref="ColliderDesc"/>; <see cref="MoveMode.To"/> and <see cref="MoveMode.Place"/>;
        /// default 0</summary>
        public Float3 Position;
        /// <summary>quaternion x y z w; <see cref="MoveMode.To"/> and <see cref="MoveMode.Place"/>; default 0 0 0
        /// 1</summary>
        public Float4 Orientation;
        /// <summary>m/s; <see cref="MoveMode.Place"/> and <see cref="MoveMode.Velocity"/>; default 0</summary>
        public Float3 LinearVelocity;
        /// <summary>rad/s; <see cref="MoveMode.Place"/> and <see cref="MoveMode.Velocity"/>; default 0</summary>
        public Float3 AngularVelocity;
        /// <summary>0.</summary>
        public uint Reserved;

        /// <summary>A struct with its initial values and its size.</summary>
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
        /// <summary>m/s, that lasts until changed; 0 while <see cref="MoveMode.To"/> is pending</summary>
        public Float3 LinearVelocity;
        /// <summary>rad/s, world frame, that lasts until changed; 0 while <see cref="MoveMode.To"/> is
        /// pending</summary>
        public Float3 AngularVelocity;
        /// <summary>Friction.</summary>
        public float Friction;
        /// <summary>Restitution.</summary>
        public float Restitution;
        /// <summary>Layers.</summary>
        public uint Layers;
        /// <summary>0</summary>
        public uint Flags;

        /// <summary>A struct with its initial values and its size.</summary>
        public static ColliderState Create()
        {
            var value = default(ColliderState);
            LangevinLibrary.EnsureLoaded();
            LangevinException.Check(Native.lr_collider_state_init(&value, (uint)sizeof(ColliderState)), "lr_collider_state_init");
            return value;
        }
    }

    /// <summary>The material of a collider.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct ColliderMaterial
    {
        /// <summary>Size of the struct in bytes, set by <c>Create</c>.</summary>
        public uint StructSize;
        /// <summary>as in <see cref="ColliderDesc"/>; default 1</summary>
        public uint Layers;
        /// <summary>as in <see cref="ColliderDesc"/>; default 0.5</summary>
        public float Friction;
        /// <summary>as in <see cref="ColliderDesc"/>; default 0.2</summary>
        public float Restitution;

        /// <summary>A struct with its initial values and its size.</summary>
        public static ColliderMaterial Create()
        {
            var value = default(ColliderMaterial);
            LangevinLibrary.EnsureLoaded();
            LangevinException.Check(Native.lr_material_init(&value, (uint)sizeof(ColliderMaterial)), "lr_material_init");
            return value;
        }
    }

    /// <summary>How bodies of a batch collide. A contact uses the geometric mean of both frictions and the larger
    /// restitution. A body collides as its hull, reduced to at most 32 points, or as an ellipsoid if its asset is
    /// one.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct BatchContact
    {
        /// <summary>Size of the struct in bytes, set by <c>Create</c>.</summary>
        public uint StructSize;
        /// <summary>bits: collides with colliders that share at least one; default all; 0: none</summary>
        public uint Layers;
        /// <summary>coefficient of Coulomb friction, 0 to 10; default 0.5</summary>
        public float Friction;
        /// <summary>speed after an impact over speed before it, 0 to 1; default 0.1</summary>
        public float Restitution;
        /// <summary>moment against rolling and spinning over normal force times lever, 0 to 10; default 0.05. The lever
        /// is the geometric mean of reach and half the thickness: of a sphere, its radius</summary>
        public float RollingResistance;
        /// <summary>bits: <see cref="ContactFlags.NeverSleep"/>; default 0</summary>
        public ContactFlags Flags;
        /// <summary>air cushion under a sheet that settles on a plane or heightfield, as a share of theory, 0 to 1;
        /// default 0. docs/maintainers/contact.md</summary>
        public float GroundEffect;
        /// <summary>0.</summary>
        public uint Reserved;
        /// <summary>m, at scale 1, -1 to 10: sheets thinner than this meet other bodies as if they were so thick, at
        /// most a tenth of their reach; 0: 1/32 of it, at most 1.25 mm; below 0: as thick as they are, for decks of
        /// cards; default 0</summary>
        public float MinThickness;

        /// <summary>A struct with its initial values and its size.</summary>
        public static BatchContact Create()
        {
            var value = default(BatchContact);
            LangevinLibrary.EnsureLoaded();
            LangevinException.Check(Native.lr_batch_contact_init(&value, (uint)sizeof(BatchContact)), "lr_batch_contact_init");
            return value;
        }
    }
}
