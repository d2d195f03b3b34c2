// SPDX-License-Identifier: MIT
#if NETSTANDARD2_1 || NETCOREAPP
#define LANGEVIN_SPAN
#endif
using System;
using LangevinRigid;

static unsafe class ViewTests
{
    public static void AViewIsTheStateOfEachBody()
    {
        using (var world = new World())
        {
            Batch batch = Scene.Batch(world, 1000);
            batch.CreateBodies(Scene.Bodies(1000));
            for (int i = 0; i < 10; ++i) world.Step(Scene.Frame, 2);
            BatchData view = batch.View();
            Check.Equal(1000, view.Count, "count");
            var velocities = new Float3[2000];
            Check.Equal(1000, batch.WriteVelocities(velocities), "velocities");
            for (int i = 0; i < view.Count; ++i)
            {
                BodyState state = world.GetState(view.Id(i));
                Check.Equal(state.Position, view.Position(i), "position");
                Check.Equal(state.Orientation, view.Orientation(i), "orientation");
                Check.Equal(state.LinearVelocity, velocities[2 * i], "velocity");
                Check.Equal(state.AngularVelocity, velocities[2 * i + 1], "spin");
                Check.Equal(state.Scale, view.Raw.Scale[i], "scale");
                Check.Equal(state.NoiseSeed, view.Raw.NoiseSeed[i], "noise seed");
                Check.Near(state.Age, view.Raw.Age[i], 1e-6, "age");
            }
        }
    }

    public static void NothingIsCopied()
    {
        using (var world = new World())
        {
            Batch batch = Scene.Batch(world, 100);
            batch.CreateBodies(Scene.Bodies(100));
            BatchView raw = batch.RawView(), again = batch.View().Raw;
            Check.True(raw.PositionY == again.PositionY && raw.Ids == again.Ids, "the same arrays each time");
            Check.Equal(0ul, (ulong)raw.PositionX % 64, "64-byte aligned");
            float before = raw.PositionY[3];
            world.Step(Scene.Frame, 2);
            Check.True(raw.PositionY[3] < before, "the batch is not moved by a step: the old pointer shows the new state");
#if LANGEVIN_SPAN
            BatchData data = batch.View();
            fixed (float* x = &System.Runtime.InteropServices.MemoryMarshal.GetReference(data.PositionX))
                Check.True(x == data.Raw.PositionX, "a span is the array");
            Check.Equal(100, data.Ids.Length, "length");
            Check.Equal(data.Position(5).Z, data.PositionZ[5], "value");
            Check.Equal(data.Orientation(5).W, data.OrientationW[5], "value");
#endif
        }
    }

    public static void AStaleViewIsRecognised()
    {
        using (var world = new World())
        {
            Batch batch = Scene.Batch(world, 10);
            batch.CreateBodies(Scene.Bodies(5));
            BatchData view = batch.View();
            ulong hash = world.Hash;
            world.GetState(view.Id(0));
            batch.WriteTransforms(TransformFormat.PositionQuaternion, new float[70]);
            Check.True(view.IsCurrent, "queries leave it valid");
            world.Step(Scene.Frame, 1);
            Check.True(!view.IsCurrent, "a step does not");
            Stale(world, () => batch.CreateBodies(Scene.Bodies(1)), batch);
            Stale(world, () => world.SetUniformWind(new Float3(1, 0, 0)), batch);
            Stale(world, () => world.NoteChange(), batch);
            Stale(world, () => batch.SetLoadGains(LoadGains.Create()), batch);
            Stale(world, () => world.Dispose(), batch);
            Check.True(!default(BatchData).IsCurrent, "none is never valid");
            Check.Throws<InvalidOperationException>(() => { BatchData none = default(BatchData); none.Position(0); }, "none");
        }
    }

    static void Stale(World world, Action change, Batch batch)
    {
        Check.Throws<InvalidOperationException>(() =>
        {
            BatchData view = batch.View();
            view.Position(0);
            change();
            view.Position(0);
        }, "a view that is used after a change");
        if (world.IsDisposed) return;
        Check.Throws<ArgumentOutOfRangeException>(() => { BatchData view = batch.View(); view.Position(view.Count); }, "beyond the last body");
        Check.Throws<ArgumentOutOfRangeException>(() => { BatchData view = batch.View(); view.Id(-1); }, "before the first body");
    }

#if LANGEVIN_SPAN
    public static void SpansDoWhatArraysDo()
    {
        using (var world = new World())
        {
            Batch batch = Scene.Batch(world, 10);
            Span<BodyId> ids = stackalloc BodyId[3];
            batch.CreateBodies(new ReadOnlySpan<BodyDesc>(Scene.Bodies(3)), ids);
            Check.True(world.IsValid(ids[2]), "ids");
            batch.CreateBodies(new ReadOnlySpan<BodyDesc>(Scene.Bodies(1)), Span<BodyId>.Empty);
            world.SetSleep(ids, SleepState.Asleep);
            Check.Equal(1, batch.AwakeCount, "at rest");
            world.SetSleep(ids, SleepState.Awake);
            Span<float> x = stackalloc float[4];
            x.Fill(2.0f);
            batch.AddForces(ForceMode.Velocity, ForceFrame.World, x, x, x);
            Check.Near(2.0, world.GetState(ids[0]).LinearVelocity.X, 1e-5, "forces");
            BodyDesc turned = BodyDesc.Create();
            turned.Orientation = new Float4(0, 0, 1, 1); // x to y
            BodyId last = batch.CreateBody(turned);
            Span<float> none = stackalloc float[5];
            Span<float> forward = stackalloc float[5];
            forward[4] = 3.0f;
            batch.AddForces(ForceMode.Velocity, ForceFrame.Body, forward, none, none);
            Check.Near(3.0, world.GetState(last).LinearVelocity.Y, 1e-5, "in the body frame");
            world.DestroyBody(last);
            Span<float> matrices = stackalloc float[4 * 12];
            Check.Equal(4, batch.WriteTransforms(TransformFormat.Matrix3x4RowMajor, matrices), "transforms");
            Span<Float3> moving = stackalloc Float3[8];
            Check.Equal(4, batch.WriteVelocities(moving), "velocities");
            Check.Near(2.0, moving[0].X, 1e-5, "a velocity");
            Span<byte> memory = new byte[world.SnapshotSize];
            Check.Equal(memory.Length, world.SaveSnapshot(memory), "snapshot");
            ulong hash = world.Hash;
            world.DestroyBodies(ids.Slice(0, 2));
            world.RestoreSnapshot(memory);
            Check.Equal(hash, world.Hash, "restored");
            world.DestroyBodies(ids);
            Check.Equal(1, batch.Count, "destroyed");
            world.DestroyBodies(Span<BodyId>.Empty);
            int count;
            OverlapDesc all = OverlapDesc.Create();
            all.Size = new Float3(1000, 1000, 1000);
            Check.True(batch.Count == 1 && world.TryOverlap(all, ids, out count) && count == 1, "overlap");
            Span<Float3> velocities = stackalloc Float3[2];
            world.SetUniformWind(new Float3(3, 0, 0));
            world.SampleWind(new ReadOnlySpan<Float3>(new Float3[2]), velocities);
            Check.Near(3.0, velocities[1].X, 1e-6, "wind");
            Span<ColliderId> colliders = stackalloc ColliderId[1];
            ColliderDesc plane = ColliderDesc.Create();
            plane.Kind = ColliderKind.Plane;
            world.CreateColliders(new[] { plane }, colliders);
            ColliderMotion motion = ColliderMotion.Create();
            motion.Collider = colliders[0];
            motion.Mode = MoveMode.Place;
            motion.Position = new Float3(0, -5, 0);
            world.MoveColliders(new ReadOnlySpan<ColliderMotion>(new[] { motion }));
            Check.Equal(-5.0f, world.GetState(colliders[0]).Position.Y, "moved");
            Span<RayHit> hits = stackalloc RayHit[1];
            world.RayCast(new ReadOnlySpan<Ray>(new[] { Ray.Create() }), hits);
            Check.Equal(colliders[0], hits[0].Collider, "hit");
            world.DestroyColliders(colliders);
            Check.True(!world.IsValid(colliders[0]), "destroyed");
            Check.Throws<ArgumentException>(() => world.RayCast(new ReadOnlySpan<Ray>(new Ray[2]), new Span<RayHit>(new RayHit[1])), "no room");
            using (Asset asset = Asset.Load(new ReadOnlySpan<byte>(Scene.BakedBytes()))) Check.True(asset.Info.Mass > 0, "asset");
        }
    }
#endif
}
