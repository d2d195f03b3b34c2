// SPDX-License-Identifier: MIT
// Written by bindings/generator/csharp.py from include/langevin_rigid.h: change those.
using System;
using System.Runtime.InteropServices;

namespace LangevinRigid
{
    /// <summary>How much a message of the library matters.</summary>
    public enum LogLevel : int
    {
        /// <summary>A call failed: the message says which, and why.</summary>
        Error = 1,
        /// <summary>A call succeeded, but probably not as meant.</summary>
        Warning = 2,
        /// <summary>The header's <c>LR_LOG_INFO</c>.</summary>
        Info = 3,
    }

    /// <summary>Instruction sets, best first within a family. <see cref="SimdTarget.Auto"/> picks the best that the
    /// processor has. All of them give the same bits: forcing one is for tests and measurements.</summary>
    public enum SimdTarget : int
    {
        /// <summary>The header's <c>LR_SIMD_AUTO</c>.</summary>
        Auto = 0,
        /// <summary>With SSE4.2, AES and PCLMUL: the least that an x86-64 processor must have.</summary>
        Sse4 = 1,
        /// <summary>The header's <c>LR_SIMD_AVX2</c>.</summary>
        Avx2 = 2,
        /// <summary>The header's <c>LR_SIMD_AVX512</c>.</summary>
        Avx512 = 3,
        /// <summary>The header's <c>LR_SIMD_NEON</c>.</summary>
        Neon = 4,
        /// <summary>The header's <c>LR_SIMD_WASM</c>.</summary>
        Wasm = 5,
        /// <summary>Plain C++, in builds for tests alone.</summary>
        Plain = 6,
    }

    /// <summary>Handles are values. 0 is never a valid handle. A handle to something destroyed is recognised, not
    /// followed.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public readonly struct BatchId : IEquatable<BatchId>
    {
        /// <summary>As the library sees it; 0 is none.</summary>
        public readonly uint Value;
        /// <summary>From a number that was a handle before.</summary>
        public BatchId(uint value) { Value = value; }
        /// <summary>Whether it is no handle at all. One of something destroyed is not null: calls refuse it as stale.</summary>
        public bool IsNull { get { return Value == 0; } }
        /// <inheritdoc/>
        public bool Equals(BatchId other) { return Value == other.Value; }
        /// <inheritdoc/>
        public override bool Equals(object other) { return other is BatchId && Equals((BatchId)other); }
        /// <inheritdoc/>
        public override int GetHashCode() { return Value.GetHashCode(); }
        /// <inheritdoc/>
        public override string ToString() { return "BatchId(0x" + Value.ToString("x") + ")"; }
        /// <summary>Whether both are the same.</summary>
        public static bool operator ==(BatchId left, BatchId right) { return left.Value == right.Value; }
        /// <summary>Whether they differ.</summary>
        public static bool operator !=(BatchId left, BatchId right) { return left.Value != right.Value; }
    }

    /// <summary>Batch, generation and slot in one; compare for equality only.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public readonly struct BodyId : IEquatable<BodyId>
    {
        /// <summary>As the library sees it; 0 is none.</summary>
        public readonly ulong Value;
        /// <summary>From a number that was a handle before.</summary>
        public BodyId(ulong value) { Value = value; }
        /// <summary>Whether it is no handle at all. One of something destroyed is not null: calls refuse it as stale.</summary>
        public bool IsNull { get { return Value == 0; } }
        /// <inheritdoc/>
        public bool Equals(BodyId other) { return Value == other.Value; }
        /// <inheritdoc/>
        public override bool Equals(object other) { return other is BodyId && Equals((BodyId)other); }
        /// <inheritdoc/>
        public override int GetHashCode() { return Value.GetHashCode(); }
        /// <inheritdoc/>
        public override string ToString() { return "BodyId(0x" + Value.ToString("x") + ")"; }
        /// <summary>Whether both are the same.</summary>
        public static bool operator ==(BodyId left, BodyId right) { return left.Value == right.Value; }
        /// <summary>Whether they differ.</summary>
        public static bool operator !=(BodyId left, BodyId right) { return left.Value != right.Value; }
    }

    /// <summary>
    /// <para>Tasks of an engine's job system, in place of the world's own threads: docs/reference/stepping.md. Both
    /// functions are given or neither.</para>
    /// <para><c>enqueue</c> has run(task, begin, end) called for ranges that together hold each of the indices 0 to
    /// count - 1 once, in any order, on any threads, at any time from now on until <c>finish</c> returns: one call for
    /// all, one for each, or what a parallel-for makes of it, also right away inside <c>enqueue</c>. It returns a token
    /// for <c>finish</c>, of any value. <c>finish</c> returns when all of these calls have returned. It is called
    /// exactly once for each <c>enqueue</c>, by the same thread. Its thread had best run what has not begun itself: the
    /// world's caller does its share first, so that late tasks find nothing left to do, and return at once.</para>
    /// <para>Indices stand for threads, not for pieces of work, which the tasks share out among themselves: how they
    /// are spread changes speed, never results. Both are called within <see cref="Native.lr_world_step"/> alone, by its
    /// thread, in the floating-point mode that it came with; tasks set and restore their own. Neither may throw,
    /// longjmp, or call the library on the same world; nor may run() be called after <c>finish</c>.</para>
    /// </summary>
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate void TaskFn(IntPtr task, uint begin, uint end);

    /// <summary>Receives a message, valid during the call only. Called from the thread that calls the library: with
    /// <see cref="WorldChecks.Threads"/> also while another thread's call on the world goes on. Must not call the
    /// library on the same world. May be null.</summary>
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate void LogFn(IntPtr user, LogLevel level, byte* message);

    /// <summary>What <c>Allocate</c> of a <see cref="Allocator"/> points to.</summary>
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate IntPtr AllocatorAllocateFn(IntPtr user, ulong size, ulong alignment);

    /// <summary>What <c>Release</c> of a <see cref="Allocator"/> points to.</summary>
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate void AllocatorReleaseFn(IntPtr user, IntPtr memory, ulong size, ulong alignment);

    /// <summary>Where a world takes its memory from. Both functions are given or neither; neither means the C
    /// library's. <c>Allocate</c> returns <c>size</c> bytes aligned to <c>alignment</c> (a power of two, at most 128),
    /// or null. <c>Release</c> gets the very size and alignment that were asked for. Called only from the thread that
    /// calls the library, during <see cref="Native.lr_world_step"/> only where bodies meet each other
    /// (<see cref="Native.lr_batch_set_pair_contact"/>) in greater number than ever before. Must not call the library
    /// on the same world.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct Allocator
    {
        /// <summary>User.</summary>
        public IntPtr User;
        /// <summary>Function pointer of a <see cref="AllocatorAllocateFn"/>.</summary>
        public IntPtr Allocate;
        /// <summary>Function pointer of a <see cref="AllocatorReleaseFn"/>.</summary>
        public IntPtr Release;
    }

    /// <summary>What <c>Enqueue</c> of a <see cref="JobSystem"/> points to.</summary>
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate IntPtr JobSystemEnqueueFn(IntPtr user, IntPtr run, IntPtr task, uint count);

    /// <summary>What <c>Finish</c> of a <see cref="JobSystem"/> points to.</summary>
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate void JobSystemFinishFn(IntPtr user, IntPtr token);

    /// <summary>The header's <c>struct lr_job_system</c>.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public unsafe partial struct JobSystem
    {
        /// <summary>User.</summary>
        public IntPtr User;
        /// <summary>Function pointer of a <see cref="JobSystemEnqueueFn"/>.</summary>
        public IntPtr Enqueue;
        /// <summary>Function pointer of a <see cref="JobSystemFinishFn"/>.</summary>
        public IntPtr Finish;
    }
}
