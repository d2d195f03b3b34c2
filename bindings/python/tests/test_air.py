# SPDX-License-Identifier: MIT
"""Wind, callbacks, water, colliders, events, queries, rules; and memory under garbage collection."""
import concurrent.futures
import copy
import gc
import logging
import os
import signal
import sys
import threading
import time
import unittest
import weakref

import numpy as np
from support import WorldCase, lr, thin_leaf


class Wind(WorldCase):
    def setUp(self):
        super().setUp()
        signal.signal(signal.SIGINT, signal.default_int_handler)  # a shell's background jobs ignore it

    def test_sources_blow_as_they_say(self):
        self.world.set_uniform_wind((3, 0, 1))
        np.testing.assert_allclose(self.world.sample_wind((5, 5, 5)), [3, 0, 1])
        np.testing.assert_allclose(self.world.uniform_wind, [3, 0, 1])
        self.world.set_uniform_wind((0, 0, 0))
        with self.assertRaisesRegex(ValueError, "velocity: .* 3"):
            self.world.set_uniform_wind(3)
        swirl = self.world.add_vortex(core=lr.VortexCore.RANKINE, circulation=2 * np.pi, core_radius=0.5)
        np.testing.assert_allclose(self.world.sample_wind([[1, 0, 0], [0, 3, 2]]), [[0, 0, -1], [0.5, 0, 0]], atol=1e-5)
        swirl.update(circulation=4 * np.pi)
        np.testing.assert_allclose(self.world.sample_wind([1, 0, 0]), [0, 0, -2], atol=1e-5)
        self.assertEqual((swirl.get()["core"], swirl.get()["axis"]), (lr.VortexCore.RANKINE, (0, 1, 0)))
        swirl.remove()
        for kind in ("gusts", "blower", "turbulence", "ground_wind"):
            source = getattr(self.world, f"add_{kind}")()
            self.assertNotIn("struct_size", source.get())
            source.remove()
        grid = np.zeros((2, 3, 4, 3), np.float32)  # z, y, x
        grid[..., 0] = np.arange(4)
        grid[..., 2] = np.arange(2)[:, None, None]
        source = self.world.add_wind_grid(samples=grid, spacing=(1, 1, 1))
        np.testing.assert_allclose(self.world.sample_wind([[1.5, 1, 0.25], [3, 2, 1]]), [[1.5, 0, 0.25], [3, 0, 1]], atol=1e-6)
        source.update(position=(10, 0, 0))
        np.testing.assert_allclose(self.world.sample_wind([11.5, 1, 0.25]), [1.5, 0, 0.25], atol=1e-6)
        with self.assertRaises(ValueError):
            self.world.add_wind_grid(samples=np.zeros((3, 3)))

    def test_an_update_does_not_move_a_source_back(self):
        source = self.world.add_vortex(circulation=6, core_radius=0.3, velocity=(10, 0, 0))
        self.world.step(1)
        source.update(circulation=12)
        self.assertEqual(source.get()["position"], (10, 0, 0))
        self.assertLess(self.world.sample_wind((10.3, 0, 0))[2], -4)

    def test_a_callback_in_numpy_is_a_field(self):
        asked = []

        def shear(query):
            x, y, z = query.position
            asked.append((query.count, query.batch, query.position.shape))
            query.velocity = (2 * y, 0 * y, 0 * y)
            query.gradient[0, 1] = 2

        self.world.set_wind_callback(shear)
        np.testing.assert_allclose(self.world.sample_wind([[0, 3, 0], [0, -1, 4]]), [[6, 0, 0], [-2, 0, 0]])
        self.assertEqual({batch for _, batch, _ in asked}, {0})
        self.batch.create(40, position=(0, 2, 0))
        self.fall()
        self.assertIn(self.batch.id, {batch for _, batch, _ in asked})
        self.assertTrue(all(shape == (3, count) for count, _, shape in asked))
        self.world.set_wind_callback(None)
        np.testing.assert_allclose(self.world.sample_wind([0, 3, 0]), 0)

    def test_a_constant_field_is_uniform_wind(self):
        paths = []
        for callback in (False, True):
            with lr.World(seed=1) as world:
                batch = world.create_batch(thin_leaf(), 3)
                batch.create(3)
                if callback:
                    world.set_wind_callback(lambda query: setattr(query, "velocity", (4, 0, 0)))
                else:
                    world.set_uniform_wind((4, 0, 0))
                for _ in range(30):
                    world.step(1 / 60, 2)
                paths.append(batch.view().position.stack())
        np.testing.assert_allclose(paths[0], paths[1], rtol=1e-5, atol=1e-5)

    def test_exceptions_of_callbacks_are_raised_after_the_call(self):
        calls = []

        def fails(query):
            calls.append(query.count)
            raise ZeroDivisionError("of the field")

        self.batch.create(60)
        self.world.set_wind_callback(fails)
        with self.assertRaisesRegex(ZeroDivisionError, "of the field"):
            self.world.step(1 / 60, 4)
        self.assertEqual(len(calls), 1)  # it is not called again
        self.assertAlmostEqual(self.world.time, 1 / 60, places=6)  # the step is done
        for raised in (KeyboardInterrupt, SystemExit):
            def stops(query, raised=raised):
                raise raised

            self.world.set_wind_callback(stops)
            with self.assertRaises(raised):
                self.world.sample_wind((0, 0, 0))
        self.world.set_wind_callback(None)
        self.fall()
        with self.assertRaises(ValueError):
            self.world.set_wind_callback(lambda query: setattr(query, "velocity", np.zeros((2, query.count))))
            self.fall()
        with self.assertRaises(TypeError):
            self.world.set_wind_callback(3)

    def test_a_callback_that_calls_its_world_is_told(self):
        self.batch.create(1)
        self.world.set_wind_callback(lambda query: self.world.info)
        with self.assertRaises(lr.BusyError):
            self.fall()

    def test_kept_queries_are_harmless(self):
        kept = []
        self.batch.create(10, position=(1, 2, 3))
        self.world.set_wind_callback(kept.append)
        self.fall(3)
        np.testing.assert_allclose(kept[0].position[0], 1)
        with self.assertRaises(ValueError):
            kept[0].velocity

    def test_wind_out_of_range_is_logged(self):
        self.batch.create(2)
        self.world.set_wind_callback(lambda query: setattr(query, "velocity", (5000, 0, 0)))
        with self.assertLogs("langevin_rigid", logging.WARNING):
            self.fall()
        said = []
        with lr.World(log=lambda level, text: said.append((level, text))) as world:
            with self.assertRaises(lr.InvalidArgumentError):
                world.create_batch(thin_leaf(), 0)
        self.assertEqual(said[0][0], lr.LogLevel.ERROR)
        self.assertIn("capacity", said[0][1])

    @unittest.skipIf(sys.platform == "win32", "os.kill ends the process there")
    def test_an_interrupt_during_a_step_is_raised_after_it(self):
        batch = self.world.create_batch(thin_leaf(), 5000)
        batch.create(5000)
        self.world.set_wind_callback(lambda query: None)
        self.world.step(1 / 60, 40)
        raised = 0
        for _ in range(6):
            timer = threading.Timer(0.01, os.kill, (os.getpid(), signal.SIGINT))
            try:
                timer.start()
                self.world.step(1 / 60, 40)
                time.sleep(5)  # where it is raised if the step was shorter
            except KeyboardInterrupt:
                raised += 1
            timer.join()
            self.assertIs(signal.getsignal(signal.SIGINT), signal.default_int_handler)
        self.assertEqual(raised, 6)

    @unittest.skipIf(sys.platform == "win32", "os.kill ends the process there")
    def test_an_interrupt_is_not_lost_in_the_end_of_a_world(self):
        def interrupts(_):
            os.kill(os.getpid(), signal.SIGINT)

        self.batch.create(1)
        self.world.set_wind_callback(interrupts)
        gc.disable()
        self.addCleanup(gc.enable)
        try:  # assertRaises would empty the frames
            self.fall()
        except KeyboardInterrupt:
            pass
        ended = weakref.ref(self.world._handle)
        self.world.close()
        self.assertIsNone(ended())  # a garbage collection would end it in the middle of other code, where Ctrl-C is lost
        world = lr.World()
        destroy = world._handle.destroy
        world._handle.destroy = lambda pointer: (destroy(pointer), interrupts(None))
        with self.assertRaises(KeyboardInterrupt):
            world.close()

    def test_an_interrupt_at_any_call_leaves_the_world_usable(self):
        self.batch.create(1)
        for use in (self.fall, self.world.hash, self.world.save):
            for last in range(200):
                left = last + 1

                def interrupt(_, event, __):  # where Python raises Ctrl-C: as a function begins, and after one in C
                    nonlocal left
                    left -= event in ("call", "c_return")
                    if left == 0:
                        raise KeyboardInterrupt

                sys.setprofile(interrupt)
                try:
                    use()
                except KeyboardInterrupt:
                    pass
                finally:
                    sys.setprofile(None)
                self.world.hash()
            self.assertGreater(left, 0)

    @unittest.skipIf(sys.platform == "win32", "os.kill ends the process there")
    def test_callbacks_stay_when_the_call_that_gave_them_raises(self):
        def interrupts_once(_):
            written.append(1)
            if len(written) == 1:
                os.kill(os.getpid(), signal.SIGINT)

        def refuses_when_full(_):
            if full:
                raise OSError("disk full")

        self.batch.create(1)
        written, asked, full = [], [], False
        with self.assertRaises(KeyboardInterrupt):
            self.world.record_start(interrupts_once)
        count = len(written)
        with self.assertRaises(lr.InvalidArgumentError):
            self.world.record_start(refuses_when_full)
        self.fall(100)
        self.assertGreater(len(written), count)
        self.world.record_stop()
        self.world.record_start(refuses_when_full)
        full = True
        with self.assertRaises(OSError):
            self.world.set_wind_callback(lambda query: asked.append(query.count))
        self.fall(100)
        self.assertTrue(asked)

    def test_workers_and_executors_give_the_same_bits(self):
        def run(callback, **options):
            with lr.World(seed=2, **options) as world:
                batch = world.create_batch(thin_leaf(), 5000)
                batch.create(position=np.random.default_rng(3).random((5000, 3)))
                if callback:
                    world.set_wind_callback(lambda query: setattr(query, "velocity", query.position[::-1]))
                for _ in range(5):
                    world.step(1 / 60, 2)
                return world.hash()

        for callback in (False, True):
            wanted = run(callback)
            self.assertEqual(run(callback, worker_count=3), wanted)
            with concurrent.futures.ThreadPoolExecutor(2) as pool:
                self.assertEqual(run(callback, worker_count=2, executor=pool), wanted)
                with lr.World(executor=pool) as world:
                    self.assertEqual(world.info.worker_count, 2)
            pool = concurrent.futures.ThreadPoolExecutor(1)
            pool.shutdown()
            with self.assertRaisesRegex(RuntimeError, "shutdown"):
                run(callback, worker_count=2, executor=pool)

    def test_one_thread_at_a_time(self):
        inside, go = threading.Event(), threading.Event()

        def waits(query):
            inside.set()
            go.wait(10)

        self.batch.create(1)
        self.world.set_wind_callback(waits)
        thread = threading.Thread(target=lambda: self.world.step(1 / 60))
        thread.start()
        self.assertTrue(inside.wait(10))
        with self.assertRaises(lr.BusyError):
            self.world.step(1 / 60)
        go.set()
        thread.join()
        self.fall()


class Water(WorldCase):
    def test_light_bodies_float_on_waves(self):
        cork = self.world.create_batch(lr.Asset.ellipsoid(semi_axes=(0.05, 0.05, 0.05), density=300), 4)
        cork.create(position=(0, -0.5, 0))
        self.assertIsNone(self.world.water)
        self.assertIsNone(self.world.water)
        self.world.set_water(position=(0, 1, 0), waves=[{"direction": (1, 0, 0), "length": 20, "amplitude": 0.01}])
        self.assertEqual((self.world.water.wave_count, self.world.water.waves[0]["length"]), (1, 20))
        self.assertEqual((self.world.water.wave_count, self.world.water.waves[0]["length"]), (1, 20))
        for _ in range(400):
            self.world.step(1 / 60, 4)
        self.assertAlmostEqual(float(cork.view().position.y[0]), 1, delta=0.1)
        asked = []

        def lifted(query):
            asked.append(query.count)
            query.height = query.height + 0.5

        self.world.set_water(position=(0, 1, 0), reach=1)
        self.world.set_water_callback(lifted)
        for _ in range(400):
            self.world.step(1 / 60, 4)
        self.assertTrue(asked)
        self.assertAlmostEqual(float(cork.view().position.y[0]), 1.5, delta=0.1)
        self.world.set_water_callback(None)
        self.world.remove_surface()
        self.world.step(1 / 60)
        with self.assertRaises(ValueError):
            self.world.set_water(waves=[{}] * 9)


class Contact(WorldCase):
    def test_leaves_land_and_say_so(self):
        ground = self.world.add_plane(friction=0.7)
        self.world.keep_events(1000)
        ids = self.batch.create(10, position=[(i, 0.3, 0) for i in range(10)])
        landed, begun = set(), []
        for _ in range(600):
            self.fall()
            events = self.world.events
            landed |= set(events.of(lr.EventKind.LANDED)["body"].tolist())
            begun.extend(events.of(lr.EventKind.HIT))
        self.assertEqual(landed, set(ids.tolist()))
        self.assertGreaterEqual(len(begun), 10)
        self.assertEqual({int(e["collider"]) for e in begun}, {ground.id})
        np.testing.assert_allclose(begun[0]["normal"], [0, 1, 0], atol=1e-6)
        self.assertEqual(self.world.events.lost, 0)
        self.assertEqual(self.world.info.awake_count, 0)

    def test_shapes_are_where_they_are_put(self):
        w = self.world
        w.add_sphere((0, 0, 0), 1)
        w.add_box((10, 0, 0), (1, 2, 3))
        w.add_capsule((20, 0, 0), 0.5, 2)
        w.add_mesh([(29, 3, -1), (31, 3, -1), (30, 3, 2)], [(0, 1, 2)])
        w.add_hull(np.array([(x, y, z) for x in (-1, 1) for y in (-4, 4) for z in (-1, 1)], float), position=(40, 0, 0))
        w.add_heightfield(np.full((3, 4), 5.0), spacing=(2, 2), position=(48, 0, -2))
        w.add_plane((0, -7, 0), (0, 1, 0))
        w.step(0.01)
        hits = w.ray_cast([(x, 50, 0) for x in (0, 10, 20, 30, 40, 50, 60)], (0, -1, 0))
        np.testing.assert_allclose(hits["position"][:, 1], [1, 2, 2.5, 3, 4, 5, -7], atol=1e-4)
        np.testing.assert_allclose(hits["normal"], np.tile((0, 1, 0), (7, 1)), atol=1e-3)
        self.assertTrue((hits["collider"] != 0).all())
        missed = w.ray_cast((0, 50, 0), (0, 1, 0))
        self.assertEqual((int(missed["collider"][0]), int(missed["body"][0])), (0, 0))
        for wrong in ({"indices": [0, 1], "vertices": np.zeros((3, 3))}, {"vertices": np.zeros(4), "indices": []}):
            with self.assertRaises(ValueError):
                w.add_collider(lr.ColliderKind.MESH, **wrong)

    def test_slanted_planes_stand_as_told(self):
        for normal in ((1, 2, 3), (0, -1, 0), (0, 0, 1), (-1, 0.001, 0)):
            with lr.World() as world:
                world.add_plane((1, 1, 1), normal)
                world.step(0.01)
                unit = np.array(normal) / np.linalg.norm(normal)
                hit = world.ray_cast(np.array([1, 1, 1]) + 5 * unit, -unit)
                self.assertAlmostEqual(float(hit["distance"][0]), 5, places=3)
                np.testing.assert_allclose(hit["normal"][0], unit, atol=1e-3)

    def test_colliders_move(self):
        ball = self.world.add_sphere((0, 0, 0), 1)
        ball.move_to((3, 0, 0))
        self.world.step(0.1)
        np.testing.assert_allclose(ball.state.position, [3, 0, 0])
        ball.place(linear_velocity=(1, 0, 0))
        self.world.step(0.5)
        np.testing.assert_allclose(ball.state.position, [3.5, 0, 0], atol=1e-6)
        ball.set_velocity()
        ball.set_material(friction=0.9)
        self.assertAlmostEqual(ball.state.friction, 0.9, places=6)
        self.assertAlmostEqual(ball.state.restitution, 0.2, places=6)
        self.world.move_colliders([ball], (7, 7, 7), mode=lr.MoveMode.PLACE)
        self.world.step(0.1)
        np.testing.assert_allclose(ball.state.position, [7, 7, 7])

    def test_overlaps_and_pairs(self):
        ids = self.batch.create(position=[(0, 0, 0), (0.5, 0, 0), (9, 0, 0)])
        self.assertEqual(set(self.world.overlap_sphere((0, 0, 0), 1).tolist()), set(ids[:2].tolist()))
        self.assertEqual(self.world.overlap_box((9, 0, 0), (0.1, 0.1, 0.1), batch=self.batch).tolist(), [int(ids[2])])
        hits = self.world.ray_cast((9, 1, 0), (0, -1, 0), flags=lr.RayFlags.BODIES)
        self.assertEqual(int(hits["body"][0]), int(ids[2]))
        self.assertFalse(self.batch.body_contact(self.batch))
        self.batch.set_body_contact(self.batch)
        self.assertTrue(self.batch.body_contact(self.batch))
        self.batch.set_contact(friction=0.8, flags=lr.ContactFlags.NEVER_SLEEP)
        self.assertAlmostEqual(self.batch.contact.friction, 0.8, places=6)
        self.batch.set_contact()
        self.assertAlmostEqual(self.batch.contact.friction, 0.5, places=6)

    def test_more_overlaps_than_room_was_made_for(self):
        many = self.world.create_batch(thin_leaf(), 1000)
        ids = many.create(1000)
        self.assertEqual(set(self.world.overlap_sphere((0, 0, 0), 1).tolist()), set(ids.tolist()))
        self.assertEqual(self.world.overlap_sphere((0, 0, 0), 1, batch=self.batch).tolist(), [])  # an empty batch is a batch


class Storms(WorldCase):
    def test_a_box_is_filled_without_an_emitter(self):
        ids = self.batch.spawn_box((-1, 2, -1), (1, 3, 1), 5)
        self.assertEqual(sorted(ids.tolist()), sorted(self.batch.ids.tolist())[-5:])
        self.assertTrue(all(2 <= self.world.state(body).position[1] <= 3 for body in ids))
        with self.assertRaises(lr.Error):
            self.batch.spawn_box((0, 1, 0), (0, 0, 0), 1)

    def test_births_and_ends(self):
        self.batch.set_rules(max_age=0.2, volumes=[{"shape": lr.VolumeShape.PLANE, "center": (0, -9, 0), "size": (0, 1, 0)}])
        self.assertIsNone(self.batch.emitter)
        self.batch.set_emitter(rate=120, spread=0.3, speed_max=1.0)
        self.assertEqual((self.batch.emitter.rate, self.batch.rules.volume_count), (120, 1))
        for wrong in ({"capacity": 2**32}, {"capacity": -1}, {"capacity": 10, "kinds": 2**32 + 1}):
            with self.assertRaises(OverflowError):
                self.world.keep_events(**wrong)
        self.world.keep_events()
        spawned = 0
        for _ in range(30):
            self.fall()
            counts, events = self.batch.counts, self.world.events
            born = events.of(lr.EventKind.SPAWNED)["body"].tolist()
            self.assertEqual(len(born), counts.spawned)
            self.assertEqual(len(events.of(lr.EventKind.KILLED)), counts.destroyed)
            self.assertTrue(set(born) <= set(self.batch.ids.tolist()))
            spawned += counts.spawned
        self.assertEqual((spawned, counts.total_spawned), (60, 60))
        self.assertGreater(counts.total_destroyed, 20)
        self.assertEqual(len(self.batch.emit(5)), 5)
        self.batch.set_emitter()
        self.batch.set_rules()
        with self.assertRaises(lr.InvalidArgumentError):
            self.batch.emit(1)

    def test_bodies_that_leave_physics(self):
        calm = self.world.create_batch(thin_leaf(), 10, load_model=lr.LoadModel.NONE)
        self.world.keep_events(100)
        self.assertEqual(calm.divergence_policy, lr.DivergencePolicy.AUTO)
        ids = calm.create(position=[(0, 0, 0), (1, 0, 0), (2, 0, 0)])
        for policy, left in ((lr.DivergencePolicy.FREEZE, 3), (lr.DivergencePolicy.REMOVE, 2)):
            calm.divergence_policy = policy
            body = ids[0 if policy == lr.DivergencePolicy.FREEZE else 1]
            self.world.add_forces([int(body)] * 50, (1e9, 0, 0), mode=lr.ForceMode.ACCELERATION)
            self.world.step(1 / 60)
            told = self.world.events.of(lr.EventKind.DIVERGED)
            self.assertEqual(told["body"].tolist(), [int(body)])
            self.assertEqual((calm.counts.diverged, len(calm.ids)), (1, left))
        self.assertEqual(self.world.state(ids[0]).sleep_state, lr.SleepState.HELD)
        self.assertEqual(calm.counts.total_diverged, 2)
        with self.assertRaises(lr.InvalidArgumentError):
            calm.divergence_policy = 9

    def test_rates_and_budgets(self):
        self.batch.create(10)
        self.batch.set_rate(4)
        self.world.set_budget(1000)
        self.fall(4)
        self.assertEqual(self.batch.pace.divisor, 4)
        self.assertEqual(self.world.step_report.batches_passed_over, 0)
        self.world.set_budget(0)
        self.batch.set_rate(1)
        self.batch.set_load_gains(drag=2)
        self.batch.set_aerodynamics(intensity=0)
        self.assertEqual(self.batch.aerodynamics.intensity, 0)
        self.batch.set_aerodynamics()
        self.assertEqual(self.batch.aerodynamics.intensity, self.batch.asset.aerodynamics.intensity)
        own = self.batch.turbulence_table
        self.assertEqual(len(own["chi"]), self.batch.asset.info.turbulence_count)
        self.batch.set_turbulence_table(chi=[1, 2], epsilon=[3, 4], dt=0.1, u0=1, l=0.01)
        read = self.batch.turbulence_table
        self.assertEqual((read["chi"].tolist(), read["epsilon"].tolist(), read["u0"], read["c0"]), ([1, 2], [3, 4], 1, 6.5))
        self.batch.set_turbulence_table(**read)
        self.batch.set_turbulence_table()
        np.testing.assert_array_equal(self.batch.turbulence_table["epsilon"], own["epsilon"])
        with self.assertRaises(ValueError):
            self.batch.set_turbulence_table(chi=[1, 2], epsilon=[3], dt=0.1, u0=1, l=0.01)

    def test_instruction_sets_agree(self):
        hashes = set()
        for target in lr.simd_targets():
            with lr.World(seed=1, simd_target=target) as world:
                self.assertIs(world.info.simd_target, target)
                batch = world.create_batch(thin_leaf(), 50)
                batch.create(50)
                for _ in range(20):
                    world.step(1 / 60, 2)
                hashes.add(world.hash())
        self.assertEqual(len(hashes), 1)
        self.assertEqual(lr.simd_target_name(lr.SimdTarget.AVX2), "AVX2")


class Garbage(unittest.TestCase):
    def test_a_copied_asset_has_its_own_reference(self):
        asset = thin_leaf()
        copied = copy.copy(asset)
        copied.close()
        others = [lr.Asset.ellipsoid(semi_axes=(1, 1, 1), density=8.0) for _ in range(8)]  # where a freed one would have been
        with lr.World() as world:
            drag = world.create_batch(asset, 1).aerodynamics.drag
        self.assertEqual(drag.tolist(), thin_leaf().aerodynamics.drag.tolist())
        self.assertEqual(len(others), 8)
        asset.close()
        with self.assertRaises(lr.ClosedError):
            copy.copy(asset)

    def test_worlds_batches_and_callbacks_under_collection(self):
        """Collects garbage at nearly every allocation, while only the library refers to the callbacks."""
        before = gc.get_threshold()
        gc.set_threshold(1)
        try:
            arrays = []
            for turn in range(40):
                world = lr.World(seed=turn, log=lambda level, text: None)
                batch = world.create_batch(thin_leaf(), 32)
                batch.create(32, position=(turn, 0, 0))

                def field(query, world=world):  # a cycle: world, callback, world
                    query.velocity = (1, 0, 0)

                world.set_wind_callback(field)
                del field
                gc.collect()
                world.step(1 / 60, 2)
                world.set_wind_callback(lambda query: None)
                world.step(1 / 60, 2)
                arrays.append(batch.view().position.x)
                if turn % 3 == 0:
                    world.close()
                del world, batch
        finally:
            gc.set_threshold(*before)
        gc.collect()
        for turn, x in enumerate(arrays):
            np.testing.assert_allclose(x, turn, atol=0.5)

    def test_worlds_are_freed(self):
        world = lr.World()
        batch = world.create_batch(thin_leaf(), 10)
        batch.create(10)
        world.set_wind_callback(lambda query, w=world: None)
        handle = weakref.ref(world._handle)
        x = batch.view().position.x
        del world, batch
        gc.collect()
        self.assertIsNotNone(handle())  # an array still uses it
        del x
        gc.collect()
        self.assertIsNone(handle())


if __name__ == "__main__":
    unittest.main()
