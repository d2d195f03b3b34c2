// SPDX-License-Identifier: MIT
using System;
using LangevinRigid;

static unsafe class WorldTests
{
    public static void TheLibraryIsTheOneThatTheSourcesAreFor()
    {
        Check.True(LangevinLibrary.IsCompatible(LangevinLibrary.Version, LangevinLibrary.HeaderVersion), "compatible");
        Check.Equal(new Version(1, 2, 3), LangevinLibrary.VersionOf(1u << 22 | 2u << 12 | 3u), "parts of a version");
        Check.True(LangevinLibrary.IsCompatible(new Version(1, 3, 0), new Version(1, 2, 7)), "a newer minor version after 1.0");
        Check.True(!LangevinLibrary.IsCompatible(new Version(0, 3, 0), new Version(0, 2, 0)), "another minor version before 1.0");
        Check.True(!LangevinLibrary.IsCompatible(new Version(0, 2, 0), new Version(0, 2, 1)), "older than the header");
        Check.True(!LangevinLibrary.IsCompatible(new Version(2, 0, 0), new Version(1, 0, 0)), "another major version");
    }

    public static void InstructionSetsAreListedAndGiveTheSameBits()
    {
        SimdTarget[] targets = LangevinLibrary.SimdTargets();
        Check.True(targets.Length > 0, "this processor has one");
        ulong expected = 0;
        foreach (SimdTarget target in targets)
        {
            Check.True(LangevinLibrary.NameOf(target).Length > 2, "a name");
            WorldDesc desc = WorldDesc.Create();
            desc.SimdTarget = target;
            ulong hash = HashAfter(desc, null, 500, 20);
            if (expected == 0) expected = hash;
            Check.Equal(expected, hash, LangevinLibrary.NameOf(target));
        }
    }

    public static ulong HashAfter(WorldDesc desc, WorldServices services, int bodies, int frames)
    {
        using (var world = new World(desc, services))
        {
            Batch batch = Scene.Batch(world, bodies);
            batch.CreateBodies(Scene.Bodies(bodies));
            for (int i = 0; i < frames; ++i) world.Step(Scene.Frame, 2);
            return world.Hash;
        }
    }

    public static void AHundredThousandBodiesFall()
    {
        const int bodies = 100000;
        using (var world = new World())
        {
            Batch batch = Scene.Batch(world, bodies);
            BodyDesc[] descs = Scene.Bodies(bodies);
            batch.CreateBodies(descs);
            var transforms = new float[bodies * 12];
            DateTime start = DateTime.UtcNow;
            for (int i = 0; i < 30; ++i)
            {
                world.Step(Scene.Frame, 2);
                Check.Equal(bodies, batch.WriteTransforms(TransformFormat.Matrix3x4RowMajor, transforms), "written");
            }
            Console.WriteLine("100,000 bodies: {0:F2} ms a frame of 2 substeps and transforms", (DateTime.UtcNow - start).TotalMilliseconds / 30);
            WorldInfo info = world.Info;
            Check.Equal((ulong)bodies, info.BodyCount, "bodies");
            Check.Equal(60ul, info.SubstepCount, "substeps");
            Check.Near(0.5, info.Time, 1e-6, "time");
            for (int i = 0; i < bodies; ++i)
                if (!(transforms[12 * i + 7] < descs[i].Position.Y)) Check.True(false, "body " + i + " has not fallen");
        }
    }

    public static void WorkersChangeNothing()
    {
        WorldDesc desc = WorldDesc.Create();
        desc.Seed = 7;
        ulong alone = HashAfter(desc, null, 20000, 5);
        desc.WorkerCount = 1;
        Check.Equal(alone, HashAfter(desc, null, 20000, 5), "hash");
        desc.Seed = 8;
        Check.True(alone != HashAfter(desc, null, 20000, 5), "another seed gives another hash");
    }

    public static void TransformsAreThoseOfTheStates()
    {
        using (var world = new World())
        {
            Batch batch = Scene.Batch(world, 10);
            BodyDesc desc = BodyDesc.Create();
            desc.Scale = 2.0f;
            desc.Position = new Float3(1.0f, 2.0f, 3.0f);
            desc.Orientation = new Float4(0.5f, 0.5f, 0.5f, 0.5f); // x to y, y to z, z to x
            batch.CreateBody(desc);
            var to = new float[16];
            Check.Equal(1, batch.WriteTransforms(TransformFormat.PositionQuaternionScale, to), "written");
            float[] expected = { 1, 2, 3, 0.5f, 0.5f, 0.5f, 0.5f, 2 };
            for (int i = 0; i < 8; ++i) Check.Near(expected[i], to[i], 1e-6, "element " + i);
            batch.WriteTransforms(TransformFormat.Matrix3x4RowMajor, to);
            float[] rows = { 0, 0, 2, 1, 2, 0, 0, 2, 0, 2, 0, 3 };
            for (int i = 0; i < 12; ++i) Check.Near(rows[i], to[i], 1e-6, "3x4, element " + i);
            batch.WriteTransforms(TransformFormat.Matrix4x4ColumnMajor, to);
            float[] columns = { 0, 2, 0, 0, 0, 0, 2, 0, 2, 0, 0, 0, 1, 2, 3, 1 };
            for (int i = 0; i < 16; ++i) Check.Near(columns[i], to[i], 1e-6, "4x4, element " + i);
            foreach (TransformFormat format in Enum.GetValues(typeof(TransformFormat)))
            {
                var exact = new float[Batch.SizeOf(format) / 4];
                Check.Equal(1, batch.WriteTransforms(format, exact), "an array of one element");
                Check.Equal(0, batch.WriteTransforms(format, new float[exact.Length - 1]), "no room");
            }
        }
    }

    public static void ASnapshotGoesOnAsItWas()
    {
        using (var world = new World())
        using (var other = new World())
        {
            foreach (World w in new[] { world, other }) Scene.Batch(w, 50);
            Batch batch = Scene.Batch(world, 50);
            Scene.Batch(other, 50);
            BodyId[] bodies = batch.CreateBodies(Scene.Bodies(50));
            world.Step(Scene.Frame, 2);
            byte[] bytes = world.SaveSnapshot();
            ulong then = world.Hash;
            world.Step(Scene.Frame, 2);
            ulong later = world.Hash;
            other.RestoreSnapshot(bytes);
            Check.Equal(then, other.Hash, "restored");
            Check.True(other.IsValid(bodies[49]), "ids are the same");
            other.Step(Scene.Frame, 2);
            Check.Equal(later, other.Hash, "went on");
            fixed (byte* first = bytes) Check.Equal((ulong)bytes.Length, world.SnapshotSize, "size");
        }
    }

    public static void ARecordingIsWrittenToAStream()
    {
        using (var world = new World())
        {
            var stream = new System.IO.MemoryStream();
            Check.Status(Status.InvalidArgument, () => world.StopRecording());
            world.StartRecording(stream);
            Check.Status(Status.InvalidArgument, () => world.StartRecording(stream));
            Scene.Batch(world, 5).CreateBodies(Scene.Bodies(5));
            for (int i = 0; i < 10; ++i) world.Step(Scene.Frame, 2);
            world.StopRecording();
            long length = stream.Length;
            Check.True(length > 1000, "bytes: " + length);
            world.Step(Scene.Frame, 2);
            Check.Equal(length, stream.Length, "after its end");
            var full = new System.IO.MemoryStream(new byte[64]); // throws at its end
            Check.Throws<NotSupportedException>(() => world.StartRecording(full), "a stream without room");
            Check.Status(Status.InvalidArgument, () => world.StopRecording());
            world.Step(Scene.Frame, 2);
        }
    }

    public static void ManyStructsHaveInitialValuesAndTheirSize()
    {
        Check.Near(-9.81, WorldDesc.Create().Gravity.Y, 1e-6, "gravity");
        Check.Equal(1.0f, BodyDesc.Create().Scale, "scale");
        Check.Equal(1.0f, BodyDesc.Create().Orientation.W, "orientation");
        Check.Equal((uint)sizeof(EmitterDesc), EmitterDesc.Create().StructSize, "size");
        Check.Equal(RayFlags.Bodies | RayFlags.Colliders, Ray.Create().Flags, "flags");
        Check.Equal(ColliderKind.Plane, (ColliderKind)1, "kinds");
        WaterDesc water = WaterDesc.Create();
        water.Waves(7).Length = 3.0f;
        Check.Equal(3.0f, water.Waves7.Length, "elements of arrays of structs");
        Check.Throws<ArgumentOutOfRangeException>(() => water.Waves(8).Length = 1.0f, "beyond the array");
    }
}
