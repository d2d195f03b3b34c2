// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using System.Reflection;
using System.Runtime.InteropServices;
using System.Threading;
using LangevinRigid;

static unsafe class LifetimeTests
{
    public static void StaleIdsAreRefused()
    {
        using (var world = new World())
        {
            Batch batch = Scene.Batch(world, 4), other = Scene.Batch(world, 4);
            BodyId[] bodies = batch.CreateBodies(Scene.Bodies(3));
            world.DestroyBody(bodies[1]);
            Check.True(!world.IsValid(bodies[1]) && world.IsValid(bodies[0]) && !world.IsValid(default(BodyId)), "alive");
            Check.Status(Status.StaleBody, () => world.GetState(bodies[1]));
            Check.Status(Status.StaleBody, () => world.DestroyBodies(bodies));
            Check.True(world.IsValid(bodies[0]), "all or none");
            BodyId next = batch.CreateBody(BodyDesc.Create());
            Check.True(next != bodies[1] && !world.IsValid(bodies[1]), "a slot used again is another body");
            ColliderDesc sphere = ColliderDesc.Create();
            sphere.Kind = ColliderKind.Sphere;
            sphere.Size = new Float3(1, 0, 0);
            ColliderId collider = world.CreateCollider(sphere);
            world.DestroyCollider(collider);
            Check.True(!world.IsValid(collider), "alive");
            Check.Status(Status.StaleCollider, () => world.GetState(collider));
            BatchId id = other.Id;
            Check.True(world.IsValid(id), "a batch");
            other.Dispose();
            Check.True(!world.IsValid(id), "a batch that ended");
            WindSourceId source = world.AddGusts(GustsDesc.Create());
            Check.True(world.IsValid(source), "a source");
            world.RemoveWind(source);
            Check.True(!world.IsValid(source), "a source that was removed");
            Ray ray = Ray.Create();
            ray.Batch = id;
            Check.Status(Status.StaleBatch, () => world.RayCast(ray));
            Check.Throws<ObjectDisposedException>(() => other.CreateBody(BodyDesc.Create()), "a batch that has ended");
            other.Dispose();
        }
    }

    public static void DisposeTwiceIsNothing()
    {
        Asset asset = Scene.Leaf();
        var world = new World();
        Batch batch = world.CreateBatch(asset, 2);
        asset.Dispose();
        asset.Dispose();
        batch.CreateBody(BodyDesc.Create());
        world.Step(Scene.Frame, 1); // only the batch holds the asset
        batch.Dispose();
        batch.Dispose();
        world.Dispose();
        world.Dispose();
        batch.Dispose();
        Check.True(asset.IsDisposed && world.IsDisposed && batch.IsDisposed, "disposed");
    }

    // Every public member: without its check it would pass a pointer to freed memory to the library.
    public static void NothingIsUsedAfterDispose()
    {
        var world = new World();
        Batch batch = Scene.Batch(world, 2), ended = Scene.Batch(world, 2);
        ended.Dispose();
        Asset asset = Scene.Leaf();
        int members = AllThrow(ended, new object[] { batch });
        world.Dispose();
        asset.Dispose();
        members += AllThrow(world, new object[] { batch, Scene.Leaf() }) + AllThrow(batch, new object[] { batch }) + AllThrow(asset, null);
        Check.True(members > 100, "members tried: " + members);
        BatchDesc desc = BatchDesc.Create();
        using (var living = new World()) Check.Throws<ObjectDisposedException>(() => living.CreateBatch(asset, desc), "an asset disposed of");
    }

    static int AllThrow(object target, object[] given)
    {
        var harmless = new List<string> { "Dispose", "IsDisposed", "NoteChange", "ChangeCount", "World", "Id", "Capacity", "Equals",
            "GetHashCode", "GetType", "ToString" };
        int tried = 0;
        foreach (MethodInfo method in target.GetType().GetMethods(BindingFlags.Instance | BindingFlags.Public))
        {
            string name = method.Name.StartsWith("get_") ? method.Name.Substring(4) : method.Name;
            if (harmless.Contains(name)) continue;
            var arguments = new List<object>();
            bool possible = true;
            foreach (ParameterInfo parameter in method.GetParameters())
            {
                Type type = parameter.ParameterType;
                if (type.FullName.StartsWith("System.Span") || type.FullName.StartsWith("System.ReadOnlySpan")) possible = false;
                if (possible) arguments.Add(Some(type, given));
            }
            if (!possible || method.ReturnType.Name == "BatchData") continue; // reflection cannot hold ref structs
            try
            {
                method.Invoke(target, arguments.ToArray());
            }
            catch (TargetInvocationException e) when (e.InnerException is ObjectDisposedException)
            {
                ++tried;
                continue;
            }
            catch (TargetInvocationException e)
            {
                throw new Check.Failed(method + " after Dispose: " + e.InnerException);
            }
            throw new Check.Failed(method + " can be called after Dispose");
        }
        return tried;
    }

    static object Some(Type type, object[] given)
    {
        if (type.IsByRef) type = type.GetElementType();
        if (type.IsPointer) return IntPtr.Zero;
        if (type == typeof(WindGridDesc)) return new WindGridDesc { Frames = 1, Counts = new UInt3(1, 1, 1) };
        if (type == typeof(float[])) return new float[3];
        if (type == typeof(uint[])) return new uint[3];
        if (type == typeof(TransformFormat)) return TransformFormat.PositionQuaternion;
        if (type.IsArray) return Array.CreateInstance(type.GetElementType(), 1);
        if (given != null)
            foreach (object value in given)
                if (type.IsInstanceOfType(value)) return value;
        if (type == typeof(int)) return 1;
        return type.IsValueType ? Activator.CreateInstance(type) : null;
    }

    public static void WorldsThatNobodyHoldsAreFreed()
    {
        var allocator = new CountingAllocator();
        const int worlds = 20;
        InAThread(() =>
        {
            for (int i = 0; i < worlds; ++i)
            {
                var world = new World(WorldDesc.Create(), new WorldServices { Allocator = allocator });
                Scene.Batch(world, 10).CreateBody(BodyDesc.Create());
                world.SetWindField(query => GC.KeepAlive(allocator));
                world.Step(Scene.Frame, 1);
            }
        });
        for (int i = 0; i < 50 && allocator.Live > 0; ++i)
        {
            GC.Collect();
            GC.WaitForPendingFinalizers();
            InAThread(() => { });
        }
        Check.True(allocator.Total > worlds, "memory was taken: " + allocator.Total);
        // A word left on a stack can keep a world alive: the collector is conservative.
        Check.True(allocator.LiveWorlds <= 1, "finalized: " + allocator.LiveWorlds + " of " + worlds + " are left");
    }

    // Its own stack, which leaves nothing behind.
    static void InAThread(ThreadStart work)
    {
        var thread = new Thread(work);
        thread.Start();
        thread.Join();
    }

    public static void CollectionsMayComeAtAnyTime()
    {
        bool go = true;
        var collector = new Thread(() =>
        {
            while (Volatile.Read(ref go))
            {
                GC.Collect();
                Thread.Sleep(1);
            }
        });
        collector.Start();
        try
        {
            for (int i = 0; i < 40; ++i)
            {
                var allocator = new CountingAllocator();
                var services = new WorldServices { Allocator = allocator, Log = (level, text) => GC.Collect(0) };
                using (var world = new World(WorldDesc.Create(), services))
                {
                    Batch batch = Scene.Batch(world, 300);
                    batch.CreateBodies(Scene.Bodies(300));
                    world.SetWindField(query =>
                    {
                        if (query.Count % 3 == 0) GC.Collect(0);
                        var rubbish = new byte[1000];
                        query.Velocity(0)[0] = rubbish[5];
                    });
                    world.SetWater(WaterDesc.Create());
                    world.SetWaterField(query => GC.Collect(0));
                    for (int k = 0; k < 3; ++k) world.Step(Scene.Frame, 2);
                    Check.Throws<LangevinException>(() => batch.CreateBodies(Scene.Bodies(301)), "full");
                    IReadOnlyList<AssetFault> faults = Asset.Check(new byte[100]);
                    Check.True(faults.Count > 0, "faults");
                }
                Check.Equal(0, allocator.Live, "all memory is back");
            }
        }
        finally
        {
            Volatile.Write(ref go, false);
            collector.Join();
        }
    }

    public static void WhatAWorldHeldIsLetGo()
    {
        var references = new List<WeakReference>();
        InAThread(() =>
        {
            for (int i = 0; i < 10; ++i)
            {
                var services = new WorldServices { Allocator = new CountingAllocator() };
                references.Add(new WeakReference(services));
                new World(WorldDesc.Create(), services).Dispose();
                Check.Throws<LangevinException>(() => new World(default(WorldDesc), services), "no world");
            }
        });
        GC.Collect();
        GC.WaitForPendingFinalizers();
        GC.Collect();
        int left = 0;
        foreach (WeakReference reference in references)
            if (reference.IsAlive) ++left;
        Check.True(left <= 1, left + " of 10 are held");
    }

    public static void AssetsGiveTheirMemoryBack()
    {
        using (Asset one = Scene.Leaf())
        {
            MakeAssets(500);
            long before = Pages();
            MakeAssets(5000);
            long grown = (Pages() - before) * 4;
            Check.True(grown < 16000, "5,000 assets made and released leave " + grown + " kB");
        }
    }

    static void MakeAssets(int count)
    {
        byte[] bytes = Scene.BakedBytes();
        for (int i = 0; i < count; ++i) Asset.Load(bytes).Dispose();
    }

    static long Pages()
    {
        return long.Parse(System.IO.File.ReadAllText("/proc/self/statm").Split(' ')[1]);
    }

    public static void ASharedAssetLivesAsLongAsItsOwners()
    {
        Asset first = Scene.Leaf();
        Asset second = first.Share();
        first.Dispose();
        Check.True(second.Info.Mass > 0, "the other reference");
        second.Dispose();
        Check.Throws<ObjectDisposedException>(() => second.Share(), "none left");
    }
}

/// <summary>Counts allocations that are not released.</summary>
sealed class CountingAllocator : IWorldAllocator
{
    readonly Dictionary<IntPtr, ulong> _live = new Dictionary<IntPtr, ulong>();
    readonly Dictionary<IntPtr, IntPtr> _blocks = new Dictionary<IntPtr, IntPtr>();
    ulong _worldSize;

    public int Total { get; private set; }
    public int FailAfter { get; set; }
    public bool Throws { get; set; }
    public int Live { get { lock (_live) return _live.Count; } }

    /// <summary>Allocations of the size of the first one, which is a world.</summary>
    public int LiveWorlds
    {
        get
        {
            int count = 0;
            lock (_live)
                foreach (ulong size in _live.Values)
                    if (size == _worldSize) ++count;
            return count;
        }
    }

    public IntPtr Allocate(ulong size, ulong alignment)
    {
        lock (_live)
        {
            if (Throws) throw new NotSupportedException("no memory for tests");
            if (FailAfter > 0 && Total >= FailAfter) return IntPtr.Zero;
            if (Total++ == 0) _worldSize = size;
            IntPtr block = Marshal.AllocHGlobal((IntPtr)(long)(size + alignment));
            var memory = (IntPtr)((block.ToInt64() + (long)alignment - 1) & -(long)alignment);
            _live.Add(memory, size);
            _blocks.Add(memory, block);
            return memory;
        }
    }

    public void Release(IntPtr memory, ulong size, ulong alignment)
    {
        lock (_live)
        {
            if (_live[memory] != size) throw new InvalidOperationException("not the size that was asked for");
            Marshal.FreeHGlobal(_blocks[memory]);
            _live.Remove(memory);
            _blocks.Remove(memory);
            if (Throws) throw new NotSupportedException("thrown by Release");
        }
    }
}
