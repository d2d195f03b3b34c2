// SPDX-License-Identifier: MIT
using System;

namespace LangevinRigid
{
    public sealed unsafe partial class World
    {
        /// <summary>Creates a collider. Its arrays are copied.</summary>
        public ColliderId CreateCollider(ColliderDesc desc)
        {
            ColliderId collider;
            CreateColliders(&desc, 1, &collider);
            return collider;
        }

        /// <summary>Creates colliders, all or none; <paramref name="ids"/> can be null.</summary>
        public void CreateColliders(ColliderDesc* descs, int count, ColliderId* ids)
        {
            uint number = Counts.Of(count);
            LeaveNew(Native.lr_collider_create(EnterChange(), descs, number, ids), "lr_collider_create");
        }

        /// <summary>Creates the colliders of an array, all or none; returns their ids.</summary>
        public ColliderId[] CreateColliders(ColliderDesc[] descs)
        {
            if (descs == null) throw new ArgumentNullException("descs");
            var ids = new ColliderId[descs.Length];
            fixed (ColliderDesc* first = descs)
            fixed (ColliderId* to = ids) CreateColliders(first, descs.Length, to);
            return ids;
        }

        /// <summary>Creates the convex hull of points. Sets kind and vertices of the desc.</summary>
        public ColliderId CreateHull(ColliderDesc desc, Float3[] vertices)
        {
            if (vertices == null) throw new ArgumentNullException("vertices");
            fixed (Float3* points = vertices)
            {
                desc.Kind = ColliderKind.Hull;
                desc.Vertices = (float*)points;
                desc.VertexCount = (uint)vertices.Length;
                return CreateCollider(desc);
            }
        }

        /// <summary>Creates a mesh of triangles, three indices each. Sets kind, vertices and triangles of the desc.</summary>
        public ColliderId CreateMesh(ColliderDesc desc, Float3[] vertices, uint[] indices)
        {
            if (vertices == null) throw new ArgumentNullException("vertices");
            if (indices == null) throw new ArgumentNullException("indices");
            if (indices.Length % 3 != 0) throw new ArgumentException("There are three indices a triangle.", "indices");
            fixed (Float3* points = vertices)
            fixed (uint* corners = indices)
            {
                desc.Kind = ColliderKind.Mesh;
                desc.Vertices = (float*)points;
                desc.VertexCount = (uint)vertices.Length;
                desc.Indices = corners;
                desc.TriangleCount = (uint)(indices.Length / 3);
                return CreateCollider(desc);
            }
        }

        /// <summary>Creates a heightfield with <paramref name="countX"/> samples along x, which varies fastest. Sets kind, counts and heights of the
        /// desc.</summary>
        public ColliderId CreateHeightfield(ColliderDesc desc, float[] heights, int countX)
        {
            if (heights == null) throw new ArgumentNullException("heights");
            if (countX <= 0 || heights.Length % countX != 0)
                throw new ArgumentException(heights.Length + " heights are not whole rows of " + countX + ".", "heights");
            fixed (float* first = heights)
            {
                desc.Kind = ColliderKind.Heightfield;
                desc.Heights = first;
                desc.Counts = new UInt2((uint)countX, (uint)(heights.Length / countX));
                return CreateCollider(desc);
            }
        }

        /// <summary>Destroys a collider.</summary>
        public void DestroyCollider(ColliderId collider)
        {
            DestroyColliders(&collider, 1);
        }

        /// <summary>Destroys colliders, all or none.</summary>
        public void DestroyColliders(ColliderId* colliders, int count)
        {
            uint number = Counts.Of(count);
            Leave(Native.lr_collider_destroy(EnterChange(), colliders, number), "lr_collider_destroy");
        }

        /// <summary>Destroys the colliders of an array, all or none.</summary>
        public void DestroyColliders(ColliderId[] colliders)
        {
            if (colliders == null) throw new ArgumentNullException("colliders");
            fixed (ColliderId* first = colliders) DestroyColliders(first, colliders.Length);
        }

        /// <summary>Moves a collider.</summary>
        public void MoveCollider(ColliderMotion motion)
        {
            MoveColliders(&motion, 1);
        }

        /// <summary>Moves colliders, all or none, in this order.</summary>
        public void MoveColliders(ColliderMotion* motions, int count)
        {
            uint number = Counts.Of(count);
            Leave(Native.lr_collider_move(EnterChange(), motions, number), "lr_collider_move");
        }

        /// <summary>Moves the colliders of an array, or of its first <paramref name="count"/> elements.</summary>
        public void MoveColliders(ColliderMotion[] motions, int count = -1)
        {
            if (motions == null) throw new ArgumentNullException("motions");
            uint number = Counts.OfPart(motions, "motions", count == -1 ? motions.Length : count);
            fixed (ColliderMotion* first = motions) MoveColliders(first, (int)number);
        }

        /// <summary>Whether a collider exists; false for a destroyed collider and for the null handle.</summary>
        public bool IsValid(ColliderId collider)
        {
            int valid = Native.lr_collider_is_valid(Enter(), collider);
            Leave(Status.Ok, "lr_collider_is_valid");
            return valid != 0;
        }

        /// <summary>Sets a collider's material from the next step on.</summary>
        public void SetColliderMaterial(ColliderId collider, ColliderMaterial surface)
        {
            SetColliderMaterial(&collider, 1, surface);
        }

        /// <summary>Sets the material of several colliders, all or none.</summary>
        public void SetColliderMaterial(ColliderId* colliders, int count, ColliderMaterial surface)
        {
            uint number = Counts.Of(count);
            Leave(Native.lr_collider_set_material(EnterChange(), colliders, number, &surface), "lr_collider_set_material");
        }

        /// <summary>Sets the material of the colliders of an array, all or none.</summary>
        public void SetColliderMaterial(ColliderId[] colliders, ColliderMaterial surface)
        {
            if (colliders == null) throw new ArgumentNullException("colliders");
            fixed (ColliderId* first = colliders) SetColliderMaterial(first, colliders.Length, surface);
        }

        /// <summary>Copies events of the last step, as many as fit; returns their number.</summary>
        public int CopyEvents(BodyEvent[] to)
        {
            if (to == null) throw new ArgumentNullException("to");
            EventList list = GetEvents();
            int count = Math.Min(to.Length, (int)list.Count);
            for (int i = 0; i < count; ++i) to[i] = list.Events[i];
            return count;
        }
    }
}
