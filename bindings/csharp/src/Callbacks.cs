// SPDX-License-Identifier: MIT
using System;

namespace LangevinRigid
{
    /// <summary>Receives a world's log messages, on the thread that calls it.</summary>
    public delegate void LogHandler(LogLevel level, string message);

    /// <summary>A wind field of the program. It writes velocities, and rates and gradients if it knows them, through the query's pointers, which
    /// are valid only during the call. With workers, several threads call it at a time. Its exceptions end neither the step nor
    /// the process: <see cref="World.Step"/> rethrows the first after the step.</summary>
    public delegate void WindField(WindQuery query);

    /// <summary>A water surface of the program, with the same rules as <see cref="WindField"/>.</summary>
    public delegate void WaterField(WaterQuery query);

    /// <summary>The allocator of a world. Called on the thread that calls the world; the memory must not move.</summary>
    public interface IWorldAllocator
    {
        /// <summary>Returns <paramref name="size"/> bytes aligned to <paramref name="alignment"/>, a power of two, at most 128; or
        /// <see cref="IntPtr.Zero"/>, which makes the call fail with <see cref="Status.OutOfMemory"/>.</summary>
        IntPtr Allocate(ulong size, ulong alignment);

        /// <summary>Receives the size and alignment of the allocation. The finalizer's thread calls it for a world that was not disposed
        /// of.</summary>
        void Release(IntPtr memory, ulong size, ulong alignment);
    }

    /// <summary>A job system for the steps of worlds, instead of their own threads. docs/reference/stepping.md</summary>
    public interface IJobSystem
    {
        /// <summary>Starts calls of <see cref="JobTask.Run"/> for ranges that together hold each index below <see cref="JobTask.Count"/> once, on
        /// any threads, until <see cref="Finish"/> returns. Returns a token for <see cref="Finish"/>.</summary>
        object Enqueue(JobTask task);

        /// <summary>Waits until all these calls have returned.</summary>
        void Finish(object token);
    }

    /// <summary>The program's callbacks for a world. All can be null.</summary>
    public sealed class WorldServices
    {
        /// <summary>Receives messages. Without it the world does not log, but exceptions contain the last error.</summary>
        public LogHandler Log { get; set; }
        /// <summary>Null: the allocator of the C library.</summary>
        public IWorldAllocator Allocator { get; set; }
        /// <summary>Null: <see cref="WorldDesc.WorkerCount"/> threads of the world. With a job system, a count of 0 means one less than the
        /// machine's threads, and the log warns of this guess.</summary>
        public IJobSystem Jobs { get; set; }
    }
}
