// SPDX-License-Identifier: MIT
using System;
using System.IO;

namespace LangevinRigid
{
    public sealed unsafe partial class World
    {
        /// <summary>Writes every call that can change the world to a stream, with its arguments and results, for <c>lr_replay</c> and for bug
        /// reports. Calls on this world write to the stream. The stream still belongs to the caller, who closes it after
        /// <see cref="StopRecording"/>. Its exceptions end the recording, and that call rethrows them, as
        /// <see cref="World"/> says.
        /// docs/reference/snapshots.md</summary>
        public void StartRecording(Stream to)
        {
            StartRecording(to, RecordingDesc.Create());
        }

        /// <summary>Starts a recording with settings, except <see cref="RecordingDesc.Write"/> and <see cref="RecordingDesc.User"/>.</summary>
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

        /// <summary>Ends the recording after writing its last bytes.</summary>
        public void StopRecording()
        {
            IntPtr world = Enter();
            Status status = Native.lr_world_record_stop(world);
            _callbacks.Recording = null;
            Leave(status, "lr_world_record_stop");
        }
    }
}
