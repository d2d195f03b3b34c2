// SPDX-License-Identifier: MIT
using System;

namespace LangevinRigid
{
    public sealed unsafe partial class World
    {
        /// <summary>The first hit of a ray; all 0 without a hit.</summary>
        public RayHit RayCast(Ray ray)
        {
            RayHit hit;
            RayCast(&ray, 1, &hit);
            return hit;
        }

        /// <summary>The first hit of each ray.</summary>
        public void RayCast(Ray* rays, int count, RayHit* hits)
        {
            uint number = Counts.Of(count);
            Leave(Native.lr_world_ray_cast(Enter(), rays, number, hits), "lr_world_ray_cast");
        }

        /// <summary>The first hit of each ray, for arrays of equal length.</summary>
        public void RayCast(Ray[] rays, RayHit[] hits)
        {
            if (rays == null) throw new ArgumentNullException("rays");
            Counts.CheckRoom(hits, "hits", rays.Length);
            fixed (Ray* from = rays)
            fixed (RayHit* to = hits) RayCast(from, rays.Length, to);
        }

        /// <summary>Finds bodies that overlap a sphere or box. Returns false if there are more than <paramref name="capacity"/>; then it writes only
        /// their number.</summary>
        public bool TryOverlap(OverlapDesc desc, BodyId* bodies, int capacity, out int count)
        {
            uint room = Counts.Of(capacity), found = 0;
            Status status = Native.lr_world_overlap(Enter(), &desc, bodies, room, &found);
            bool fits = status != Status.BufferTooSmall;
            Leave(fits ? status : Status.Ok, "lr_world_overlap");
            count = (int)found;
            return fits;
        }

        /// <summary>Bodies that overlap a sphere or box.</summary>
        public BodyId[] Overlap(OverlapDesc desc)
        {
            int count;
            TryOverlap(desc, null, 0, out count);
            var bodies = new BodyId[count];
            fixed (BodyId* first = bodies) TryOverlap(desc, first, count, out count);
            return bodies;
        }

        /// <summary>The present size of a snapshot, in bytes.</summary>
        public ulong SnapshotSize
        {
            get
            {
                ulong size = Native.lr_world_snapshot_size(Enter());
                Leave(Status.Ok, "lr_world_snapshot_size");
                return size;
            }
        }

        /// <summary>The world's state: everything that steps depend on, except assets, threads and callbacks.</summary>
        public byte[] SaveSnapshot()
        {
            var bytes = new byte[SnapshotSize];
            fixed (byte* first = bytes) SaveSnapshot(first, (ulong)bytes.Length);
            return bytes;
        }

        /// <summary>Writes a snapshot into memory of any alignment; returns the bytes used.</summary>
        public ulong SaveSnapshot(void* memory, ulong size)
        {
            ulong written;
            Leave(Native.lr_world_snapshot_save(Enter(), memory, size, &written), "lr_world_snapshot_save");
            return written;
        }

        /// <summary>Restores a snapshot of this world, or of one with the same batches.</summary>
        public void RestoreSnapshot(byte[] bytes)
        {
            if (bytes == null) throw new ArgumentNullException("bytes");
            byte none;
            fixed (byte* first = bytes) RestoreSnapshot(first == null ? &none : first, (ulong)bytes.Length);
        }

        /// <summary>Restores a snapshot from memory.</summary>
        public void RestoreSnapshot(void* memory, ulong size)
        {
            Leave(Native.lr_world_snapshot_restore(EnterChange(), memory, size), "lr_world_snapshot_restore");
        }

        /// <summary>Switches contact between the bodies of two batches, or among those of one batch.</summary>
        public void SetBodyContact(Batch a, Batch b, bool enabled)
        {
            if (a == null) throw new ArgumentNullException("a");
            if (b == null) throw new ArgumentNullException("b");
            BatchId first = a.IdIn(this), second = b.IdIn(this);
            Leave(Native.lr_batch_set_body_contact(EnterChange(), first, second, enabled ? 1 : 0), "lr_batch_set_body_contact");
        }

        /// <summary>Whether two batches have body contact.</summary>
        public bool GetBodyContact(Batch a, Batch b)
        {
            if (a == null) throw new ArgumentNullException("a");
            if (b == null) throw new ArgumentNullException("b");
            BatchId first = a.IdIn(this), second = b.IdIn(this);
            int enabled;
            Leave(Native.lr_batch_get_body_contact(Enter(), first, second, &enabled), "lr_batch_get_body_contact");
            return enabled != 0;
        }
    }
}
