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

        /// <summary>A recording with settings; <see cref="RecordingDesc.Write"/> and <see cref="RecordingDesc.User"/> are set here.</summary>
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

        /// <summary>Ends a recording, after writing its last bytes.</summary>
        public void StopRecording()
        {
            IntPtr world = Enter();
            Status status = Native.lr_world_record_stop(world);
            _callbacks.Recording = null;
            Leave(status, "lr_world_record_stop");
        }
    }
}
