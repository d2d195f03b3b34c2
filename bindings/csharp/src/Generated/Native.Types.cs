// SPDX-License-Identifier: MIT
// Written by bindings/generator/csharp.py from include/langevin_rigid.h: do not edit.
using System;
using System.Runtime.InteropServices;

namespace LangevinRigid
{
    public static unsafe partial class Native
    {
        /// <summary>
        /// <para>Lists the instruction sets that this build contains and this processor supports, best first.</para>
        /// <para>Any thread.</para>
        /// </summary>
        /// <param name="targets">receives up to <paramref name="capacity"/> values; may be null when capacity is
        /// 0.</param>
        /// <param name="capacity">number of elements that fit</param>
        /// <param name="count">receives the full number, even if it exceeds capacity.</param>
        /// <returns><see cref="Status.Ok"/>, <see cref="Status.NullArgument"/>, <see cref="Status.BufferTooSmall"/>
        /// (count is set).</returns>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern Status lr_simd_targets(SimdTarget* targets, uint capacity, uint* count);

        /// <summary>
        /// <para>A display name: "AVX-512", "AVX2", "SSE4", "NEON", "WebAssembly", "plain", "auto" or "unknown". Never
        /// null; static storage.</para>
        /// <para>Any thread.</para>
        /// </summary>
        /// <param name="target">target</param>
        [DllImport(Library, CallingConvention = CallingConvention.Cdecl, ExactSpelling = true)]
        public static extern byte* lr_simd_target_name(SimdTarget target);
    }
}
