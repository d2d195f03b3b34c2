// SPDX-License-Identifier: MIT
// Written by bindings/generator/csharp.py from include/langevin_rigid.h: do not edit.
using System;
using System.Runtime.InteropServices;

namespace LangevinRigid
{
    /// <summary>Severity of a log message.</summary>
    public enum LogLevel : int
    {
        /// <summary>A call failed: the message names it and gives the reason.</summary>
        Error = 1,
        /// <summary>A call succeeded, but probably does not do what was meant.</summary>
        Warning = 2,
        /// <summary>The header's <c>LR_LOG_INFO</c>.</summary>
        Info = 3,
    }

    /// <summary>Instruction sets. All give the same bits, so force one only for tests and measurements.
    /// <see cref="SimdTarget.Auto"/> picks the best that the processor supports.</summary>
    public enum SimdTarget : int
    {
        /// <summary>The header's <c>LR_SIMD_AUTO</c>.</summary>
        Auto = 0,
        /// <summary>With SSE4.2, AES and PCLMUL: the minimum on x86-64.</summary>
        Sse4 = 1,
        /// <summary>The header's <c>LR_SIMD_AVX2</c>.</summary>
        Avx2 = 2,
        /// <summary>The header's <c>LR_SIMD_AVX512</c>.</summary>
        Avx512 = 3,
        /// <summary>The header's <c>LR_SIMD_NEON</c>.</summary>
        Neon = 4,
        /// <summary>The header's <c>LR_SIMD_WASM</c>.</summary>
        Wasm = 5,
        /// <summary>Plain C++, only in test builds.</summary>
        Plain = 6,
    }

    /// <summary>Handle of a batch.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public readonly struct BatchId : IEquatable<BatchId>
    {
        /// <summary>The number in the C API; 0 means none.</summary>
        public readonly uint Value;
        /// <summary>A handle from its number.</summary>
        public BatchId(uint value) { Value = value; }
        /// <summary>Whether this is no handle. The handle of a destroyed object is not null: calls refuse it as stale.</summary>
        public bool IsNull { get { return Value == 0; } }
        /// <inheritdoc/>
        public bool Equals(BatchId other) { return Value == other.Value; }
        /// <inheritdoc/>
        public override bool Equals(object other) { return other is BatchId && Equals((BatchId)other); }
        /// <inheritdoc/>
        public override int GetHashCode() { return Value.GetHashCode(); }
        /// <inheritdoc/>
        public override string ToString() { return "BatchId(0x" + Value.ToString("x") + ")"; }
        /// <summary>Whether the handles are equal.</summary>
        public static bool operator ==(BatchId left, BatchId right) { return left.Value == right.Value; }
        /// <summary>Whether the handles differ.</summary>
        public static bool operator !=(BatchId left, BatchId right) { return left.Value != right.Value; }
    }

    /// <summary>Handle of a body.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public readonly struct BodyId : IEquatable<BodyId>
    {
        /// <summary>The number in the C API; 0 means none.</summary>
        public readonly ulong Value;
        /// <summary>A handle from its number.</summary>
        public BodyId(ulong value) { Value = value; }
        /// <summary>Whether this is no handle. The handle of a destroyed object is not null: calls refuse it as stale.</summary>
        public bool IsNull { get { return Value == 0; } }
        /// <inheritdoc/>
        public bool Equals(BodyId other) { return Value == other.Value; }
        /// <inheritdoc/>
        public override bool Equals(object other) { return other is BodyId && Equals((BodyId)other); }
        /// <inheritdoc/>
        public override int GetHashCode() { return Value.GetHashCode(); }
        /// <inheritdoc/>
        public override string ToString() { return "BodyId(0x" + Value.ToString("x") + ")"; }
        /// <summary>Whether the handles are equal.</summary>
        public static bool operator ==(BodyId left, BodyId right) { return left.Value == right.Value; }
        /// <summary>Whether the handles differ.</summary>
        public static bool operator !=(BodyId left, BodyId right) { return left.Value != right.Value; }
    }

    /// <summary>Handle of a collider.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public readonly struct ColliderId : IEquatable<ColliderId>
    {
        /// <summary>The number in the C API; 0 means none.</summary>
        public readonly ulong Value;
        /// <summary>A handle from its number.</summary>
        public ColliderId(ulong value) { Value = value; }
        /// <summary>Whether this is no handle. The handle of a destroyed object is not null: calls refuse it as stale.</summary>
        public bool IsNull { get { return Value == 0; } }
        /// <inheritdoc/>
        public bool Equals(ColliderId other) { return Value == other.Value; }
        /// <inheritdoc/>
        public override bool Equals(object other) { return other is ColliderId && Equals((ColliderId)other); }
        /// <inheritdoc/>
        public override int GetHashCode() { return Value.GetHashCode(); }
        /// <inheritdoc/>
        public override string ToString() { return "ColliderId(0x" + Value.ToString("x") + ")"; }
        /// <summary>Whether the handles are equal.</summary>
        public static bool operator ==(ColliderId left, ColliderId right) { return left.Value == right.Value; }
        /// <summary>Whether the handles differ.</summary>
        public static bool operator !=(ColliderId left, ColliderId right) { return left.Value != right.Value; }
    }

    /// <summary>Handle of a wind source.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public readonly struct WindSourceId : IEquatable<WindSourceId>
    {
        /// <summary>The number in the C API; 0 means none.</summary>
        public readonly uint Value;
        /// <summary>A handle from its number.</summary>
        public WindSourceId(uint value) { Value = value; }
        /// <summary>Whether this is no handle. The handle of a destroyed object is not null: calls refuse it as stale.</summary>
        public bool IsNull { get { return Value == 0; } }
        /// <inheritdoc/>
        public bool Equals(WindSourceId other) { return Value == other.Value; }
        /// <inheritdoc/>
        public override bool Equals(object other) { return other is WindSourceId && Equals((WindSourceId)other); }
        /// <inheritdoc/>
        public override int GetHashCode() { return Value.GetHashCode(); }
        /// <inheritdoc/>
        public override string ToString() { return "WindSourceId(0x" + Value.ToString("x") + ")"; }
        /// <summary>Whether the handles are equal.</summary>
        public static bool operator ==(WindSourceId left, WindSourceId right) { return left.Value == right.Value; }
        /// <summary>Whether the handles differ.</summary>
        public static bool operator !=(WindSourceId left, WindSourceId right) { return left.Value != right.Value; }
    }

    /// <summary>
    /// <para>Runs the world's tasks on an engine's job system instead of on threads of its own:
    /// docs/reference/stepping.md. Set both functions or neither.</para>
    /// <para><c>enqueue</c> starts a task: call run(task, begin, end) for ranges that together cover each index from 0
    /// to count - 1 exactly once. Any split, order and threads will do, from one call for all indices to a
    /// parallel-for, and calls may be made inside <c>enqueue</c>. All must have returned when <c>finish</c> returns.
    /// The returned token is passed to <c>finish</c>; any value is allowed. <c>finish</c> waits for the task. It is
    /// called exactly once for each <c>enqueue</c>, on the same thread. While it waits, it should run calls that have
    /// not started: the stepping thread does its share of the work first, so these find nothing left to do and return
    /// at once.</para>
    /// <para>An index stands for a thread, not for a piece of work: tasks share out the work among themselves, so the
    /// split affects speed, never results. Both functions are called only during <see cref="Native.lr_world_step"/>, on
    /// the thread that called it and in that thread's floating-point mode; tasks set and restore their own. Neither may
    /// throw, longjmp, or call the library on the same world. Do not call run() after <c>finish</c>. A task needs 192
    /// KB of stack.</para>
    /// </summary>
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate void TaskFn(IntPtr task, uint begin, uint end);

    /// <summary>Receives a log message, valid during the call only. Called on the thread that calls the library; with
    /// <see cref="CheckFlags.Threads"/> possibly while another thread is inside a call on the world. Must not call the
    /// library on the same world. May be null.</summary>
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate void LogFn(IntPtr user, LogLevel level, byte* message);

    /// <summary>The function type of <c>Allocate</c> in a <see cref="Allocator"/>.</summary>
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate IntPtr AllocatorAllocateFn(IntPtr user, ulong size, ulong alignment);

    /// <summary>The function type of <c>Release</c> in a <see cref="Allocator"/>.</summary>
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate void AllocatorReleaseFn(IntPtr user, IntPtr memory, ulong size, ulong alignment);

    /// <summary>The allocator of a world. Set both functions, or neither to use the C library's. <c>Allocate</c>
    /// returns <c>size</c> bytes aligned to <c>alignment</c> (a power of two, at most 128), or null. <c>Release</c>
    /// receives the same size and alignment as the matching <c>Allocate</c>. Both are called only on the thread that
    /// calls the library. <see cref="Native.lr_world_step"/> calls them only when more bodies touch each other than
    /// ever before (<see cref="Native.lr_batch_set_body_contact"/>). Neither may call the library on the same
    /// world.</summary>
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

    /// <summary>The function type of <c>Enqueue</c> in a <see cref="JobSystem"/>.</summary>
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    public unsafe delegate IntPtr JobSystemEnqueueFn(IntPtr user, IntPtr run, IntPtr task, uint count);

    /// <summary>The function type of <c>Finish</c> in a <see cref="JobSystem"/>.</summary>
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
