// SPDX-License-Identifier: MIT
using System;

namespace LangevinRigid
{
    /// <summary>Receives a world's log messages, on the thread that calls it.</summary>
    public delegate void LogHandler(LogLevel level, string message);

    /// <summary>A wind field of the program's own: writes velocities, and if they are known rates and gradients, through the pointers of
    /// the query, which are valid during the call only. Called by several threads at a time if the world has workers. What it
    /// throws ends neither the step nor the process: it is thrown again by <see cref="World.Step"/>, after the step.</summary>
    public delegate void WindField(WindQuery query);

    /// <summary>The program's own water surface, with the same rules as <see cref="WindField"/>.</summary>
    public delegate void WaterField(WaterQuery query);

    /// <summary>The allocator of a world. Called on the thread that calls the world; the memory must not move.</summary>
    public interface IWorldAllocator
    {
        /// <summary>Returns <paramref name="size"/> bytes aligned to <paramref name="alignment"/>, a power of two, at most 128; or
        /// <see cref="IntPtr.Zero"/>, which makes the call fail with <see cref="Status.OutOfMemory"/>.</summary>
        IntPtr Allocate(ulong size, ulong alignment);

        /// <summary>Gets the very size and alignment that were asked for. Called from the finalizer's thread for a world that nobody has
        /// disposed of.</summary>
        void Release(IntPtr memory, ulong size, ulong alignment);
    }

    /// <summary>A job system for the steps of worlds, instead of their own threads. docs/reference/stepping.md</summary>
    public interface IJobSystem
    {
        /// <summary>Has <see cref="JobTask.Run"/> called for ranges that together hold each index below <see cref="JobTask.Count"/> once, on
        /// any threads, until <see cref="Finish"/> returns. Returns what <see cref="Finish"/> is to be given.</summary>
        object Enqueue(JobTask task);

        /// <summary>Returns when all these calls have returned.</summary>
        void Finish(object token);
    }

    /// <summary>The program's callbacks of a world. All may be null.</summary>
    public sealed class WorldServices
    {
        /// <summary>Receives messages. Without it the world is silent; exceptions contain the last error anyway.</summary>
        public LogHandler Log { get; set; }
        /// <summary>Null: the C library's.</summary>
        public IWorldAllocator Allocator { get; set; }
        /// <summary>Null: <see cref="WorldDesc.WorkerCount"/> threads of the world's own. With one, a count of 0 is taken as one less
        /// than the machine has threads, and the log warns of the guess.</summary>
        public IJobSystem Jobs { get; set; }
    }
}
