// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using System.IO;
using System.Runtime.InteropServices;
using LangevinRigid;

/// <summary>Every status that callers can provoke, as an exception if the managed layer can pass it on.</summary>
static unsafe class StatusTests
{
    static readonly List<Status> Seen = new List<Status>();

    static LangevinException Expect(Status status, Action action)
    {
        LangevinException e = Check.Status(status, action);
        Seen.Add(status);
        return e;
    }

    public static void EachStatusIsThrown()
    {
        Arguments();
        Memory();
        Threads();
        StaleThings();
        Steps();
        Files();
        Snapshots();
        Seen.Add(Status.Ok);
        // No caller can provoke it: the library returns it only for a failed internal check.
        Seen.Add(Status.Internal);
        // The class World refuses this by itself, before the call.
        Seen.Add(Status.ConcurrentUse);
        Seen.Add(Status.Reentrant);
        foreach (Status status in Enum.GetValues(typeof(Status)))
            Check.True(Seen.Contains(status), status + " was never thrown");
    }

    public static void EachStatusHasWords()
    {
        var texts = new List<string>();
        foreach (Status status in Enum.GetValues(typeof(Status)))
        {
            string text = LangevinLibrary.TextOf(status);
            Check.True(!texts.Contains(text), "words of its own: " + status);
            texts.Add(text);
        }
        Check.Equal("unknown status", LangevinLibrary.TextOf((Status)(-999)), "unknown");
        Check.True(!texts.Contains("unknown status"), "all are known");
    }

    static void Arguments()
    {
        using (var world = new World())
        {
            Batch batch = Scene.Batch(world, 4);
            Expect(Status.NullArgument, () => world.DestroyBodies(null, 1));
            LangevinException e = Expect(Status.StructSize, () => world.AddGusts(default(GustsDesc)));
            Check.True(e.Message.Contains("Create()"), "what to do: " + e.Message);
            Expect(Status.StructSize, () => new World(default(WorldDesc)));
            BodyDesc desc = BodyDesc.Create();
            desc.Scale = 1e9f;
            Expect(Status.InvalidArgument, () => batch.CreateBody(desc));
            desc.Scale = float.NaN;
            Expect(Status.NotFinite, () => batch.CreateBody(desc));
            Expect(Status.Capacity, () => batch.CreateBodies(Scene.Bodies(5)));
            Check.Equal(0, batch.Count, "all or none");
            batch.CreateBodies(Scene.Bodies(4));
            Expect(Status.BufferTooSmall, () =>
            {
                byte one;
                unsafe { world.SaveSnapshot(&one, 1); }
            });
            SimdTarget elsewhere = Array.IndexOf(LangevinLibrary.SimdTargets(), SimdTarget.Neon) < 0 ? SimdTarget.Neon : SimdTarget.Avx2;
            Expect(Status.Unsupported, () => world.SetSimdTarget(elsewhere));
        }
    }

    static void Memory()
    {
        var allocator = new CountingAllocator();
        using (var world = new World(WorldDesc.Create(), new WorldServices { Allocator = allocator }))
        {
            allocator.FailAfter = allocator.Total;
            Expect(Status.OutOfMemory, () => Scene.Batch(world, 100));
            allocator.FailAfter = 0;
            Scene.Batch(world, 100);
        }
    }

    [StructLayout(LayoutKind.Sequential)]
    struct Limit
    {
        public ulong Soft, Hard;
    }

    [DllImport("libc.so.6", SetLastError = true)]
    static extern int getrlimit(int resource, Limit* limit);

    [DllImport("libc.so.6", SetLastError = true)]
    static extern int setrlimit(int resource, Limit* limit);

    static void WithAddressSpace(ulong bytes, Action action)
    {
        const int addressSpace = 9; // RLIMIT_AS on Linux
        Limit before;
        Check.Equal(0, getrlimit(addressSpace, &before), "getrlimit");
        Limit little = before;
        little.Soft = bytes;
        Check.Equal(0, setrlimit(addressSpace, &little), "setrlimit");
        try
        {
            action();
        }
        finally
        {
            setrlimit(addressSpace, &before);
        }
    }

    // Threads without address space for their stacks.
    static void Threads()
    {
        ulong pages = ulong.Parse(File.ReadAllText("/proc/self/statm").Split(' ')[0]);
        WorldDesc desc = WorldDesc.Create();
        desc.WorkerCount = 64;
        new LangevinException(Status.Threads, "lr_world_create"); // loads the exception's code while there is memory
        Expect(Status.Threads, () => WithAddressSpace(pages * 4096 + (64ul << 20), () => new World(desc).Dispose()));
        new World(desc).Dispose();
    }

    static void StaleThings()
    {
        using (var world = new World())
        {
            Batch batch = Scene.Batch(world, 4);
            Expect(Status.StaleBody, () => world.GetState(new BodyId(12345)));
            Expect(Status.StaleCollider, () => world.DestroyCollider(new ColliderId(77)));
            GustsDesc gusts = GustsDesc.Create();
            WindSourceId source = world.AddGusts(gusts);
            world.RemoveWind(source);
            Expect(Status.StaleWindSource, () => world.RemoveWind(source));
            Expect(Status.StaleWindSource, () => world.UpdateGusts(source, gusts));
            BatchId id = batch.Id;
            batch.Dispose();
            Ray ray = Ray.Create();
            ray.Batch = id;
            Expect(Status.StaleBatch, () => world.RayCast(ray));
        }
    }

    static void Steps()
    {
        using (var world = new World())
        {
            Expect(Status.TimestepZero, () => world.Step(0.0f, 1));
            Expect(Status.TimestepNegative, () => world.Step(-1.0f, 1));
            Expect(Status.TimestepNotFinite, () => world.Step(float.NaN, 1));
            Expect(Status.TimestepTooLarge, () => world.Step(2.5f, 2));
            Expect(Status.Substeps, () => world.Step(1.0f, 0));
            Expect(Status.Substeps, () => world.Step(1.0f, (int)Limits.MaxSubsteps + 1));
            Expect(Status.Substeps, () => world.Step(1.0f, -1));
        }
    }

    static void Files()
    {
        Expect(Status.FileNotFound, () => Asset.LoadFile(Path.Combine(Scene.Folder, "not there.lrb")));
        Expect(Status.FileRead, () => Asset.LoadFile(Scene.Folder));
        using (Asset good = Asset.LoadFile(Scene.BakedPath)) Check.Equal("leaf", good.Name, "name");
        byte[] bytes = Scene.BakedBytes();
        using (Asset good = Asset.Load(bytes)) Check.True(good.Info.TurbulenceCount > 0 && good.Aerodynamics.Drag.Z > 0, "baked");
        Check.Equal(0, Asset.Check(bytes).Count, "no fault");

        Expect(Status.AssetFormat, () => Asset.Load(new byte[0]));
        Expect(Status.AssetFormat, () => Asset.Load(new byte[100]));
        byte[] damaged = (byte[])bytes.Clone();
        damaged[damaged.Length / 2] ^= 1;
        LangevinException e = Expect(Status.AssetCorrupt, () => Asset.Load(damaged));
        Check.True(e.Faults.Count > 0 && e.Faults[0].Number > 0 && e.Faults[0].Remedy.Length > 0, "faults");
        Check.True(e.Message.Contains("error " + e.Faults[0].Number), e.Message);

        byte[] newer = Changed(bytes, 0, BitConverter.GetBytes(3u));
        e = Expect(Status.AssetVersion, () => Asset.Load(newer));
        byte[] invalid = Changed(bytes, 3, BitConverter.GetBytes(double.NaN));
        e = Expect(Status.AssetInvalid, () => Asset.Load(invalid));
        Check.True(e.Faults[0].Where.Contains("mass"), "where: " + e.Faults[0].Where);
        string path = Path.Combine(Scene.Folder, "ungültig.lrb");
        File.WriteAllBytes(path, invalid);
        e = Expect(Status.AssetInvalid, () => Asset.LoadFile(path));
        Check.True(e.Faults.Count > 0 && e.Message.Contains("ungültig.lrb"), "a path in UTF-8, and its faults: " + e.Message);
        File.Delete(path);
    }

    // Changes a field of the file's root table, by the layout of FlatBuffers, then the checksum, field 1: FNV-1a over bytes with it zeroed.
    static byte[] Changed(byte[] bytes, int field, byte[] value)
    {
        var changed = (byte[])bytes.Clone();
        value.CopyTo(changed, FieldOffset(bytes, field));
        int at = FieldOffset(bytes, 1);
        new byte[8].CopyTo(changed, at);
        ulong hash = 0xcbf29ce484222325ul;
        foreach (byte b in changed) hash = unchecked((hash ^ b) * 0x100000001b3ul);
        BitConverter.GetBytes(hash).CopyTo(changed, at);
        return changed;
    }

    static int FieldOffset(byte[] bytes, int field)
    {
        int root = BitConverter.ToInt32(bytes, 0), table = root - BitConverter.ToInt32(bytes, root);
        return root + BitConverter.ToUInt16(bytes, table + 4 + 2 * field);
    }

    static void Snapshots()
    {
        using (var world = new World())
        using (var other = new World())
        {
            Scene.Batch(world, 10);
            Scene.Batch(other, 11);
            byte[] bytes = world.SaveSnapshot();
            Expect(Status.SnapshotMismatch, () => other.RestoreSnapshot(bytes));
            Expect(Status.SnapshotFormat, () => world.RestoreSnapshot(new byte[10]));
            bytes[bytes.Length - 1] ^= 1;
            Expect(Status.SnapshotFormat, () => world.RestoreSnapshot(bytes));
        }
    }
}
