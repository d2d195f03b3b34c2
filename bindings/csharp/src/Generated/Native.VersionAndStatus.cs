// SPDX-License-Identifier: MIT
// Written by bindings/generator/csharp.py from include/langevin_rigid.h: do not edit.
using System;
using System.Runtime.InteropServices;

namespace LangevinRigid
{
    public static unsafe partial class Native
    {
        /// <summary>
        /// <para>Version of the loaded library: major &lt;&lt; 22 | minor &lt;&lt; 12 | patch. Compare it with the
        /// macros above when you load the library at run time. A different major version has a different ABI; before
        /// 1.0, so has a different minor version.</para>
        /// <para>Any thread.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern uint lr_version();

        /// <summary>
        /// <para>A short English phrase for a status, without a full stop. Unknown values give "unknown status". Never
        /// null; static storage.</para>
        /// <para>Any thread.</para>
        /// </summary>
        /// <param name="status">status</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern byte* lr_status_string(Status status);

        /// <summary>
        /// <para>The text of the calling thread's last failed call: the function and the reason, as the log has it.
        /// Calls that succeed leave it alone. Never null, empty before the first failure, cut after 255 bytes. Valid
        /// until the thread's next failed call.</para>
        /// <para>Any thread.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern byte* lr_last_error();
    }
}
