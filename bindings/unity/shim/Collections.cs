// SPDX-License-Identifier: MIT
using System;
using System.Runtime.InteropServices;

namespace Unity.Collections
{
    public enum Allocator { Invalid, None, Temp, TempJob, Persistent, AudioKernel }
    public enum NativeArrayOptions { UninitializedMemory, ClearMemory }

    // Like the engine's with collections checks: detects bad indices, use after Dispose and double Dispose, and counts undisposed arrays.
    public unsafe struct NativeArray<T> : IDisposable where T : struct
    {
        internal void* Memory;
        private int length;
        private NativeArrayCheck check;
        private bool view;

        public NativeArray(int length, Allocator allocator) : this(length, allocator, NativeArrayOptions.ClearMemory) { }

        public NativeArray(int length, Allocator allocator, NativeArrayOptions options)
        {
            if (allocator <= Allocator.None) throw new ArgumentException("Allocator must be Temp, TempJob or Persistent", "allocator");
            if (length < 0) throw new ArgumentOutOfRangeException("length");
            int bytes = Math.Max(1, length * Marshal.SizeOf(typeof(T)));
            Memory = (void*)Marshal.AllocHGlobal(bytes);
            for (int i = 0; i < bytes; ++i) ((byte*)Memory)[i] = options == NativeArrayOptions.ClearMemory ? (byte)0 : (byte)0xcd;
            this.length = length;
            check = new NativeArrayCheck();
            view = false;
            ++NativeArrayCheck.Living;
        }

        internal void Check()
        {
            if (check == null || check.Disposed) throw new ObjectDisposedException("The NativeArray has been disposed or was never allocated");
        }

        public bool IsCreated { get { return Memory != null; } }
        public int Length { get { return length; } }

        public T this[int index]
        {
            get { Check(); Range(index); return (T)Marshal.PtrToStructure((IntPtr)At(index), typeof(T)); }
            set { Check(); Range(index); Marshal.StructureToPtr(value, (IntPtr)At(index), false); }
        }

        private byte* At(int index) { return (byte*)Memory + (long)index * Marshal.SizeOf(typeof(T)); }

        private void Range(int index)
        {
            if ((uint)index >= (uint)length) throw new IndexOutOfRangeException("Index " + index + " is out of range of '" + length + "' Length.");
        }

        public NativeArray<U> Reinterpret<U>(int expectedTypeSize) where U : struct
        {
            Check();
            if (expectedTypeSize != Marshal.SizeOf(typeof(T))) throw new InvalidOperationException("Type was expected to be " + expectedTypeSize);
            long bytes = (long)length * expectedTypeSize;
            int size = Marshal.SizeOf(typeof(U));
            if (bytes % size != 0) throw new InvalidOperationException("The array length is not a multiple of the new type's size");
            return new NativeArray<U>(Memory, (int)(bytes / size), check);
        }

        internal NativeArray(void* memory, int length, NativeArrayCheck check)
        {
            Memory = memory;
            this.length = length;
            this.check = check;
            view = true;
        }

        public void Dispose()
        {
            Check();
            if (view) throw new InvalidOperationException("The NativeArray can not be Disposed because it was not allocated with a valid allocator.");
            check.Disposed = true;
            --NativeArrayCheck.Living;
            Marshal.FreeHGlobal((IntPtr)Memory);
            Memory = null;
            length = 0;
        }
    }

    // Not in the engine.
    public sealed class NativeArrayCheck
    {
        public static int Living;
        public bool Disposed;
    }
}

namespace Unity.Collections.LowLevel.Unsafe
{
    [AttributeUsage(AttributeTargets.Field)]
    public sealed class NativeDisableUnsafePtrRestrictionAttribute : Attribute { }

    public static unsafe class NativeArrayUnsafeUtility
    {
        public static void* GetUnsafePtr<T>(this NativeArray<T> array) where T : struct { array.Check(); return array.Memory; }
        public static void* GetUnsafeReadOnlyPtr<T>(this NativeArray<T> array) where T : struct { array.Check(); return array.Memory; }
    }

    public static unsafe class UnsafeUtility
    {
        public static void* Malloc(long size, int alignment, Allocator allocator) { return (void*)Marshal.AllocHGlobal((IntPtr)Math.Max(1L, size)); }
        public static void Free(void* memory, Allocator allocator) { Marshal.FreeHGlobal((IntPtr)memory); }
    }
}

namespace Unity.Jobs
{
    public interface IJob { void Execute(); }

    public interface IJobParallelFor { void Execute(int index); }

    public struct JobHandle
    {
        internal System.Threading.Tasks.Task Task;
        public void Complete() { if (Task != null) Task.Wait(); Task = null; }
        public static void ScheduleBatchedJobs() { }
    }

    // On its own thread, so that tests detect forbidden concurrency.
    public static class IJobExtensions
    {
        public static JobHandle Schedule<T>(this T jobData, JobHandle dependsOn = default(JobHandle)) where T : struct, IJob
        {
            return new JobHandle { Task = System.Threading.Tasks.Task.Run(() => jobData.Execute()) };
        }
    }

    public static class IJobParallelForExtensions
    {
        public static JobHandle Schedule<T>(this T jobData, int arrayLength, int innerloopBatchCount, JobHandle dependsOn = default(JobHandle))
            where T : struct, IJobParallelFor
        {
            return new JobHandle { Task = System.Threading.Tasks.Task.Run(() => { for (int i = arrayLength; i-- > 0;) jobData.Execute(i); }) };
        }
    }
}
