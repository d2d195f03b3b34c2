// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using System.Threading;
using LangevinRigid;

static unsafe class CallbackTests
{
    static World With(WorldServices services, uint workers = 0)
    {
        WorldDesc desc = WorldDesc.Create();
        desc.WorkerCount = workers;
        return new World(desc, services);
    }

    public static void MessagesArrive()
    {
        var messages = new List<string>();
        using (World world = With(new WorldServices { Log = (level, text) => messages.Add(level + ": " + text) }))
        {
            LangevinException e = Check.Status(Status.InvalidArgument, () => world.SetUniformWind(new Float3(2000, 0, 0)));
            Check.Equal(1, messages.Count, "messages");
            Check.True(messages[0].StartsWith("Error: ") && e.Detail.Length > 5 && messages[0].EndsWith(e.Detail), messages[0]);
            Check.True(e.Detail.StartsWith("lr_world_set_uniform_wind: ") && e.Message.EndsWith(e.Detail.Substring(27)), e.Message);
        }
        using (var silent = new World())
            Check.True(Check.Status(Status.InvalidArgument, () => silent.SetUniformWind(new Float3(2000, 0, 0))).Detail.Length > 5, "also without a log");
    }

    public static void AnErrorIsNotToldTwice()
    {
        using (var world = new World())
        {
            Check.Status(Status.InvalidArgument, () => world.SetUniformWind(new Float3(2000, 0, 0)));
            Check.True(!world.IsValid(default(BodyId)), "no body");
            LangevinException e = Check.Status(Status.TimestepZero, () => world.Step(0.0f));
            Check.True(!e.Message.Contains("wind"), e.Message);
        }
    }

    public static void MemoryComesFromTheAllocator()
    {
        var allocator = new CountingAllocator();
        using (World world = With(new WorldServices { Allocator = allocator }))
        {
            Scene.Batch(world, 1000).CreateBodies(Scene.Bodies(1000));
            int before = allocator.Total;
            for (int i = 0; i < 5; ++i) world.Step(Scene.Frame, 2);
            Check.Equal(before, allocator.Total, "a step allocates nothing");
            Check.True(world.Info.MemoryBytes > 1000 * 50, "bytes");
        }
        Check.True(allocator.Total > 1, "used");
        Check.Equal(0, allocator.Live, "all is back");
    }

    public static void AllocatorsMayFailAndThrow()
    {
        var allocator = new CountingAllocator { FailAfter = 1 };
        Check.Status(Status.OutOfMemory, () => { using (World world = With(new WorldServices { Allocator = allocator })) Scene.Batch(world, 10); });
        allocator.FailAfter = 0;
        allocator.Throws = true;
        Exception e = Check.Throws<NotSupportedException>(() => With(new WorldServices { Allocator = allocator }), "while a world is created");
        Check.True(e.Message.Contains("no memory for tests"), e.Message);
        allocator.Throws = false;
        World late = With(new WorldServices { Allocator = allocator });
        Batch batch = Scene.Batch(late, 10);
        allocator.Throws = true;
        Check.Throws<NotSupportedException>(() => batch.Dispose(), "while a batch is destroyed");
        Check.True(batch.IsDisposed && !late.IsValid(batch.Id), "it is destroyed");
        batch.Dispose();
        Check.Throws<NotSupportedException>(() => late.Dispose(), "while it is destroyed");
        Check.True(late.IsDisposed, "it is destroyed");
        Check.Equal(0, allocator.Live, "all is back");
    }

    public static void AWindFieldMovesBodies()
    {
        using (var world = new World())
        {
            Batch batch = Scene.Batch(world, 600);
            batch.CreateBodies(Scene.Bodies(600));
            int asked = 0;
            world.SetWindField(query =>
            {
                asked += (int)query.Count;
                Check.Equal(batch.Id, query.Batch.IsNull ? batch.Id : query.Batch, "whose bodies");
                for (int i = 0; i < query.Count; ++i)
                {
                    query.Velocity(0)[i] = query.Position(1)[i] > -1000.0f ? 5.0f : 0.0f;
                    query.Gradient(0, 1)[i] = 0.0f;
                    query.Rate(2)[i] = 0.0f;
                }
            });
            GC.Collect();
            Check.Near(5.0, world.SampleWind(new Float3(1, 2, 3)).X, 1e-6, "asked for a sample");
            for (int i = 0; i < 30; ++i) world.Step(Scene.Frame, 2);
            Check.Equal(600 * 60 + 1, asked, "asked for");
            BatchData view = batch.View();
            for (int i = 0; i < view.Count; ++i) Check.True(world.GetState(view.Id(i)).LinearVelocity.X > 0.5f, "blown along x");
            world.SetWindField(null);
            Check.Near(0.0, world.SampleWind(new Float3(1, 2, 3)).X, 0, "removed");
        }
    }

    public static void AWaterSurfaceCarriesWhatFloats()
    {
        using (var world = new World())
        {
            EllipsoidDesc cork = EllipsoidDesc.Create();
            cork.SemiAxes = new Double3(0.03, 0.03, 0.02);
            cork.Density = 200.0;
            Batch batch;
            using (Asset asset = Asset.CreateEllipsoid(cork)) batch = world.CreateBatch(asset, 1);
            BodyDesc desc = BodyDesc.Create();
            desc.Position = new Float3(0, 0.5f, 0);
            BodyId body = batch.CreateBody(desc);
            WaterDesc water = WaterDesc.Create();
            water.Reach = 2.0f;
            world.SetWater(water);
            int asked = 0;
            world.SetWaterField(query =>
            {
                ++asked;
                for (int i = 0; i < query.Count; ++i) query.Height[i] = 0.5f;
            });
            for (int i = 0; i < 600; ++i) world.Step(Scene.Frame, 4);
            Check.True(asked > 0, "asked");
            Check.Near(0.5, world.GetState(body).Position.Y, 0.05, "floats at the callback's height");
            world.SetWaterField(null);
            for (int i = 0; i < 600; ++i) world.Step(Scene.Frame, 4);
            Check.Near(0.0, world.GetState(body).Position.Y, 0.05, "floats at the plane");
        }
    }

    public static void WhatCallbacksThrowIsThrownAfterTheCall()
    {
        using (var world = new World())
        {
            Batch batch = Scene.Batch(world, 10);
            batch.CreateBodies(Scene.Bodies(10));
            world.SetWindField(query => { throw new FormatException("from a wind field"); });
            Exception e = Check.Throws<FormatException>(() => world.Step(Scene.Frame, 2), "wind");
            Check.True(e.StackTrace.Contains("CallbackTests"), "the stack is that of the callback: " + e.StackTrace);
            Check.Equal(2ul, world.Info.SubstepCount, "the step was made");
            world.SetWindField(null);
            world.Step(Scene.Frame, 1);
            world.SetWater(WaterDesc.Create());
            world.SetWaterField(query => { throw new FormatException("from a surface"); });
            BodyState state = world.GetState(batch.View().Id(0));
            state.Position = new Float3(0, 0, 0);
            world.SetState(batch.View().Id(0), state);
            Check.Throws<FormatException>(() => world.Step(Scene.Frame, 1), "surface");
            world.SetWaterField(null);
            world.Step(Scene.Frame, 1);
        }
        using (World world = With(new WorldServices { Log = (level, text) => { throw new FormatException("from a log"); } }))
            Check.Throws<FormatException>(() => world.SetUniformWind(new Float3(2000, 0, 0)), "log");
    }

    // A full disk, say, ends the recording. What the call created exists, so the caller must get its handle.
    public static void CallbacksThatThrowLoseNoHandle()
    {
        var creations = new Dictionary<string, Func<World, Batch, Func<bool>>>
        {
            { "batch", (world, batch) => { BatchId id = world.CreateBatch(Scene.Leaf(), 1).Id; return () => world.IsValid(id); } },
            { "body", (world, batch) => { BodyId id = batch.CreateBody(BodyDesc.Create()); return () => world.IsValid(id); } },
            { "box", (world, batch) => { BodyId id = batch.SpawnBox(default(Float3), new Float3(1, 1, 1), 2)[1]; return () => world.IsValid(id); } },
            { "emitter", (world, batch) => { BodyId id = batch.Emit(2)[1]; return () => world.IsValid(id); } },
            { "collider", (world, batch) => { ColliderId id = world.CreateCollider(Plane()); return () => world.IsValid(id); } },
            { "wind", (world, batch) => { WindSourceId id = world.AddVortex(VortexDesc.Create()); return () => world.IsValid(id); } },
        };
        foreach (var creation in creations)
        {
            var disk = new FullDisk();
            var world = new World();
            Batch batch = Scene.Batch(world, 10);
            batch.SetEmitter(EmitterDesc.Create());
            world.StartRecording(disk);
            disk.Full = true;
            Func<bool> isValid = creation.Value(world, batch);
            Check.Throws<System.IO.IOException>(() => isValid(), creation.Key + ": the next other call throws");
            Check.True(isValid(), creation.Key);
            disk.Full = false;
            world.StartRecording(disk);
            disk.Full = true;
            creation.Value(world, batch);
            Check.Throws<System.IO.IOException>(() => world.Dispose(), creation.Key + ": also at the end of the world");
            Check.True(world.IsDisposed, creation.Key);
        }
    }

    static ColliderDesc Plane()
    {
        ColliderDesc desc = ColliderDesc.Create();
        desc.Kind = ColliderKind.Plane;
        return desc;
    }

    sealed class FullDisk : System.IO.MemoryStream
    {
        public bool Full;

        public override void Write(byte[] buffer, int offset, int count)
        {
            if (Full) throw new System.IO.IOException("no space left");
            base.Write(buffer, offset, count);
        }
    }

    public static void WorkersThrowToo()
    {
        using (World world = With(new WorldServices(), 1))
        {
            Batch batch = Scene.Batch(world, 20000);
            batch.CreateBodies(Scene.Bodies(20000));
            int thread = Thread.CurrentThread.ManagedThreadId, elsewhere = 0;
            world.SetWindField(query =>
            {
                if (Thread.CurrentThread.ManagedThreadId != thread) Interlocked.Increment(ref elsewhere);
                Thread.Sleep(0);
                throw new FormatException("from some thread");
            });
            for (int i = 0; i < 20; ++i) Check.Throws<FormatException>(() => world.Step(Scene.Frame, 2), "wind");
            Check.True(elsewhere > 0, "native threads of the world called");
            world.SetWindField(null);
            world.Step(Scene.Frame, 1);
        }
    }

    public static void AWorldIsNotUsedByItsOwnCallbacks()
    {
        using (var world = new World())
        using (var other = new World())
        {
            Batch batch = Scene.Batch(world, 2);
            batch.CreateBody(BodyDesc.Create());
            foreach (Action use in new Action[] { () => world.Dispose(), () => world.Step(1), () => batch.View(), () => { ulong h = world.Hash; } })
            {
                world.SetWindField(query => use());
                Exception e = Check.Throws<InvalidOperationException>(() => world.Step(Scene.Frame, 1), "in a callback");
                Check.True(e.Message.Contains("callback"), e.Message);
            }
            world.SetWindField(query => other.Step(Scene.Frame, 1));
            world.Step(Scene.Frame, 1);
            Check.Equal(1ul, other.Info.SubstepCount, "another world may be used");
        }
    }

    sealed class Jobs : IJobSystem
    {
        public int Enqueued, Finished, Indices;
        public bool EnqueueThrows, FinishThrows, FinishTooEarly, Inline;
        // Tasks that wait for this come late even where a step takes longer than any sleep.
        public readonly ManualResetEvent StepsAreMade = new ManualResetEvent(false);

        public object Enqueue(JobTask task)
        {
            ++Enqueued;
            if (EnqueueThrows) throw new FormatException("from Enqueue");
            if (Inline)
            {
                task.Run(0, task.Count);
                return null;
            }
            int left = task.Count;
            var done = new ManualResetEvent(false);
            for (int i = 0; i < task.Count; ++i)
            {
                int index = i;
                ThreadPool.UnsafeQueueUserWorkItem(state =>
                {
                    try
                    {
                        if (FinishTooEarly && index == 0) StepsAreMade.WaitOne();
                        else if (FinishTooEarly) Thread.Sleep(5);
                        task.Run(index, index + 1);
                        Interlocked.Increment(ref Indices);
                    }
                    catch (InvalidOperationException)
                    {
                        Interlocked.Increment(ref Refused);
                    }
                    if (Interlocked.Decrement(ref left) == 0) done.Set();
                }, null);
            }
            return done;
        }

        public int Refused;

        public void Finish(object token)
        {
            ++Finished;
            if (FinishThrows) throw new FormatException("from Finish");
            if (!FinishTooEarly && token != null) ((ManualResetEvent)token).WaitOne();
        }
    }

    public static void AJobSystemDoesTheWork()
    {
        WorldDesc desc = WorldDesc.Create();
        ulong alone = WorldTests.HashAfter(desc, null, 20000, 5);
        desc.WorkerCount = 3;
        var jobs = new Jobs();
        Check.Equal(alone, WorldTests.HashAfter(desc, new WorldServices { Jobs = jobs }, 20000, 5), "hash");
        Check.True(jobs.Enqueued > 0 && jobs.Enqueued == jobs.Finished, "enqueued " + jobs.Enqueued + ", finished " + jobs.Finished);
        Check.True(jobs.Indices >= jobs.Enqueued, "indices " + jobs.Indices);
        var inline = new Jobs { Inline = true };
        Check.Equal(alone, WorldTests.HashAfter(desc, new WorldServices { Jobs = inline }, 20000, 5), "hash, run within Enqueue");
    }

    static readonly ManualResetEvent begun = new ManualResetEvent(false), go = new ManualResetEvent(false);

    [MonoPInvokeCallback(typeof(TaskFn))]
    static void BeginAndWait(IntPtr task, uint begin, uint end)
    {
        begun.Set();
        go.WaitOne();
    }

    public static void AStepWaitsForTasksThatHaveBegun()
    {
        TaskFn run = BeginAndWait;
        var job = new JobTask(System.Runtime.InteropServices.Marshal.GetFunctionPointerForDelegate(run), IntPtr.Zero, 1);
        var runner = new Thread(() => job.Run(0, 1));
        var closer = new Thread(() => job.Close());
        runner.Start();
        begun.WaitOne();
        closer.Start();
        Check.True(!closer.Join(50), "the task runs: its step goes on");
        go.Set();
        Check.True(closer.Join(5000), "the task has ended");
        runner.Join();
        Check.Throws<InvalidOperationException>(() => job.Run(0, 1), "too late");
        Check.Throws<ArgumentOutOfRangeException>(() => job.Run(0, 2), "more than there are");
        GC.KeepAlive(run);
    }

    public static void AFaultyJobSystemHarmsNothing()
    {
        WorldDesc desc = WorldDesc.Create();
        desc.WorkerCount = 3;
        foreach (Jobs jobs in new[] { new Jobs { EnqueueThrows = true }, new Jobs { FinishThrows = true }, new Jobs { FinishTooEarly = true } })
        {
            using (var world = new World(desc, new WorldServices { Jobs = jobs }))
            {
                Batch batch = Scene.Batch(world, 20000);
                batch.CreateBodies(Scene.Bodies(20000));
                for (int i = 0; i < 5; ++i)
                {
                    if (jobs.FinishTooEarly)
                        world.Step(Scene.Frame, 2);
                    else
                        Check.Throws<FormatException>(() => world.Step(Scene.Frame, 2), "job system");
                }
                Check.Equal(10ul, world.Info.SubstepCount, "all steps were made");
                if (jobs.EnqueueThrows) Check.Equal(0, jobs.Finished, "what was not enqueued is not finished");
                using (var calm = new World())
                {
                    Scene.Batch(calm, 20000).CreateBodies(Scene.Bodies(20000));
                    for (int i = 0; i < 5; ++i) calm.Step(Scene.Frame, 2);
                    Check.Equal(calm.Hash, world.Hash, "hash");
                }
            }
            if (!jobs.FinishTooEarly) continue;
            jobs.StepsAreMade.Set();
            for (int i = 0; i < 4000 && Volatile.Read(ref jobs.Refused) == 0; ++i) Thread.Sleep(5);
            Check.True(Volatile.Read(ref jobs.Refused) > 0, "late tasks are refused");
        }
    }
}
