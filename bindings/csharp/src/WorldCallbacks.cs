// SPDX-License-Identifier: MIT
using System;
using System.Runtime.ExceptionServices;
using System.Runtime.InteropServices;
using System.Threading;

namespace LangevinRigid
{
    /// <summary>The callbacks of a world for native code. It lives as long as the native world, also while a finalizer destroys that. Hence it
    /// must not refer to the <see cref="World"/>, which could then never be finalized.</summary>
    internal sealed unsafe class WorldCallbacks
    {
        private readonly WorldServices _services;
        private GCHandle _self;
        private ExceptionDispatchInfo _thrown;

        public WindField Wind;
        public WaterField Surface;
        public System.IO.Stream Recording;
        /// <summary>The last error of the current call, or of the last one.</summary>
        public string LastError;

        public WorldCallbacks(WorldServices services)
        {
            _services = services;
            _self = GCHandle.Alloc(this);
        }

        public IntPtr User { get { return GCHandle.ToIntPtr(_self); } }

        public void Free()
        {
            if (_self.IsAllocated) _self.Free();
        }

        public void Register(ref WorldDesc desc)
        {
            desc.Log = Pointers.Log;
            desc.LogUser = User;
            if (_services.Allocator != null)
            {
                desc.Allocator.User = User;
                desc.Allocator.Allocate = Pointers.Allocate;
                desc.Allocator.Release = Pointers.Release;
            }
            if (_services.Jobs != null)
            {
                desc.Jobs.User = User;
                desc.Jobs.Enqueue = Pointers.Enqueue;
                desc.Jobs.Finish = Pointers.Finish;
            }
        }

        /// <summary>Rethrows the exception of a callback after its call has ended.</summary>
        public void Rethrow()
        {
            ExceptionDispatchInfo thrown = Interlocked.Exchange(ref _thrown, null);
            if (thrown != null) thrown.Throw();
        }

        // Keeps the first exception: those of other threads in the same step most often have the same cause.
        private void Keep(Exception exception)
        {
            Interlocked.CompareExchange(ref _thrown, ExceptionDispatchInfo.Capture(exception), null);
        }

        private static WorldCallbacks Of(IntPtr user)
        {
            return (WorldCallbacks)GCHandle.FromIntPtr(user).Target;
        }

        /// <summary>Function pointers to the methods below; their delegates are kept forever.</summary>
        public static class Pointers
        {
            private static readonly LogFn _log = OnLog;
            private static readonly AllocatorAllocateFn _allocate = OnAllocate;
            private static readonly AllocatorReleaseFn _release = OnRelease;
            private static readonly JobSystemEnqueueFn _enqueue = OnEnqueue;
            private static readonly JobSystemFinishFn _finish = OnFinish;
            private static readonly WindFn _wind = OnWind;
            private static readonly WaterFn _surface = OnWater;
            private static readonly RecordFn _record = OnRecord;

            public static readonly IntPtr Log = Marshal.GetFunctionPointerForDelegate(_log);
            public static readonly IntPtr Allocate = Marshal.GetFunctionPointerForDelegate(_allocate);
            public static readonly IntPtr Release = Marshal.GetFunctionPointerForDelegate(_release);
            public static readonly IntPtr Enqueue = Marshal.GetFunctionPointerForDelegate(_enqueue);
            public static readonly IntPtr Finish = Marshal.GetFunctionPointerForDelegate(_finish);
            public static readonly IntPtr Wind = Marshal.GetFunctionPointerForDelegate(_wind);
            public static readonly IntPtr Surface = Marshal.GetFunctionPointerForDelegate(_surface);
            public static readonly IntPtr Record = Marshal.GetFunctionPointerForDelegate(_record);
        }

        [MonoPInvokeCallback(typeof(LogFn))]
        private static void OnLog(IntPtr user, LogLevel level, byte* message)
        {
            WorldCallbacks self = Of(user);
            try
            {
                string text = Utf8.Read(message);
                if (level == LogLevel.Error) self.LastError = text;
                LogHandler log = self._services.Log;
                if (log != null) log(level, text);
            }
            catch (Exception e)
            {
                self.Keep(e);
            }
        }

        [MonoPInvokeCallback(typeof(AllocatorAllocateFn))]
        private static IntPtr OnAllocate(IntPtr user, ulong size, ulong alignment)
        {
            WorldCallbacks self = Of(user);
            try
            {
                return self._services.Allocator.Allocate(size, alignment);
            }
            catch (Exception e)
            {
                self.Keep(e);
                return IntPtr.Zero;
            }
        }

        [MonoPInvokeCallback(typeof(AllocatorReleaseFn))]
        private static void OnRelease(IntPtr user, IntPtr memory, ulong size, ulong alignment)
        {
            WorldCallbacks self = Of(user);
            try
            {
                self._services.Allocator.Release(memory, size, alignment);
            }
            catch (Exception e)
            {
                self.Keep(e);
            }
        }

        [MonoPInvokeCallback(typeof(JobSystemEnqueueFn))]
        private static IntPtr OnEnqueue(IntPtr user, IntPtr run, IntPtr task, uint count)
        {
            WorldCallbacks self = Of(user);
            try
            {
                var job = new JobTask(run, task, count);
                IntPtr token = GCHandle.ToIntPtr(GCHandle.Alloc(job));
                try
                {
                    job.Token = self._services.Jobs.Enqueue(job);
                    job.IsEnqueued = true;
                }
                catch (Exception e)
                {
                    self.Keep(e); // the calling thread does all the work
                }
                return token;
            }
            catch (Exception e)
            {
                self.Keep(e);
                return IntPtr.Zero;
            }
        }

        [MonoPInvokeCallback(typeof(JobSystemFinishFn))]
        private static void OnFinish(IntPtr user, IntPtr token)
        {
            if (token == IntPtr.Zero) return;
            WorldCallbacks self = Of(user);
            GCHandle handle = GCHandle.FromIntPtr(token);
            var job = (JobTask)handle.Target;
            handle.Free();
            try
            {
                if (job.IsEnqueued) self._services.Jobs.Finish(job.Token);
            }
            catch (Exception e)
            {
                self.Keep(e);
            }
            job.Close();
        }

        [MonoPInvokeCallback(typeof(WindFn))]
        private static void OnWind(IntPtr user, WindQuery* query)
        {
            WorldCallbacks self = Of(user);
            try
            {
                self.Wind(*query);
            }
            catch (Exception e)
            {
                self.Keep(e);
            }
        }

        [MonoPInvokeCallback(typeof(RecordFn))]
        private static int OnRecord(IntPtr user, IntPtr bytes, ulong size)
        {
            WorldCallbacks self = Of(user);
            try
            {
                var piece = new byte[Math.Min(size, 65536)];
                for (ulong done = 0; done < size; done += (ulong)piece.Length)
                {
                    var count = (int)Math.Min(size - done, (ulong)piece.Length);
                    Marshal.Copy((IntPtr)((byte*)bytes + done), piece, 0, count);
                    self.Recording.Write(piece, 0, count);
                }
                return 0;
            }
            catch (Exception e)
            {
                self.Keep(e);
                return 1;
            }
        }

        [MonoPInvokeCallback(typeof(WaterFn))]
        private static void OnWater(IntPtr user, WaterQuery* query)
        {
            WorldCallbacks self = Of(user);
            try
            {
                self.Surface(*query);
            }
            catch (Exception e)
            {
                self.Keep(e);
            }
        }
    }
}
