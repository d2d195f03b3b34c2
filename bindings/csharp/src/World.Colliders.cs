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

        /// <summary>Creates colliders, all or none; <paramref name="ids"/> may be null.</summary>
        public void CreateColliders(ColliderDesc* descs, int count, ColliderId* ids)
        {
            uint number = Counts.Of(count);
            Leave(Native.lr_collider_create(EnterChange(), descs, number, ids), "lr_collider_create");
        }

        /// <summary>The same for arrays; returns the ids.</summary>
        public ColliderId[] CreateColliders(ColliderDesc[] descs)
        {
            if (descs == null) throw new ArgumentNullException("descs");
            var ids = new ColliderId[descs.Length];
            fixed (ColliderDesc* first = descs)
            fixed (ColliderId* to = ids) CreateColliders(first, descs.Length, to);
            return ids;
        }

        /// <summary>The convex hull of points. Kind and vertices of the desc are set here.</summary>
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

        /// <summary>A mesh of triangles, three indices each. Kind, vertices and triangles of the desc are set here.</summary>
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

        /// <summary>A heightfield with <paramref name="countX"/> samples along x, which varies fastest. Kind, counts and heights of the desc
        /// are set here.</summary>
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

        /// <summary>The same for an array.</summary>
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

        /// <summary>The same for an array, or its first <paramref name="count"/> elements.</summary>
        public void MoveColliders(ColliderMotion[] motions, int count = -1)
        {
            if (motions == null) throw new ArgumentNullException("motions");
            uint number = Counts.OfPart(motions, "motions", count == -1 ? motions.Length : count);
            fixed (ColliderMotion* first = motions) MoveColliders(first, (int)number);
        }

        /// <summary>Where a collider is, and how it moves.</summary>
        public ColliderState GetState(ColliderId collider)
        {
            var state = new ColliderState { StructSize = (uint)sizeof(ColliderState) };
            Leave(Native.lr_collider_get_state(Enter(), collider, &state), "lr_collider_get_state");
            return state;
        }

        /// <summary>Whether a collider is there; false for one that was destroyed, and for none.</summary>
        public bool IsAlive(ColliderId collider)
        {
            var state = new ColliderState { StructSize = (uint)sizeof(ColliderState) };
            Status status = Native.lr_collider_get_state(Enter(), collider, &state);
            Leave(status == Status.StaleCollider ? Status.Ok : status, "lr_collider_get_state");
            return status == Status.Ok;
        }

        /// <summary>Gives a collider a surface, from the next step on.</summary>
        public void SetColliderSurface(ColliderId collider, ColliderSurface surface)
        {
            SetColliderSurface(&collider, 1, surface);
        }

        /// <summary>Gives colliders the same surface, all or none.</summary>
        public void SetColliderSurface(ColliderId* colliders, int count, ColliderSurface surface)
        {
            uint number = Counts.Of(count);
            Leave(Native.lr_collider_set_surface(EnterChange(), colliders, number, &surface), "lr_collider_set_surface");
        }

        /// <summary>The same for an array.</summary>
        public void SetColliderSurface(ColliderId[] colliders, ColliderSurface surface)
        {
            if (colliders == null) throw new ArgumentNullException("colliders");
            fixed (ColliderId* first = colliders) SetColliderSurface(first, colliders.Length, surface);
        }

        /// <summary>Has events kept, at most <paramref name="capacity"/> of a step, from now on; 0 ends it.</summary>
        public void SetContactEvents(int capacity, ContactEvents kinds)
        {
            uint number = Counts.Of(capacity);
            Leave(Native.lr_world_set_contact_events(EnterChange(), number, kinds), "lr_world_set_contact_events");
        }

        /// <summary>Events of the last step, where they lie: valid until the next call that is not a query.</summary>
        public ContactEventList GetContactEvents()
        {
            var list = new ContactEventList { StructSize = (uint)sizeof(ContactEventList) };
            Leave(Native.lr_world_get_contact_events(Enter(), &list), "lr_world_get_contact_events");
            return list;
        }

        /// <summary>Copies events of the last step, as many as there is room for; returns how many.</summary>
        public int CopyContactEvents(ContactEvent[] to)
        {
            if (to == null) throw new ArgumentNullException("to");
            ContactEventList list = GetContactEvents();
            int count = Math.Min(to.Length, (int)list.Count);
            for (int i = 0; i < count; ++i) to[i] = list.Events[i];
            return count;
        }
    }
}
