// SPDX-License-Identifier: MIT
using System;
using System.Collections.Generic;
using System.Linq;
using LangevinRigid;
using LangevinUnity;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.SceneManagement;

public sealed class WorldTests : Stage
{
    private void Storm(Action<LangevinWorld> set, out ulong hash, out LangevinWorld world)
    {
        var made = new GameObject("storm");
        made.SetActive(false);
        world = made.AddComponent<LangevinWorld>();
        world.Workers = 0;
        set(world);
        made.SetActive(true);
        LangevinWorld mine = world;
        NewBatch(600, b =>
        {
            b.PreferredWorld = mine;
            b.StartCount = 300;
            b.Emitter.rate = 120.0f;
            b.transform.position = new Vector3(0.0f, 20.0f, 0.0f);
        });
        Frames(30);
        hash = world.Hash();
    }

    [Test]
    public void JobsAndWorkersDoNotChangeTheMotion()
    {
        ulong plain, job, workers, seed;
        LangevinWorld w;
        Storm(s => { }, out plain, out w);
        Storm(s => s.StepThread = LangevinStepThread.Job, out job, out w);
        Storm(s => s.Workers = 3, out workers, out w);
        Storm(s => s.Seed = 99, out seed, out w);
        Assert.AreEqual(plain, job);
        Assert.AreEqual(plain, workers);
        Assert.AreNotEqual(plain, seed);
        Silent();
    }

    // test.sh replays these files with lr_replay.
    [Test]
    public void RecordingsAreFiles()
    {
        string folder = Environment.GetEnvironmentVariable("LR_TEST_FOLDER");
        foreach (LangevinStepThread thread in new[] { LangevinStepThread.Main, LangevinStepThread.Job })
        {
            World.StepThread = thread;
            LangevinBatch batch = NewBatch(100);
            string path = System.IO.Path.Combine(folder, thread + ".lrrec");
            World.StartRecording(path);
            Assert.IsTrue(World.Simulation.IsRecording);
            Assert.Throws<InvalidOperationException>(() => World.StartRecording(path));
            batch.Spawn(Vector3.up, Quaternion.identity);
            Frames(20);
            World.StopRecording();
            World.StopRecording();
            Assert.IsFalse(World.Simulation.IsRecording);
            long length = new System.IO.FileInfo(path).Length;
            Assert.Greater(length, 10000);
            Frames(2);
            Assert.AreEqual(length, new System.IO.FileInfo(path).Length);
        }
        Assert.Throws<System.IO.DirectoryNotFoundException>(() => World.StartRecording(folder + "/none/a.lrrec"));
        if (System.IO.File.Exists("/dev/full"))
            Assert.Throws<System.IO.IOException>(() => World.StartRecording("/dev/full"));
        Assert.IsFalse(World.Simulation.IsRecording);
        // A recording that only the world's end stops is complete too.
        World.StartRecording(System.IO.Path.Combine(folder, "left.lrrec"));
        Frames(2);
        World.enabled = false;
        World.enabled = true;
        Frames(2);
        Assert.IsFalse(World.Simulation.IsRecording);
    }

    [Test]
    public void FixedStepsAreThoseOfFixedUpdate()
    {
        World.StepMode = LangevinStepMode.Fixed;
        for (int i = 0; i < 10; ++i) ShimPlayer.FixedFrame();
        Assert.AreEqual(0.2, World.SimulationTime, 1e-7);
        Frames(5);
        Assert.AreEqual(0.2, World.SimulationTime, 1e-7);
        World.StepMode = LangevinStepMode.Frame;
        ShimPlayer.Frame(0.01f);
        Assert.AreEqual(0.21, World.SimulationTime, 1e-7);
        ShimPlayer.Frame(10.0f);
        Assert.AreEqual(0.26, World.SimulationTime, 1e-7, "a hitch is cut");
        ShimPlayer.Frame(0.0f);
        Assert.AreEqual(0.26, World.SimulationTime, 1e-7, "a pause is none");
    }

    [Test]
    public void GravityFollowsThePhysicsSettings()
    {
        LangevinBatch batch = NewBatch(2);
        BodyId body = batch.Spawn(Vector3.zero, Quaternion.identity);
        Physics.gravity = new Vector3(0.0f, 0.0f, 9.81f);
        Frames(20);
        LangevinBodyState state;
        batch.TryGetState(body, out state);
        Assert.Greater(state.velocity.z, 0.1);
        World.Gravity = new Vector3(0.0f, 9.81f, 0.0f);
        Frames(20);
        batch.TryGetState(body, out state);
        Assert.Greater(state.velocity.y, 0.1);
    }

    // In any order of disabling and enabling, nothing is freed twice and all members rejoin.
    [Test]
    public void AnyOrderOfDisabling()
    {
        int count = 0;
        foreach (int[] order in Permutations(new[] { 0, 1, 2, 3 }))
            foreach (bool destroy in new[] { false, true })
            {
                ShimPlayer.Clear();
                World = NewWorld();
                LangevinBatch batch = NewBatch(50, b => { b.StartCount = 20; b.Drawing.mode = LangevinDrawMode.BatchRendererGroup; });
                var wind = new GameObject("wind", typeof(WindZone), typeof(LangevinWind));
                BoxCollider box = Put<BoxCollider>(Vector3.zero);
                World.StepThread = LangevinStepThread.Job;
                Frames(2);
                // A step runs while the first batch is disabled.
                ShimPlayer.Send(World, "Update");
                var all = new[] { World.gameObject, batch.gameObject, wind, box.gameObject };
                foreach (int i in order)
                    if (destroy) UnityEngine.Object.DestroyImmediate(all[i]);
                    else all[i].SetActive(false);
                Assert.AreEqual(0, LangevinSimulation.LivingCount);
                ++count;
                if (destroy) continue;
                foreach (int i in order) all[i].SetActive(true);
                Frames(3);
                Assert.AreEqual(20L, World.BodyCount);
                Assert.AreEqual(1ul, World.Simulation.Info().ColliderCount);
                Assert.IsTrue(World.SampleWind(Vector3.zero).magnitude > 0.5f);
            }
        Assert.AreEqual(48, count);
        Silent();
    }

    private static IEnumerable<int[]> Permutations(int[] of)
    {
        if (of.Length == 1) return new[] { of };
        return of.SelectMany(first => Permutations(of.Where(i => i != first).ToArray()).Select(rest => new[] { first }.Concat(rest).ToArray()));
    }

    [Test]
    public void EnterPlayModeWithoutDomainReload()
    {
        LangevinBatch batch = NewBatch(10, b => b.StartCount = 5);
        Frames(2);
        LangevinInstances left = batch.Instances;
        ShimPlayer.DropScene();
        Assert.AreEqual(1, LangevinSimulation.LivingCount, "statics outlive the session");
        ShimPlayer.EnterPlayModeWithoutReload(typeof(LangevinWorld).Assembly);
        Assert.AreEqual(0, LangevinSimulation.LivingCount);
        Assert.IsNull(LangevinWorld.First);
        left.Dispose();
        World = NewWorld();
        NewBatch(10, b => b.StartCount = 7);
        Frames(2);
        Assert.AreEqual(7L, World.BodyCount);
        Assert.IsTrue(LangevinWorld.First == World);
        Silent();
    }

    [Test]
    public void MembersChooseTheirWorld()
    {
        LangevinWorld second = NewWorld();
        LangevinBatch first = NewBatch(5, b => b.StartCount = 1);
        LangevinBatch preferred = NewBatch(5, b => { b.StartCount = 2; b.PreferredWorld = second; });
        LangevinBatch child = NewBatch(5, b => { b.StartCount = 2; b.transform.SetParent(second.transform); });
        Assert.IsTrue(first.World == World);
        Assert.IsTrue(preferred.World == second);
        Assert.IsTrue(child.World == second);
        Assert.AreEqual(1L, World.BodyCount);
        Assert.AreEqual(4L, second.BodyCount);
        Assert.Throws<ArgumentException>(() => first.SetBodyContact(preferred, true));
        preferred.SetBodyContact(child, true);
    }

    // A level that is loaded beside another one keeps its members when that is unloaded.
    [Test]
    public void MembersJoinTheWorldOfTheirScene()
    {
        Scene before = SceneManager.GetActiveScene();
        SceneManager.SetActiveScene(SceneManager.CreateScene("level"));
        LangevinWorld own = NewWorld();
        LangevinBatch batch = NewBatch(5);
        SceneManager.SetActiveScene(before);
        Assert.IsTrue(batch.World == own);
        Assert.IsTrue(NewBatch(5).World == World);
        World.enabled = false;
        Assert.IsTrue(batch.World == own);
    }

    // Scripts can be reloaded, and sessions end, while a step runs.
    [Test]
    public void DisposingOfAllWaitsForSteps()
    {
        LangevinBatch batch = NewBatch(20000);
        for (int i = 0; i < 20000; ++i) batch.Spawn(new Vector3(0.1f * i, 10.0f, 0.0f), Quaternion.identity);
        World.Substeps = 32;
        World.StepThread = LangevinStepThread.Job;
        ShimPlayer.Send(World, "Update");
        LangevinSimulation.DisposeAll();
        Assert.AreEqual(0, LangevinSimulation.LivingCount);
        Frames(2);
        Silent();
    }

    [Test]
    public void WithoutAWorldThereAreErrorsThatHelp()
    {
        UnityEngine.Object.DestroyImmediate(World.gameObject);
        LangevinBatch batch = NewBatch(5);
        var e = Assert.Throws<InvalidOperationException>(() => batch.Spawn(Vector3.zero, Quaternion.identity));
        Assert.IsTrue(e.Message.Contains("in no world"));
        World = NewWorld();
        batch.Spawn(Vector3.zero, Quaternion.identity);
        World.enabled = false;
        Assert.Throws<InvalidOperationException>(() => World.Hash());
    }

    [Test]
    public void EventsArriveWithTheirBatchAndCollider()
    {
        BoxCollider floor = Put<BoxCollider>(new Vector3(0.0f, -0.5f, 0.0f), b => b.size = new Vector3(50.0f, 1.0f, 50.0f));
        LangevinBatch batch = NewBatch(20);
        World.SetEvents(1000, (EventKinds)uint.MaxValue);
        var seen = new List<LangevinEvent>();
        int byBatch = 0, byCollider = 0, byInspector = 0;
        World.Happened += seen.Add;
        World.OnEvent.AddListener(e => ++byInspector);
        batch.Happened += e => ++byBatch;
        floor.GetComponent<LangevinCollider>().Happened += e => ++byCollider;
        for (int i = 0; i < 10; ++i) batch.Spawn(new Vector3(i - 5, 0.3f, 3.0f), Quaternion.Euler(90.0f, 0.0f, 0.0f));
        Frames(240);
        LangevinEvent begin = seen.First(e => e.kind == EventKind.Hit);
        Assert.IsTrue(begin.batch == batch && begin.collider == floor.GetComponent<LangevinCollider>());
        Assert.AreEqual(0.0, begin.position.y, 0.02);
        Assert.AreEqual(3.0, begin.position.z, 1.0);
        Near(Vector3.up, begin.normal, 0.01);
        Assert.Greater(seen.Count(e => e.kind == EventKind.Landed), 7.0);
        Assert.AreEqual(seen.Count, byBatch);
        Assert.AreEqual(seen.Count, byInspector);
        Assert.AreEqual(seen.Count(e => e.collider != null), byCollider);
        Assert.AreEqual(0L, World.LostEvents);
        Silent();
        // An exception of a handler is reported, and other handlers still run.
        World.Happened += e => { throw new InvalidOperationException("handler"); };
        int before = seen.Count;
        World.WakeBox(new Bounds(Vector3.zero, Vector3.one * 20.0f));
        Frames(2);
        Assert.Greater(seen.Count, before);
        Assert.Greater(Complaints("handler"), 0);
    }

    [Test]
    public void HandlersMayChangeTheWorld()
    {
        Put<BoxCollider>(new Vector3(0.0f, -0.5f, 0.0f), b => b.size = new Vector3(50.0f, 1.0f, 50.0f));
        LangevinBatch batch = NewBatch(20);
        World.SetEvents(100, EventKinds.Hit);
        World.Happened += e =>
        {
            batch.Despawn(e.body);
            if (batch.Count < 5) batch.Spawn(new Vector3(0.0f, 5.0f, 0.0f), Quaternion.identity);
        };
        for (int i = 0; i < 5; ++i) batch.Spawn(new Vector3(i, 0.1f, 0.0f), Quaternion.identity);
        Frames(40);
        Assert.AreEqual(5, batch.Count);
        Silent();
    }

    [Test]
    public void HandlersMayStepTheWorld()
    {
        Put<BoxCollider>(new Vector3(0.0f, -0.5f, 0.0f), b => b.size = new Vector3(50.0f, 1.0f, 50.0f));
        LangevinBatch batch = NewBatch(20);
        World.SetEvents(100, EventKinds.All);
        int seen = 0, within = 0;
        bool steps = false;
        World.Happened += e =>
        {
            ++seen;
            Assert.IsTrue(e.batch == batch);
            if (steps) ++within;
            if (steps || within > 0) return;
            steps = true;
            for (int i = 0; i < 60; ++i) World.Step(1.0f / 60.0f);
            steps = false;
        };
        for (int i = 0; i < 5; ++i) batch.Spawn(new Vector3(i, 0.1f, 0.0f), Quaternion.identity);
        Frames(40);
        Assert.Greater(within, 0);
        Assert.Greater(seen, within + 1);
        Silent();
    }

    [Test]
    public void SnapshotsPutBackWhatWas()
    {
        LangevinBatch batch = NewBatch(50, b => b.StartCount = 30);
        Frames(10);
        byte[] saved = World.SaveSnapshot();
        ulong then = World.Hash();
        Matrix4x4 m = batch.Instances.Matrices[3];
        Frames(10);
        Assert.AreNotEqual(then, World.Hash());
        World.RestoreSnapshot(saved);
        Assert.AreEqual(then, World.Hash());
        World.Present();
        Near(m.MultiplyPoint3x4(Vector3.one), batch.Instances.Matrices[3].MultiplyPoint3x4(Vector3.one), 0.0);
        var e = Assert.Throws<LangevinException>(() => World.RestoreSnapshot(new byte[10]));
        Assert.AreEqual(Status.SnapshotFormat, e.Status);
    }

    // A snapshot has the colliders and winds of its time; those of the scene are others by then.
    [Test]
    public void AfterASnapshotCollidersAndWindsAreThoseOfTheScene()
    {
        BoxCollider lift = Put<BoxCollider>(Vector3.zero), crate = Put<BoxCollider>(new Vector3(10.0f, 0.0f, 0.0f));
        var gale = new GameObject("gale", typeof(WindZone), typeof(LangevinWind));
        var zone = gale.GetComponent<WindZone>();
        zone.windMain = 0.0f;
        zone.mode = WindZoneMode.Spherical;
        zone.radius = 4.0f;
        zone.windPulseMagnitude = 0.0f;
        Func<float, float> top = x => World.Raycast(new Vector3(x, 50.0f, 0.0f), Vector3.down, 100.0f, out LangevinRayHit hit) ? hit.position.y : -1.0f;
        Func<Vector3, float> wind = at => World.SampleWind(at).x;
        Frames(2);
        byte[] calm = World.SaveSnapshot();
        zone.windMain = 3.0f;
        zone.windTurbulence = 0.0f;
        Frames(2);
        byte[] windy = World.SaveSnapshot();
        float blown = wind(new Vector3(1.0f, 0.0f, 0.0f));
        Assert.Greater(blown, 1.0);
        BoxCollider later = Put<BoxCollider>(new Vector3(20.0f, 0.0f, 0.0f));
        lift.transform.position = new Vector3(0.0f, 3.0f, 0.0f);
        UnityEngine.Object.DestroyImmediate(crate.gameObject);
        Frames(3);
        foreach (byte[] snapshot in new[] { calm, windy, calm, windy })
        {
            World.RestoreSnapshot(snapshot);
            Frames(3);
            Assert.AreEqual(3.5, top(0.0f), 1e-3, "the lift is where the scene has it");
            Assert.AreEqual(-1.0, top(10.0f), 0.0, "the crate is gone");
            Assert.AreEqual(0.5, top(20.0f), 1e-3, "and the later box is there");
            Assert.AreEqual(blown, wind(new Vector3(1.0f, 0.0f, 0.0f)), 1e-4);
        }
        // Winds that are no more, and such that have moved.
        gale.transform.position = new Vector3(30.0f, 0.0f, 0.0f);
        World.RestoreSnapshot(windy);
        Frames(2);
        Assert.AreEqual(blown, wind(new Vector3(31.0f, 0.0f, 0.0f)), 1e-4);
        Assert.AreEqual(0.0, wind(new Vector3(1.0f, 0.0f, 0.0f)), 0.0);
        zone.mode = WindZoneMode.Directional;
        zone.windTurbulence = 1.0f;
        Frames(2);
        byte[] eddies = World.SaveSnapshot();
        zone.windMain = 0.0f;
        Frames(2);
        World.RestoreSnapshot(eddies);
        Frames(2);
        Assert.AreEqual(0.0, wind(new Vector3(1.0f, 0.0f, 0.0f)), 0.0);
        Assert.IsTrue(later != null);
        Silent();
    }

    [Test]
    public void BudgetsAndLevelsOfDetail()
    {
        LangevinBatch near = NewBatch(100, b => b.StartCount = 100);
        LangevinBatch far = NewBatch(100, b => b.StartCount = 100);
        Frames(1);
        Assert.AreEqual(400ul, World.LastStep().BodySubsteps);
        far.Divisor = 2;
        far.Apply();
        Frames(1);
        Assert.AreEqual(300ul, World.LastStep().BodySubsteps);
        World.SetBudget(100);
        Frames(2);
        Assert.IsTrue(World.LastStep().BodySubsteps <= 200ul);
        World.SetBudget(0);
        far.Divisor = 1;
        far.Apply();
        Frames(3);
        Assert.AreEqual(400ul, World.LastStep().BodySubsteps);
        Assert.AreEqual(100, near.Count);
    }

    [Test]
    public void RaysHitBodiesWhereTheyAre()
    {
        LangevinBatch batch = NewBatch(5);
        BodyId body = batch.Spawn(new Vector3(2.0f, 5.0f, 3.0f), Quaternion.Euler(90.0f, 0.0f, 0.0f));
        LangevinRayHit hit;
        Assert.IsTrue(World.Raycast(new Vector3(2.0f, 10.0f, 3.0f), Vector3.down, 100.0f, out hit));
        Assert.AreEqual(body, hit.body);
        Assert.AreEqual(5.0, hit.distance, 0.05);
        Assert.AreEqual(3.0, hit.position.z, 1e-4);
        Assert.IsFalse(World.Raycast(new Vector3(2.0f, 10.0f, -3.0f), Vector3.down, 100.0f, out hit));
        batch.SetSleep(body, true);
        Assert.AreEqual(0, World.WakeBox(new Bounds(new Vector3(2.0f, 5.0f, -3.0f), Vector3.one)));
        Assert.AreEqual(1, World.WakeBox(new Bounds(new Vector3(2.0f, 5.0f, 3.0f), Vector3.one)));
    }
}
