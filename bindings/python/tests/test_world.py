# SPDX-License-Identifier: MIT
"""Worlds, bodies, views, transforms, forces, snapshots."""
import copy
import ctypes
import pickle
import time
import unittest

import numpy as np
from support import WORK, WorldCase, lr, thin_leaf

from langevin_rigid import _native as native
from langevin_rigid.view import turned


class Hello(unittest.TestCase):
    def test_the_same_bits_as_from_c(self):
        """samples/hello.c call for call; test.sh compiles that and passes its hash."""
        import os
        wanted = os.environ.get("LR_TEST_HELLO_HASH")
        if not wanted:
            self.skipTest("no hash of samples/hello.c")
        bodies = np.arange(6, dtype=np.float32)
        orientation = np.zeros((6, 4), np.float32)
        orientation[:, 0], orientation[:, 1], orientation[:, 3] = -1, np.float32(0.15) * bodies, 1
        position = np.zeros((6, 3), np.float32)
        position[:, 0], position[:, 1] = np.float32(0.5) * bodies, 10
        with lr.World(seed=1) as world:
            batch = world.create_batch(thin_leaf(), 6)
            batch.create(position=position, orientation=orientation)
            for _ in range(120):
                world.step(np.float32(1) / np.float32(60), 4)
            self.assertEqual(f"{world.hash():016x}", wanted)


class Views(WorldCase):
    def test_arrays_are_the_librarys_memory(self):
        self.batch.create(position=np.random.default_rng(1).random((20, 3)), user=7)
        view, struct = self.batch.view(), native.lr_batch_view()
        struct.struct_size = ctypes.sizeof(struct)
        self.world._ask("lr_batch_get_view", self.batch.id, ctypes.byref(struct))
        for name, width in (("position", 3), ("orientation", 4)):
            for part, pointer in zip(getattr(view, name), getattr(struct, name)):
                self.assertEqual(part.ctypes.data, ctypes.cast(pointer, ctypes.c_void_p).value)
                self.assertEqual((part.dtype, part.shape, part.flags.writeable), (np.float32, (20,), False))
            self.assertEqual(getattr(view, name).stack().shape, (20, width))
        for name, kind in (("scale", np.float32), ("age", np.float32), ("noise_seed", np.uint32), ("ids", np.uint64), ("user", np.uint64)):
            part = getattr(view, name)
            self.assertEqual(part.ctypes.data, ctypes.cast(getattr(struct, name), ctypes.c_void_p).value)
            self.assertEqual((part.dtype, part.shape), (kind, (20,)))
        self.assertEqual((len(view), view.capacity, view.awake_count), (20, 64, 20))
        with self.assertRaises(ValueError):
            view.position.x[0] = 1

    def test_values_are_those_of_single_bodies(self):
        ids = self.batch.create(position=np.random.default_rng(2).random((9, 3)), linear_velocity=(1, 2, 3))
        self.fall(20)
        view = self.batch.view()
        velocity, spin = self.batch.velocities()
        where = {int(body): at for at, body in enumerate(view.ids)}
        for body in ids:
            state, at = self.world.state(body), where[int(body)]
            np.testing.assert_array_equal(state.position, np.asarray(view.position)[at])
            np.testing.assert_array_equal(state.orientation, np.asarray(view.orientation)[at])
            np.testing.assert_array_equal(state.linear_velocity, velocity[at])
            np.testing.assert_array_equal(state.angular_velocity, spin[at])

    def test_a_view_from_before_a_change_is_refused(self):
        self.batch.create(3)
        view = self.batch.view()
        self.world.info, self.world.hash(), self.batch.transforms(), self.world.ray_cast((0, 1, 0), (0, -1, 0))
        self.assertEqual(len(view.position.x), 3)  # queries change nothing
        for change in (lambda: self.world.step(0.01), lambda: self.batch.create(1), lambda: self.world.set_uniform_wind((1, 0, 0)),
                       lambda: self.world.destroy_bodies(self.batch.ids[:1])):
            view = self.batch.view()
            change()
            self.assertTrue(view.is_stale)
            for name in ("position", "orientation", "scale", "age", "noise_seed", "ids"):
                with self.assertRaises(lr.StaleViewError):
                    getattr(view, name)

    def test_arrays_outlive_a_closed_world(self):
        self.batch.create(50, position=(1, 2, 3))
        x = self.batch.view().position.x
        self.world.close()
        np.testing.assert_array_equal(x, np.ones(50, np.float32))
        with self.assertRaises(lr.ClosedError):
            self.world.step(0.1)

    def test_a_batch_with_arrays_is_not_destroyed(self):
        self.batch.create(5)
        x = self.batch.view().position.x
        with self.assertRaises(BufferError):
            self.batch.destroy()
        del x
        self.batch.destroy()
        with self.assertRaises(lr.StaleBatchError):
            self.batch.view()

    def test_an_empty_batch_has_empty_arrays(self):
        view = self.batch.view()
        self.assertEqual([len(part) for part in view.position], [0, 0, 0])
        self.assertEqual(view.ids.dtype, np.uint64)
        self.assertEqual(self.batch.transforms().shape, (0, 4, 4))


class Transforms(WorldCase):
    def setUp(self):
        super().setUp()
        rng = np.random.default_rng(4)
        self.batch.create(position=rng.random((17, 3)), orientation=rng.normal(size=(17, 4)), scale=rng.random(17) + 0.5)
        self.fall(3)
        view = self.batch.view()
        self.q, self.p, self.s = view.orientation.stack(), view.position.stack(), view.scale.copy()

    def test_all_formats_agree_with_the_state(self):
        rotation = np.stack([turned(self.q, np.broadcast_to(axis, (17, 3))) for axis in np.eye(3, dtype=np.float32)], axis=-1)
        matrix = np.zeros((17, 4, 4), np.float32)
        matrix[:, :3, :3], matrix[:, :3, 3], matrix[:, 3, 3] = rotation * self.s[:, None, None], self.p, 1
        T = lr.TransformFormat
        wanted = {
            T.POSITION_QUATERNION: np.hstack([self.p, self.q]),
            T.POSITION_QUATERNION_SCALE: np.hstack([self.p, self.q, self.s[:, None]]),
            T.MATRIX_3X4_ROW_MAJOR: matrix[:, :3, :], T.MATRIX_3X4_COLUMN_MAJOR: matrix[:, :3, :].transpose(0, 2, 1),
            T.MATRIX_4X4_ROW_MAJOR: matrix, T.MATRIX_4X4_COLUMN_MAJOR: matrix.transpose(0, 2, 1),
        }
        self.assertEqual(set(wanted), set(T))
        for kind, values in wanted.items():
            np.testing.assert_allclose(self.batch.transforms(kind), values, rtol=1e-5, atol=1e-6, err_msg=kind.name)

    def test_into_a_field_of_a_structured_array(self):
        layout = np.dtype([("colour", np.float32, 3), ("matrix", np.float32, (3, 4)), ("spare", np.uint32)])
        instances = np.zeros(64, layout)
        instances["spare"] = 7
        written = self.batch.transforms(lr.TransformFormat.MATRIX_3X4_ROW_MAJOR, out=instances["matrix"])
        self.assertEqual(written.base.ctypes.data, instances.ctypes.data)
        np.testing.assert_array_equal(instances["matrix"][:17], self.batch.transforms(lr.TransformFormat.MATRIX_3X4_ROW_MAJOR))
        self.assertTrue((instances["spare"] == 7).all() and (instances["colour"] == 0).all() and (instances["matrix"][17:] == 0).all())

    def test_first_bodies_only(self):
        out = np.full((64, 7), -1, np.float32)
        written = self.batch.transforms(lr.TransformFormat.POSITION_QUATERNION, out=out, first=5)
        self.assertEqual(written.shape, (5, 7))
        self.assertTrue((out[5:] == -1).all())

    def test_wrong_buffers_are_refused(self):
        for wrong, error in ((np.zeros((64, 4, 4)), TypeError), (np.zeros((64, 12), np.float32), ValueError),
                             (np.zeros((64, 4, 8), np.float32)[:, :, ::2], ValueError), (np.zeros(16, np.float32), ValueError),
                             (np.zeros((64, 16), np.float32)[::-1], ValueError),
                             (np.zeros((64, 8, 8), np.float32)[:, 2:6, 2:6], ValueError)):
            with self.assertRaises(error):
                self.batch.transforms(out=wrong)
        self.assertEqual(len(self.batch.transforms(out=np.zeros((16, 16), np.float32))), 16)
        for wrong in (-1, 1 << 32):  # as a C integer the first is all bodies, beyond the end of `out`
            with self.assertRaises(OverflowError):
                self.batch.transforms(out=np.zeros((2, 4, 4), np.float32), first=wrong)
        read_only = np.zeros((64, 16), np.float32)
        read_only.flags.writeable = False
        with self.assertRaisesRegex(ValueError, "read-only"):
            self.batch.transforms(out=read_only)
        with self.assertRaisesRegex(TypeError, "not list"):
            self.batch.transforms(out=[0.0])


class Bodies(WorldCase):
    def test_values_for_all_or_for_each(self):
        ids = self.batch.create(scale=[1, 2, 3], position=(0, 5, 0), age=4.0, noise_seed=[11, 12, 13])
        self.assertEqual(ids.dtype, np.uint64)
        states = [self.world.state(body) for body in ids]
        self.assertEqual([s.scale for s in states], [1, 2, 3])
        self.assertEqual([s.noise_seed for s in states], [11, 12, 13])
        self.assertEqual([s.age for s in states], [4, 4, 4])
        self.assertEqual(len(self.batch.create()), 1)
        for wrong in ({"position": np.zeros((3, 2))}, {"position": np.zeros((3, 3)), "scale": np.ones(4)}):
            with self.assertRaises(ValueError):
                self.batch.create(**wrong)
        for count, name, given, said in ((3, "scale", [1, 2], r"scale: shape \(2,\) is neither \(\) nor \(3,\)"),
                                         (3, "user", [1, 2], r"user: shape \(2,\)"),
                                         (1, "age", np.ones((2, 2)), r"age: shape \(2, 2\)")):
            with self.assertRaisesRegex(ValueError, said):
                self.batch.create(count, **{name: given})
        with self.assertRaisesRegex(ValueError, "'position': 3, 'scale': 2"):
            self.batch.create(position=np.zeros((3, 3)), scale=[1, 2])
        for name, given in (("scale", [1, 2]), ("user", np.ones(2, int))):
            with self.assertRaisesRegex(TypeError, rf"{name}: shape \(2,\), but it is one number"):
                self.world.set_state(ids[0], **{name: given})
        with self.assertRaises(TypeError):
            self.batch.create(noise_seed=1.5)
        with self.assertRaises(OverflowError):
            self.batch.create(noise_seed=-1)

    def test_users_bounds_and_timings(self):
        self.assertIsNone(self.batch.bounds())
        self.assertEqual(self.world.timings.total, 0)
        ids = self.batch.create(position=[(0, 1, 0), (3, 0, 0)], user=np.array([2**63, 7], np.uint64))
        self.world.set_state(ids[1], scale=2)
        self.assertEqual([self.world.state(body).user for body in ids], [2**63, 7])
        listed = self.batch.create(position=[(0, 1, 0), (3, 0, 0)], user=[2**63, 7])  # of these NumPy makes floats
        self.assertEqual([self.world.state(body).user for body in listed], [2**63, 7])
        self.world.destroy_bodies(listed)
        self.fall()
        self.assertEqual(sorted(self.batch.view().user.tolist()), [7, 2**63])
        low, high = self.batch.bounds()
        self.assertTrue((low <= (0, 0.5, 0)).all() and (high >= (3, 0.5, 0)).all() and high[0] < 4)
        timings = self.world.timings
        self.assertGreater(timings.total, 0)
        self.assertLessEqual(timings.motion + timings.emit_and_rules, timings.total)

    def test_state_is_set_in_part(self):
        body = int(self.batch.create(position=(1, 2, 3), scale=2)[0])
        self.world.set_state(body, linear_velocity=(0, 0, 9))
        state = self.world.state(body)
        np.testing.assert_array_equal(state.position, [1, 2, 3])
        np.testing.assert_allclose(state.linear_velocity, [0, 0, 9], atol=1e-5)
        self.assertEqual(state.scale, 2)
        with self.assertRaises(AttributeError):
            state.scale = 3
        self.assertEqual(pickle.loads(pickle.dumps(state)).scale, 2)
        self.assertEqual(copy.copy(state).as_dict().keys(), state.as_dict().keys())

    def test_what_has_ended_is_not_valid(self):
        body = self.batch.create()[0]
        other = self.world.create_batch(self.batch.asset, 1)
        collider, source = self.world.add_plane(), self.world.add_gusts()
        for thing in (body, int(body), other, collider, source):
            self.assertIs(self.world.is_valid(thing), True)
        self.world.destroy_bodies(body)
        other.destroy()
        collider.destroy()
        source.remove()
        for thing in (body, 0, other, collider, source):
            self.assertIs(self.world.is_valid(thing), False)
        with lr.World() as another:
            self.assertFalse(another.is_valid(self.batch))

    def test_rest_and_waking(self):
        ids = self.batch.create(position=[(0, 0, 0), (5, 0, 0)])
        self.world.set_sleep(ids)
        self.assertEqual(self.batch.view().awake_count, 0)
        self.assertIs(self.world.state(ids[0]).sleep_state, lr.SleepState.ASLEEP)
        self.assertEqual(self.world.wake_box((-1, -1, -1), (1, 1, 1)), 1)
        self.assertEqual(self.world.info.awake_count, 1)
        self.world.set_sleep(ids[1], lr.SleepState.AWAKE)
        self.assertEqual(self.world.info.awake_count, 2)

    def test_a_hundred_thousand(self):
        n = 100_000
        with lr.World(seed=5) as world:
            batch = world.create_batch(thin_leaf(), n)
            begin = time.perf_counter()
            ids = batch.create(position=np.random.default_rng(0).random((n, 3), np.float32) * 100)
            created = time.perf_counter()
            for _ in range(10):
                world.step(1 / 60, 2)
            stepped = time.perf_counter()
            matrices = batch.transforms(out=np.empty((n, 4, 4), np.float32))
            view = batch.view()
            heights = view.position.y
            done = time.perf_counter()
            self.assertEqual((len(ids), len(np.unique(ids)), len(matrices)), (n, n, n))
            np.testing.assert_array_equal(matrices[:, 1, 3], heights)
            self.assertLess(float(batch.velocities()[0][:, 1].mean()), -0.3)  # m/s: they fall
            print(f"\n  100,000 bodies: created in {1e3 * (created - begin):.1f} ms, a step of 2 substeps "
                  f"{1e2 * (stepped - created):.2f} ms, transforms and view {1e3 * (done - stepped):.2f} ms")


class Forces(WorldCase):
    def test_arrays_of_any_layout_do_the_same(self):
        rng = np.random.default_rng(7)
        force, torque = rng.normal(size=(2, 8, 3)).astype(np.float32) * 1e-4
        hashes = set()
        wide = np.zeros((8, 5), np.float32)
        wide[:, 1:4] = force
        for given in ((force, torque), (tuple(force.T.copy()), tuple(torque.T.copy())), (wide[:, 1:4], torque),
                      (force.astype(np.float64), torque.tolist()), (force[::-1][::-1], np.asfortranarray(torque))):
            with lr.World(seed=1) as world:
                batch = world.create_batch(thin_leaf(), 8)
                batch.create(8)
                batch.add_forces(*given)
                world.step(0.01)
                hashes.add(world.hash())
        with lr.World(seed=1) as world:
            batch = world.create_batch(thin_leaf(), 8)
            world.add_forces(batch.create(8), force, torque)
            world.step(0.01)
            hashes.add(world.hash())
        self.assertEqual(len(hashes), 1)
        with lr.World(seed=1) as world:
            batch = world.create_batch(thin_leaf(), 8)
            batch.create(8)
            world.step(0.01)
            self.assertNotIn(world.hash(), hashes)

    def test_velocity_mode_says_what_it_does(self):
        ids = self.batch.create(4)
        self.batch.add_forces(force=np.tile((1, 2, 3), (2, 1)), mode=lr.ForceMode.VELOCITY, first=1)
        got = self.batch.velocities()[0]
        np.testing.assert_allclose(got, [(0, 0, 0), (1, 2, 3), (1, 2, 3), (0, 0, 0)], atol=1e-6)
        self.world.add_forces(ids[0], (0, 1e-3, 0), point=(0.01, 0, 0), mode=lr.ForceMode.IMPULSE)
        self.assertGreater(abs(self.world.state(ids[0]).angular_velocity[2]), 1)
        for wrong in ({"force": np.zeros((5, 3))}, {"force": np.zeros((4, 2))}, {"force": np.zeros((2, 3)), "torque": np.zeros((3, 3))}):
            with self.assertRaises(ValueError):
                self.batch.add_forces(**wrong)
        for first in (2**32 + 1, -1):
            with self.assertRaises(OverflowError):
                self.batch.add_forces(force=np.zeros((2, 3)), first=first)

    def test_batch_force_until_changed(self):
        self.batch.create(1)
        self.world.set_gravity((0, 0, 0))
        self.batch.set_force(acceleration=(2, 0, 0))
        self.world.step(0.01)
        self.assertAlmostEqual(float(self.batch.velocities()[0][0, 0]), 0.02, delta=0.002)
        self.batch.set_force()


class Snapshots(WorldCase):
    def test_the_future_is_the_same(self):
        self.batch.create(position=np.random.default_rng(8).random((30, 3)))
        self.fall(10)
        saved = self.world.save()
        self.assertIsInstance(saved, bytes)
        self.fall(10)
        wanted = self.world.hash()
        self.world.restore(saved)
        self.assertNotEqual(self.world.hash(), wanted)
        self.fall(10)
        self.assertEqual(self.world.hash(), wanted)
        with lr.World(seed=3) as other:
            other.create_batch(thin_leaf(), self.capacity)
            other.restore(memoryview(bytearray(saved)))
            for _ in range(10):
                other.step(1 / 60, 2)
            self.assertEqual(other.hash(), wanted)
            other.create_batch(thin_leaf(), 3)
            with self.assertRaises(lr.SnapshotMismatchError):
                other.restore(saved)
            with self.assertRaises(lr.SnapshotFormatError):
                other.restore(saved[:-1])


class Recordings(WorldCase):
    def test_calls_are_recorded(self):
        pieces = []
        with self.assertRaises(lr.InvalidArgumentError):
            self.world.record_stop()
        self.world.record_start(pieces.append, hash_interval=2)
        with self.assertRaises(lr.InvalidArgumentError):
            self.world.record_start(pieces.append)
        self.batch.create(5)
        self.fall()
        self.world.record_stop()
        length = sum(map(len, pieces))
        self.assertGreater(length, 1000)
        self.fall()
        self.assertEqual(sum(map(len, pieces)), length)

        def full(_):
            raise OSError("no room")

        with self.assertRaisesRegex(OSError, "no room"):
            self.world.record_start(full)
        self.fall()

    def test_an_exception_of_a_callback_loses_no_handle(self):
        creations = {
            "batch": lambda: self.world.create_batch(thin_leaf(), 1),
            "body": lambda: self.batch.create(1)[0],
            "box": lambda: self.batch.spawn_box((0, 0, 0), (1, 1, 1), 1)[0],
            "emitter": lambda: self.batch.emit(1)[0],
            "collider": lambda: self.world.add_plane(),
            "wind": lambda: self.world.add_vortex(),
        }
        self.batch.set_emitter(rate=1)
        for name, create in creations.items():
            with self.subTest(name):
                self.record_to_a_full_disk()
                thing = create()
                with self.assertRaisesRegex(OSError, "no room"):
                    self.fall()
                self.assertTrue(self.world.is_valid(thing))
        self.record_to_a_full_disk()
        self.batch.create(1)
        with self.assertRaisesRegex(OSError, "no room"):
            self.world.close()

    def record_to_a_full_disk(self):
        full = False

        def write(_):
            if full:
                raise OSError("no room")

        self.world.record_start(write)
        full = True


class Frames(WorldCase):
    def test_saved_and_loaded(self):
        self.batch.set_emitter(rate=300, shape=lr.EmitterShape.BOX, size=(1, 1, 1))
        self.batch.set_rules(max_age=0.1)
        recording = lr.Recording(fps=60, first_frame=10)
        for _ in range(30):
            recording.capture(self.batch)
            self.fall()
        path = WORK / "storm.npz"
        recording.save(path)
        again = lr.Recording.load(path)
        self.assertEqual((again.fps, again.frame_numbers), (60, range(10, 40)))
        for a, b in zip(recording, again):
            for left, right in zip(a, b):
                np.testing.assert_array_equal(left, right)
        lives = np.unique(np.concatenate([frame.ids for frame in recording]))
        np.testing.assert_array_equal(lives, np.arange(len(lives)))
        self.assertGreater(len(lives), 100)
        slots, count = recording.slots()
        self.assertLess(count, len(lives))
        last = {}
        for at, (frame, slot) in enumerate(zip(recording, slots)):
            self.assertEqual(len(np.unique(slot)), len(slot))
            for life, s in zip(frame.ids.tolist(), slot.tolist()):
                before = last.get(s)
                if before is not None and before[0] != life:
                    self.assertGreater(at - before[1], 2)  # two empty frames between two lives of a slot
                last[s] = (life, at)

    def test_a_respawn_begins_another_life(self):
        self.batch.set_emitter(position=(0, 9, 0))
        self.batch.set_rules(max_age=0.05, action=lr.EndAction.RESPAWN)
        self.batch.create(2)
        recording = lr.Recording(fps=60)
        for _ in range(8):
            recording.capture(self.batch)
            self.fall()
        self.assertEqual(len({int(b) for f in recording for b in f.bodies}), 2)
        self.assertGreaterEqual(len({int(i) for f in recording for i in f.ids}), 4)


if __name__ == "__main__":
    unittest.main()
