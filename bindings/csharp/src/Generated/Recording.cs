// SPDX-License-Identifier: MIT
// Written by bindings/generator/csharp.py from include/langevin_rigid.h: do not edit.
using System;
using System.Runtime.InteropServices;

namespace LangevinRigid
{
    /// <summary>Records the results of wind and water callbacks, up to 72 bytes per body and substep for each callback.
    /// Without them a replay stops at the first callback.</summary>
    [Flags]
    public enum RecordFlags : uint
    {
        /// <summary>No bit.</summary>
        None = 0,
        /// <summary>The header's <c>LR_RECORD_CALLBACKS</c>.</summary>
        Callbacks = 1,
    }

    /// <summary>Receives the next <c>size</c> bytes of a recording, valid during the call only: append them to a file
    /// or a ring buffer. Return 0, or anything else to end the recording. Called inside functions that take the world,
    /// on their thread. With <see cref="RecordFlags.Callbacks"/> it is also called on the threads that run wind and
    /// water callbacks, but never by two at a time. Must not call the library on the same world, throw or
    /// longjmp.</summary>
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate int RecordFn(IntPtr user, IntPtr bytes, ulong size);

    /// <summary>The header's <c>struct lr_recording_desc</c>.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct RecordingDesc
    {
        /// <summary>Size of the struct in bytes, set by <c>Create</c>.</summary>
        public uint StructSize;
        /// <summary><see cref="RecordFlags"/>; default <see cref="RecordFlags.Callbacks"/></summary>
        public RecordFlags Flags;
        /// <summary>steps between recorded hashes of the world; 0: none; default 1</summary>
        public uint HashInterval;
        /// <summary>0.</summary>
        public uint Reserved;
        /// <summary>required A function pointer of a <see cref="RecordFn"/>.</summary>
        public IntPtr Write;
        /// <summary>User.</summary>
        public IntPtr User;

        /// <summary>A struct with its initial values and its size.</summary>
        public static RecordingDesc Create()
        {
            var value = default(RecordingDesc);
            LangevinLibrary.EnsureLoaded();
            LangevinException.Check(Native.lr_recording_desc_init(&value, (uint)sizeof(RecordingDesc)), "lr_recording_desc_init");
            return value;
        }
    }
}
