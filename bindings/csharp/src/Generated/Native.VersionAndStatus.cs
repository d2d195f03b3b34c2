// SPDX-License-Identifier: MIT
// Written by bindings/generator/csharp.py from include/langevin_rigid.h: change those.
using System;
using System.Runtime.InteropServices;

namespace LangevinRigid
{
    public static unsafe partial class Native
    {
        /// <summary>
        /// <para>Version of the library that is loaded: major &lt;&lt; 22 | minor &lt;&lt; 12 | patch. Compare it with
        /// the macros above when the library is loaded at run time: a different major, or before 1.0 a different minor,
        /// is another ABI.</para>
        /// <para>Any thread.</para>
        /// </summary>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern uint lr_version();

        /// <summary>
        /// <para>A short English phrase for a status, no full stop; never null; static storage. Unknown values give
        /// "unknown status".</para>
        /// <para>Any thread.</para>
        /// </summary>
        /// <param name="status">status</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern byte* lr_status_string(Status status);
    }
}
