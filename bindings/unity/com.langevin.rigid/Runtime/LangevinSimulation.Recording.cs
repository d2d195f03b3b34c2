// SPDX-License-Identifier: MIT
using System;
using System.IO;
using System.Runtime.InteropServices;
using LangevinRigid;

namespace LangevinUnity
{
    public sealed unsafe partial class LangevinSimulation
    {
        private static readonly RecordFn RecordThunk = OnRecord;

        private sealed class Recording
        {
            private readonly FileStream file;
            private readonly byte[] piece = new byte[65536];
            private readonly GCHandle self;
            private Exception failure;

            public Recording(string path)
            {
                // Without a buffer: after a crash the last call is what matters.
                file = new FileStream(path, FileMode.Create, FileAccess.Write, FileShare.Read, 1);
                self = GCHandle.Alloc(this);
            }

            public IntPtr User { get { return GCHandle.ToIntPtr(self); } }

            public bool Append(byte* bytes, ulong size)
            {
                try
                {
                    for (ulong done = 0; done < size;)
                    {
                        int count = (int)Math.Min(size - done, (ulong)piece.Length);
                        Marshal.Copy((IntPtr)(bytes + done), piece, 0, count);
                        file.Write(piece, 0, count);
                        done += (ulong)count;
                    }
                    return true;
                }
                catch (Exception e)
                {
                    failure = e;
                    return false;
                }
            }

            // What went wrong with the file; null when all of it is there.
            public Exception Close()
            {
                if (self.IsAllocated) self.Free();
                try { file.Dispose(); }
                catch (Exception e) { failure = failure ?? e; }
                return failure;
            }
        }

        private Recording recording;

        /// <summary>Whether a recording was started and not yet stopped.</summary>
        public bool IsRecording { get { return recording != null; } }

        /// <summary>Has every call that can change the world written to a file from now on, for lr_replay: the form of a bug report.
        /// Not while a step runs as a job. Throws what opening and writing the file throws.</summary>
        public void StartRecording(string path)
        {
            if (recording != null) throw new InvalidOperationException("A recording is under way: StopRecording ends it.");
            var made = new Recording(path);
            RecordingDesc desc = RecordingDesc.Create();
            desc.HashInterval = 10; // one in each step is most of what recording costs
            desc.Write = Marshal.GetFunctionPointerForDelegate(RecordThunk);
            desc.User = made.User;
            Status status = Native.lr_world_record_start(world, &desc);
            if (status >= Status.Ok)
            {
                recording = made;
                return;
            }
            Exception failure = made.Close();
            if (failure != null) throw new IOException("The recording cannot be written to " + path, failure);
            Check(status, "lr_world_record_start");
        }

        /// <summary>Ends the recording and closes its file. Throws an IOException if not all of it could be written: the file then holds
        /// what came before.</summary>
        public void StopRecording()
        {
            if (recording == null) return;
            Native.lr_world_record_stop(world); // fails where writing has: the world has ended it then
            lastError = null;
            CloseRecording();
        }

        private void CloseRecording()
        {
            if (recording == null) return;
            Exception failure = recording.Close();
            recording = null;
            if (failure != null) throw new IOException("The recording ends early", failure);
        }

        // On the thread that called the library: a step's job, or with callbacks of your own one of its workers.
        [AOT.MonoPInvokeCallback(typeof(RecordFn))]
        private static int OnRecord(IntPtr user, IntPtr bytes, ulong size)
        {
            return ((Recording)GCHandle.FromIntPtr(user).Target).Append((byte*)bytes, size) ? 0 : 1;
        }
    }
}
