// SPDX-License-Identifier: MIT
using System;
using System.Runtime.InteropServices;
using System.Threading;

namespace LangevinRigid
{
    /// <summary>The work of a step for an <see cref="IJobSystem"/>. Indices stand for threads, which share the work among
    /// themselves.</summary>
    public sealed class JobTask
    {
        private static readonly object _lastRunLock = new object();
        private static IntPtr _lastRun;
        private static TaskFn _lastRunFn;

        private readonly TaskFn _run;
        private readonly IntPtr _task;
        private int _running;
        private volatile bool _closed;

        /// <summary>The number of indices.</summary>
        public int Count { get; private set; }

        internal object Token;
        internal bool IsEnqueued;

        internal JobTask(IntPtr run, IntPtr task, uint count)
        {
            _run = FunctionOf(run);
            _task = task;
            Count = (int)count;
        }

        /// <summary>Runs the indices from <paramref name="begin"/> to <paramref name="end"/> - 1. Any thread.</summary>
        /// <exception cref="InvalidOperationException">The step has ended: <see cref="IJobSystem.Finish"/> returned too early.</exception>
        public void Run(int begin, int end)
        {
            if (begin < 0 || end > Count) throw new ArgumentOutOfRangeException("end");
            if (begin >= end) return;
            Interlocked.Increment(ref _running);
            try
            {
                if (_closed) throw new InvalidOperationException("A job began after IJobSystem.Finish had returned: its world can be gone.");
                _run(_task, (uint)begin, (uint)end);
            }
            finally
            {
                Interlocked.Decrement(ref _running);
            }
        }

        /// <summary>Refuses new calls and waits for running ones: the library's task ends with the step.</summary>
        internal void Close()
        {
            _closed = true;
            Thread.MemoryBarrier();
            var spin = new SpinWait();
            while (Volatile.Read(ref _running) != 0) spin.SpinOnce();
        }

        // The library has a single such function; a second library in the process would have its own.
        private static TaskFn FunctionOf(IntPtr run)
        {
            lock (_lastRunLock)
            {
                if (_lastRun != run)
                {
                    _lastRunFn = (TaskFn)Marshal.GetDelegateForFunctionPointer(run, typeof(TaskFn));
                    _lastRun = run;
                }
                return _lastRunFn;
            }
        }
    }
}
