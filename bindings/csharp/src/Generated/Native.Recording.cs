// SPDX-License-Identifier: MIT
// Written by bindings/generator/csharp.py from include/langevin_rigid.h: change those.
using System;
using System.Runtime.InteropServices;

namespace LangevinRigid
{
    public static unsafe partial class Native
    {
        /// <summary>Fills a struct with its initial values; <c>RecordingDesc.Create()</c> does it with the right size.</summary>
        /// <param name="desc">initialised by its <c>_init</c> function, or with struct_size set</param>
        /// <param name="structSize">sizeof the struct as the caller sees it</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_recording_desc_init(RecordingDesc* desc, uint structSize);

        /// <summary>From now on every call that can change the world is handed to desc-&gt;write with its arguments
        /// before it is carried out, and its status after it. At once: the world as it is, with the assets of its
        /// batches. May begin at any time. Takes 64 KiB of memory, some bytes for each asset, and while it begins a
        /// copy of the assets and a snapshot. When <c>write</c> refuses, the recording ends, a message is logged, and
        /// the world goes on.</summary>
        /// <param name="world">the world</param>
        /// <param name="desc">initialised by its <c>_init</c> function, or with struct_size set</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/> (also desc-&gt;write),
        /// <see cref="Status.StructSize"/>, <see cref="Status.InvalidArgument"/> (unknown flags; the world is being
        /// recorded; <c>write</c> has refused), <see cref="Status.OutOfMemory"/>.</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_record_start(IntPtr world, RecordingDesc* desc);

        /// <summary>Ends a recording.</summary>
        /// <param name="world">the world</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.InvalidArgument"/>
        /// (none is under way: also where <c>write</c> has refused).</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_world_record_stop(IntPtr world);
    }
}
