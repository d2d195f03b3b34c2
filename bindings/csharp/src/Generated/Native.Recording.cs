// SPDX-License-Identifier: MIT
// Written by bindings/generator/csharp.py from include/langevin_rigid.h: do not edit.
using System;
using System.Runtime.InteropServices;

namespace LangevinRigid
{
    public static unsafe partial class Native
    {
        /// <summary>Fills a struct with its initial values; <c>RecordingDesc.Create()</c> does it with the right size.</summary>
        /// <param name="desc">initialised by its <c>_init</c> function, or with struct_size set</param>
        /// <param name="structSize">sizeof the struct in the caller's header</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_recording_desc_init(RecordingDesc* desc, uint structSize);

        /// <summary>Starts a recording, at any time. First writes the world's present state and the assets of its
        /// batches, then each call that can change the world: its arguments, as a rule before it is carried out, and
        /// its status after it. Allocates 64 KiB and a few bytes per asset; while starting, also a copy of the assets
        /// and a snapshot. If <c>write</c> refuses, the recording ends, a message is logged, and the world goes
        /// on.</summary>
        /// <param name="world">the world</param>
        /// <param name="desc">initialised by its <c>_init</c> function, or with struct_size set</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/> (also desc-&gt;write),
        /// <see cref="Status.StructSize"/>, <see cref="Status.InvalidArgument"/> (unknown flags; already recording;
        /// <c>write</c> has refused), <see cref="Status.OutOfMemory"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_record_start(IntPtr world, RecordingDesc* desc);

        /// <summary>Ends a recording.</summary>
        /// <param name="world">the world</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.InvalidArgument"/>
        /// (not recording, also after <c>write</c> has refused).</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_record_stop(IntPtr world);
    }
}
