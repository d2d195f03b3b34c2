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
                // Unbuffered: after a crash the last call matters most.
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

            // The first exception of writing the file; null if the file is complete.
            public Exception Close()
            {
                if (self.IsAllocated) self.Free();
                try { file.Dispose(); }
                catch (Exception e) { failure = failure ?? e; }
                return failure;
            }
        }

        private Recording recording;

        /// <summary>Whether a recording is running.</summary>
        public bool IsRecording { get { return recording != null; } }

        /// <summary>Writes every call that can change the world to a file, for lr_replay and for bug reports. Not while a step runs as a job.
        /// Throws the exceptions of opening and writing the file.</summary>
        public void StartRecording(string path)
        {
            if (recording != null) throw new InvalidOperationException("A recording is already running: StopRecording ends it.");
            var made = new Recording(path);
            RecordingDesc desc = RecordingDesc.Create();
            desc.HashInterval = 10; // hashing every step would be most of the cost of a recording
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

        /// <summary>Ends the recording and closes its file. Throws an IOException if the file is incomplete: then its contents end before the
        /// error.</summary>
        public void StopRecording()
        {
            if (recording == null) return;
            Native.lr_world_record_stop(world); // fails after a write error, because the world has already ended the recording
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

        // Runs on the thread that called the library: a step's job, or a worker if you have callbacks.
        [AOT.MonoPInvokeCallback(typeof(RecordFn))]
        private static int OnRecord(IntPtr user, IntPtr bytes, ulong size)
        {
            return ((Recording)GCHandle.FromIntPtr(user).Target).Append((byte*)bytes, size) ? 0 : 1;
        }
    }
}
