// SPDX-License-Identifier: MIT
using System;
using LangevinRigid;

/// <summary>Each setting reaches the library and takes effect.</summary>
static unsafe class SettingsTests
{
    public static void WindAndItsSources()
    {
        using (var world = new World())
        {
            var point = new Float3(0.5f, 0.5f, 0.5f);
            world.SetUniformWind(new Float3(1, 2, 3));
            Check.Equal(new Float3(1, 2, 3), world.SampleWind(point), "uniform");
            Check.Equal(new Float3(1, 2, 3), world.GetUniformWind(), "read back");
            world.SetUniformWind(new Float3());
            WindGridDesc grid = WindGridDesc.Create();
            grid.Counts = new UInt3(2, 2, 2);
            grid.Outside = WindOutside.Clamp;
            var samples = new float[24];
            for (int i = 0; i < 24; i += 3) samples[i] = 4.0f;
            WindSourceId source = world.AddWindGrid(grid, samples);
            Check.Near(4.0, world.SampleWind(point).X, 1e-6, "grid");
            Check.Throws<ArgumentException>(() => world.AddWindGrid(grid, new float[23]), "too few samples");
            for (int i = 0; i < 24; i += 3) samples[i] = 6.0f;
            world.UpdateWindGrid(source, grid, samples);
            Check.Near(6.0, world.SampleWind(point).X, 1e-6, "updated");
            var velocities = new Float3[3];
            world.SampleWind(new Float3[3], velocities);
            Check.Near(6.0, velocities[2].X, 1e-6, "many");
            Check.Throws<ArgumentException>(() => world.SampleWind(new Float3[3], new Float3[2]), "no room");
            world.RemoveWind(source);
            Check.Equal(new Float3(), world.SampleWind(point), "removed");
            VortexDesc vortex = VortexDesc.Create();
            vortex.Core = VortexCore.Rankine;
            vortex.Circulation = 5.0f;
            source = world.AddVortex(vortex);
            vortex.Circulation = 6.0f;
            world.UpdateVortex(source, vortex);
            Check.Equal(6.0f, world.GetVortex(source).Circulation, "a source is read back");
            Check.Status(Status.InvalidArgument, () => world.GetGusts(source));
        }
    }

    public static void GravityAndForces()
    {
        using (var world = new World())
        {
            Batch batch = Scene.Batch(world, 4);
            world.SetGravity(new Float3(0, 0, 0));
            BodyId body = batch.CreateBody(BodyDesc.Create());
            world.Step(Scene.Frame);
            Check.Near(0.0, world.GetState(body).LinearVelocity.Y, 1e-6, "nothing pulls");

            BodyForce push = BodyForce.Create();
            push.Body = body;
            push.Mode = ForceMode.Velocity;
            push.Force = new Float3(0, 1, 0);
            world.AddForce(push);
            Check.Near(1.0, world.GetState(body).LinearVelocity.Y, 1e-5, "a velocity is added at once");
            world.AddForces(new[] { push, push });
            Check.Near(3.0, world.GetState(body).LinearVelocity.Y, 1e-5, "and twice");
            batch.AddForces(ForceMode.Velocity, new[] { new Float3(2, 0, 0) });
            Check.Near(2.0, world.GetState(body).LinearVelocity.X, 1e-5, "from an array");
            Check.Status(Status.InvalidArgument, () => batch.AddForces(ForceMode.Velocity, new Float3[2]));
            BodyId second = batch.CreateBody(BodyDesc.Create());
            batch.AddForces(ForceMode.Velocity, new[] { new Float3(0, 0, 7) }, 1);
            Check.Near(7.0, world.GetState(second).LinearVelocity.Z, 1e-5, "from the second body on");
            Check.Near(0.0, world.GetState(body).LinearVelocity.Z, 1e-5, "not the first");
            world.DestroyBody(second);

            BodyState state = world.GetState(body);
            state.LinearVelocity = new Float3();
            world.SetState(body, state);
            BatchForce all = BatchForce.Create();
            all.Acceleration = new Float3(0, 0, 5);
            batch.SetForce(all);
            Check.Equal(all.Acceleration.X + all.Force.Y, batch.GetForce().Acceleration.X + batch.GetForce().Force.Y, "as set");
            world.Step(Scene.Frame);
            Check.True(world.GetState(body).LinearVelocity.Z > 0.05f, "a force on all");
            batch.ClearForce();
            world.SetState(body, state);
            world.Step(Scene.Frame);
            Check.Near(0.0, world.GetState(body).LinearVelocity.Z, 1e-6, "ended");
        }
    }

    public static void RestAndWaking()
    {
        using (var world = new World())
        {
            Batch batch = Scene.Batch(world, 4);
            BodyId[] bodies = batch.CreateBodies(Scene.Bodies(3));
            world.SetSleep(bodies[0], SleepState.Asleep);
            Check.Equal(2, batch.AwakeCount, "awake");
            Check.Equal(SleepState.Asleep, world.GetState(bodies[0]).SleepState, "state");
            world.SetSleep(bodies, SleepState.Asleep);
            Check.Equal(0, batch.AwakeCount, "all rest");
            float y = world.GetState(bodies[1]).Position.Y;
            world.Step(Scene.Frame);
            Check.Equal(y, world.GetState(bodies[1]).Position.Y, "they do not move");
            Check.Equal(3, world.WakeBox(new Float3(-100, -100, -100), new Float3(100, 100, 100)), "woken");
        }
    }

    public static void BatchesHaveSettings()
    {
        using (var world = new World())
        using (Asset leaf = Scene.Leaf())
        {
            BatchDesc desc = BatchDesc.Create();
            desc.Capacity = 8;
            desc.LoadModel = LoadModel.Langevin;
            desc.Integrator = Integrator.Rk4;
            Batch batch = world.CreateBatch(leaf, desc), other = world.CreateBatch(leaf, 8);
            Check.Equal(8, batch.Capacity, "capacity");

            Aerodynamics own = batch.GetAerodynamics();
            Aerodynamics changed = own;
            changed.Drag.X = own.Drag.X * 2;
            batch.SetAerodynamics(changed);
            Check.Equal(changed.Drag.X, batch.GetAerodynamics().Drag.X, "set");
            batch.ResetAerodynamics();
            Check.Equal(own.Drag.X, batch.GetAerodynamics().Drag.X, "reset");

            BatchContact contact = batch.GetContact();
            contact.Friction = 2.0f;
            batch.SetContact(contact);
            Check.Equal(2.0f, batch.GetContact().Friction, "contact");
            batch.ResetContact();
            Check.Equal(0.5f, batch.GetContact().Friction, "reset");

            Check.True(!world.GetBodyContact(batch, other), "initially");
            batch.SetBodyContact(other, true);
            Check.True(world.GetBodyContact(other, batch), "pairs");
            using (var elsewhere = new World())
                Check.Throws<ArgumentException>(() => world.SetBodyContact(batch, Scene.Batch(elsewhere, 1), true), "a batch of another world");

            batch.SetRate(4);
            batch.CreateBody(BodyDesc.Create());
            world.Step(Scene.Frame, 1);
            Check.Equal(4u, batch.GetPace().Divisor, "divisor");
            batch.SetRate(1);
            Check.Equal(1u, batch.GetPace().Divisor, "reset");

            TurbulenceTable table = TurbulenceTable.Create();
            table.Dt = 0.1f;
            table.U0 = 1.0f;
            table.L = 0.1f;
            string before = Convert.ToBase64String(world.SaveSnapshot());
            batch.SetTurbulenceTable(table, new[] { 1.0f, 0.5f }, new[] { 0.1f, 0.05f });
            Check.True(Convert.ToBase64String(world.SaveSnapshot()) != before, "a table is part of snapshots");
            float[] chi, epsilon;
            TurbulenceTable read = batch.GetTurbulenceTable(out chi, out epsilon);
            Check.True(read.U0 == table.U0 && read.L == table.L && read.C0 == table.C0, "the table");
            Check.True(chi.Length == 2 && chi[1] == 0.5f && epsilon.Length == 2 && epsilon[1] == 0.05f, "its samples");
            Check.Throws<ArgumentException>(() => batch.SetTurbulenceTable(table, new float[2], new float[3]), "lengths");
            batch.ResetTurbulenceTable();
            Check.Equal(before, Convert.ToBase64String(world.SaveSnapshot()), "reset");

            LoadGains gains = LoadGains.Create();
            gains.Drag = 0.0f;
            gains.Lift = 0.0f;
            gains.Turbulence = 0.0f;
            other.SetLoadGains(gains);
            Check.Equal(gains.Drag, other.GetLoadGains().Drag, "as set");
            // Far from the first batch's body, flat side down: only the air acts on it.
            BodyDesc apart = BodyDesc.Create();
            apart.Position = new Float3(5, 0, 0);
            apart.Orientation = new Float4(0.70710678f, 0, 0, 0.70710678f);
            BodyId body = other.CreateBody(apart);
            BatchId nothing = default(BatchId);
            Check.True(nothing.IsNull && other.Id != nothing, "handles");
            for (int i = 0; i < 30; ++i) world.Step(Scene.Frame, 2);
            float free = -world.GetState(body).LinearVelocity.Y;
            other.ResetLoadGains();
            for (int i = 0; i < 30; ++i) world.Step(Scene.Frame, 2);
            Check.True(free > 4.0f && -world.GetState(body).LinearVelocity.Y < free, "gains: " + free);
        }
    }

    public static void Budgets()
    {
        using (var world = new World())
        {
            Batch batch = Scene.Batch(world, 1000);
            batch.CreateBodies(Scene.Bodies(1000));
            world.SetBudget(1000);
            world.Step(Scene.Frame, 4);
            Check.True(world.StepReport.BodySubsteps <= 1000 && world.StepReport.BodySubstepsWanted == 4000, "left out");
            world.SetBudget(0);
            world.Step(Scene.Frame, 4);
            Check.True(world.StepReport.BodySubsteps >= 4000, "all done");
        }
    }

    public static void RulesEmittersAndTheirEvents()
    {
        using (var world = new World())
        {
            Batch batch = Scene.Batch(world, 100);
            EmitterDesc emitter = EmitterDesc.Create();
            emitter.Rate = 600.0f;
            EmitterDesc kept;
            BatchRules keptRules;
            WaterDesc water;
            Check.True(!batch.TryGetEmitter(out kept) && !batch.TryGetRules(out keptRules) && !world.TryGetWater(out water), "none");
            batch.SetEmitter(emitter);
            Check.True(batch.TryGetEmitter(out kept) && kept.Rate == 600.0f, "as set");
            world.SetEvents(100, EventKinds.Spawned | EventKinds.Killed);
            Check.Equal(4, batch.Emit(4).Length, "now");
            Check.Equal(1, batch.SpawnBox(new Float3(0, -2, 0), new Float3(0, -1, 0), 1).Length, "in a box");
            Check.Status(Status.InvalidArgument, () => batch.SpawnBox(new Float3(0, 1, 0), new Float3(0, 0, 0), 1));
            world.Step(Scene.Frame, 1);
            BatchCounts counts = batch.GetCounts();
            Check.Equal(10u, counts.Spawned, "spawned");
            var told = new BodyEvent[100];
            Check.Equal(15, world.CopyEvents(told), "both");
            Check.True(told[14].Kind == EventKind.Spawned && told[14].User == 0 && world.IsValid(told[14].Body), "ids");
            Check.True(world.Timings.Total > 0.0, "timings");
            Float3 low, high;
            Check.True(batch.TryGetBounds(out low, out high) && low.Y < high.Y && high.Y < 1.0f, "bounds");
            BatchRules rules = BatchRules.Create();
            rules.VolumeCount = 1;
            rules.Volumes(0).Shape = VolumeShape.Sphere;
            rules.Volumes(0).Side = KillSide.Inside;
            rules.Volumes(0).Size = new Float3(1000, 0, 0);
            batch.SetRules(rules);
            Check.True(batch.TryGetRules(out keptRules) && keptRules.VolumeCount == 1, "as set");
            batch.ClearEmitter();
            Check.Status(Status.InvalidArgument, () => batch.Emit(1));
            world.Step(Scene.Frame, 1);
            counts = batch.GetCounts();
            Check.Equal(15u, counts.Destroyed, "destroyed");
            Check.Equal(15u, counts.ByVolume[0], "by the volume");
            Check.True(world.CopyEvents(told) == 15 && told[0].Kind == EventKind.Killed, "all are told");
            batch.ClearRules();
            Check.Equal(0, batch.Count, "none left");
            Check.Equal(DivergencePolicy.Auto, batch.DivergencePolicy, "policy");
            batch.DivergencePolicy = DivergencePolicy.Remove;
            Check.Equal(DivergencePolicy.Remove, batch.DivergencePolicy, "policy");
            Check.Status(Status.InvalidArgument, () => batch.DivergencePolicy = (DivergencePolicy)9);
        }
    }

    public static void CollidersEventsAndQueries()
    {
        using (var world = new World())
        {
            ColliderDesc desc = ColliderDesc.Create();
            desc.Kind = ColliderKind.Plane;
            ColliderDesc box = ColliderDesc.Create();
            box.Kind = ColliderKind.Box;
            box.Size = new Float3(1, 1, 1);
            box.Position = new Float3(50, 1, 0);
            ColliderId[] ground = world.CreateColliders(new[] { desc, box });
            world.SetEvents(100, EventKinds.All);
            Batch batch = Scene.Batch(world, 4);
            BodyDesc body = BodyDesc.Create();
            body.Position = new Float3(0, 0.3f, 0);
            BodyId leaf = batch.CreateBody(body);
            var events = new BodyEvent[10];
            bool landed = false, touched = false;
            for (int i = 0; i < 600 && !landed; ++i)
            {
                world.Step(Scene.Frame, 4);
                int count = world.CopyEvents(events);
                for (int k = 0; k < count; ++k)
                {
                    Check.Equal(leaf, events[k].Body, "whose event");
                    touched |= events[k].Kind == EventKind.Hit && events[k].Collider == ground[0] && events[k].Normal.Y > 0.99f;
                    landed |= events[k].Kind == EventKind.Landed;
                }
            }
            Check.True(touched && landed, "touched " + touched + ", landed " + landed);

            Ray ray = Ray.Create();
            ray.Origin = new Float3(0.005f, 1, 0.003f);
            ray.Origin.X += world.GetState(leaf).Position.X;
            ray.Origin.Z += world.GetState(leaf).Position.Z;
            Check.Equal(leaf, world.RayCast(ray).Body, "a ray hits the leaf");
            var hits = new RayHit[2];
            ray.Flags = RayFlags.Colliders;
            world.RayCast(new[] { ray, ray }, hits);
            Check.Equal(ground[0], hits[1].Collider, "and the ground");
            Check.Near(1.0, hits[1].Distance, 1e-5, "distance");
            OverlapDesc near = OverlapDesc.Create();
            near.Position = world.GetState(leaf).Position;
            Check.Equal(1, world.Overlap(near).Length, "in a sphere");
            int found;
            Check.True(!world.TryOverlap(near, null, 0, out found) && found == 1, "no room, but a count");
            near.Position = new Float3(0, 100, 0);
            Check.Equal(0, world.Overlap(near).Length, "in none");

            ColliderMotion motion = ColliderMotion.Create();
            motion.Collider = ground[1];
            motion.Mode = MoveMode.Place;
            motion.Position = new Float3(9, 9, 9);
            world.MoveCollider(motion);
            Check.Equal(new Float3(9, 9, 9), world.GetState(ground[1]).Position, "placed");
            world.MoveColliders(new[] { motion, default(ColliderMotion) }, 1);
            Check.Throws<ArgumentOutOfRangeException>(() => world.MoveColliders(new[] { motion }, 2), "beyond the array");
            ColliderMaterial surface = ColliderMaterial.Create();
            surface.Friction = 3.0f;
            world.SetColliderMaterial(ground, surface);
            Check.Equal(3.0f, world.GetState(ground[1]).Friction, "surface");
            world.SetColliderMaterial(ground[1], ColliderMaterial.Create());
            Check.Equal(0.5f, world.GetState(ground[1]).Friction, "surface");
            world.DestroyColliders(ground);
            Check.Equal(0ul, world.Info.ColliderCount, "destroyed");
        }
    }

    public static void CollidersFromArrays()
    {
        using (var world = new World())
        {
            ColliderDesc desc = ColliderDesc.Create();
            desc.Spacing = new Float2(1, 1);
            ColliderId field = world.CreateHeightfield(desc, new float[] { 1, 1, 1, 1, 1, 1 }, 3);
            Ray ray = Ray.Create();
            ray.Origin = new Float3(0.5f, 10, 0.5f);
            Check.Near(9.0, world.RayCast(ray).Distance, 1e-5, "heightfield");
            Check.Throws<ArgumentException>(() => world.CreateHeightfield(desc, new float[5], 3), "not whole rows");
            world.DestroyCollider(field);
            ColliderId mesh = world.CreateMesh(desc, new[] { new Float3(0, 2, 0), new Float3(0, 2, 2), new Float3(2, 2, 0) }, new uint[] { 0, 1, 2 });
            Check.Near(8.0, world.RayCast(ray).Distance, 1e-5, "mesh");
            Check.Throws<ArgumentException>(() => world.CreateMesh(desc, new Float3[3], new uint[4]), "not whole triangles");
            world.DestroyCollider(mesh);
            desc.Position = new Float3(0.25f, 0, 0.25f);
            world.CreateHull(desc, new[] { new Float3(-1, 0, -1), new Float3(1, 0, -1), new Float3(0, 0, 2), new Float3(0.25f, 3, 0.25f) });
            Check.Equal(ColliderKind.Hull, world.GetState(world.RayCast(ray).Collider).Kind, "hull");
        }
    }

    public static void RigidAssets()
    {
        RigidDesc desc = RigidDesc.Create();
        desc.Mass = 0.002;
        desc.Volume = 1e-6;
        desc.Inertia[0] = desc.Inertia[4] = desc.Inertia[8] = 1e-7;
        desc.Extents = new Double3(0.01, 0.01, 0.01);
        using (Asset asset = Asset.CreateRigid(desc))
        {
            AssetInfo info = asset.Info;
            Check.Equal(0.002, info.Mass, "mass");
            Check.Equal(1e-7, info.Inertia[4], "inertia");
        }
        Aerodynamics none = Aerodynamics.Create();
        using (Asset asset = Asset.CreateRigid(desc, none)) Check.Equal(0.0, asset.Aerodynamics.Drag.X, "coefficients");
        RigidDesc wrong = desc;
        wrong.Mass = -1.0;
        Check.Status(Status.InvalidArgument, () => Asset.CreateRigid(wrong));
    }
}
