// SPDX-License-Identifier: MIT
using System;
using System.Threading;
using LangevinRigid;

/// <summary>Messages for a missing or wrong library; each case needs its own process.</summary>
static class LoadCheck
{
    public static int Run(string kind)
    {
        foreach (Action first in new Action[] { () => LangevinLibrary.EnsureLoaded(), () => new World(), () => BodyDesc.Create(), () => Asset.Check(new byte[1]) })
        {
            try
            {
                first();
            }
            catch (LangevinLibraryException e)
            {
                string expected = kind == "newer" || kind == "older" ? kind + " than version" : kind == "other" ? "no lr_version" : "could not be loaded";
                if (!e.Message.Contains(expected)) return Fail(kind + ": " + e.Message);
                if (kind == "newer" && !Equals(e.Found, new Version(0, 99, 0))) return Fail("found " + e.Found);
                if (kind == "missing" && !(e.InnerException is DllNotFoundException)) return Fail("the cause is kept");
                continue;
            }
            return Fail(kind + ": nothing was thrown");
        }
        return 0;
    }

    /// <summary>Exits while worlds with callbacks and threads exist, one of them in a step, and with a handler that calls a world that has ended.</summary>
    public static int Leave()
    {
        for (int i = 0; i < 3; ++i)
        {
            WorldDesc desc = WorldDesc.Create();
            desc.WorkerCount = 2;
            var world = new World(desc, new WorldServices { Allocator = new CountingAllocator(), Log = (level, text) => Console.WriteLine(text) });
            Scene.Batch(world, 1000).CreateBodies(Scene.Bodies(1000));
            world.SetWindField(query => Thread.Sleep(1));
            var thread = new Thread(() => { for (;;) world.Step(Scene.Frame, 1); });
            thread.IsBackground = true;
            thread.Start();
        }
        Thread.Sleep(100);
        WorldDesc threaded = WorldDesc.Create();
        threaded.WorkerCount = 1;
        var ended = new World(threaded);
        AppDomain.CurrentDomain.ProcessExit += (sender, arguments) =>
        {
            try
            {
                Console.WriteLine(ended.Hash);
            }
            catch (ObjectDisposedException)
            {
                Environment.ExitCode = 0;
            }
        };
        return 1; // unless the handler gets its exception
    }

    static int Fail(string what)
    {
        Console.WriteLine("FAILED " + what);
        return 1;
    }
}
