// SPDX-License-Identifier: MIT
using System;
using System.IO;

namespace LangevinRigid
{
    public sealed unsafe partial class World
    {
        /// <summary>Has every call that can change the world written to a stream from now on, with its arguments and what came out, for
        /// <c>lr_replay</c>: the form of a bug report. The stream is written to within calls on this world; it stays the caller's, who
        /// closes it after <see cref="StopRecording"/>. What it throws ends the recording, and is thrown again by that call.
        /// docs/reference/snapshots.md</summary>
        public void StartRecording(Stream to)
        {
            StartRecording(to, RecordingDesc.Create());
        }

        /// <summary>The same with settings; <see cref="RecordingDesc.Write"/> and <see cref="RecordingDesc.User"/> are set here.</summary>
        public void StartRecording(Stream to, RecordingDesc desc)
        {
            IntPtr world = Enter();
            if (to == null)
            {
                Leave(Status.Ok, "lr_world_record_start");
                throw new ArgumentNullException("to");
            }
            Stream before = _callbacks.Recording;
            _callbacks.Recording = to;
            desc.Write = WorldCallbacks.Pointers.Record;
            desc.User = _callbacks.User;
            Status status = Native.lr_world_record_start(world, &desc);
            if (status < Status.Ok) _callbacks.Recording = before;
            Leave(status, "lr_world_record_start");
        }

        /// <summary>Ends a recording, after its last bytes have been written.</summary>
        public void StopRecording()
        {
            IntPtr world = Enter();
            Status status = Native.lr_world_record_stop(world);
            _callbacks.Recording = null;
            Leave(status, "lr_world_record_stop");
        }
    }

    /// <summary>What of a snapshot is not in another one of the same world: for sending, and for long rings of states.
    /// docs/reference/snapshots.md</summary>
    public static unsafe class SnapshotDelta
    {
        /// <summary>The difference of a snapshot to an earlier one, the base.</summary>
        public static byte[] Encode(byte[] baseSnapshot, byte[] snapshot)
        {
            if (baseSnapshot == null) throw new ArgumentNullException("baseSnapshot");
            if (snapshot == null) throw new ArgumentNullException("snapshot");
            LangevinLibrary.EnsureLoaded();
            var delta = new byte[Native.lr_snapshot_delta_bound((ulong)snapshot.Length)];
            ulong written;
            byte none;
            fixed (byte* old = baseSnapshot, now = snapshot, to = delta)
                LangevinException.Check(
                    Native.lr_snapshot_delta_encode(old == null ? &none : old, (ulong)baseSnapshot.Length, now == null ? &none : now,
                        (ulong)snapshot.Length, to == null ? &none : to, (ulong)delta.Length, &written),
                    "lr_snapshot_delta_encode");
            Array.Resize(ref delta, (int)written);
            return delta;
        }

        /// <summary>The snapshot that a delta was made of, given the base that it was made with.</summary>
        public static byte[] Apply(byte[] baseSnapshot, byte[] delta)
        {
            if (baseSnapshot == null) throw new ArgumentNullException("baseSnapshot");
            if (delta == null) throw new ArgumentNullException("delta");
            LangevinLibrary.EnsureLoaded();
            ulong size;
            byte none;
            fixed (byte* old = baseSnapshot, from = delta)
            {
                byte* first = old == null ? &none : old, second = from == null ? &none : from;
                Status status = Native.lr_snapshot_delta_apply(first, (ulong)baseSnapshot.Length, second, (ulong)delta.Length, null, 0, &size);
                if (status != Status.BufferTooSmall) LangevinException.Check(status, "lr_snapshot_delta_apply");
                var snapshot = new byte[size];
                fixed (byte* to = snapshot)
                    LangevinException.Check(
                        Native.lr_snapshot_delta_apply(first, (ulong)baseSnapshot.Length, second, (ulong)delta.Length, to, size, &size),
                        "lr_snapshot_delta_apply");
                return snapshot;
            }
        }
    }
}
