# SPDX-License-Identifier: MIT
"""Every status as an exception, most from calls that really return it."""
import ctypes
import pickle
import types
import unittest

import numpy as np
from support import ROOT, WORK, WorldCase, lr, thin_leaf

from langevin_rigid import _native as native
from langevin_rigid import errors
from langevin_rigid._library import error


class Statuses(WorldCase):
    def test_each_status_has_its_exception(self):
        for status in lr.Status:
            if status == lr.Status.OK:
                continue
            kind = errors.BY_STATUS[status]
            made = error(status, "lr_f")
            self.assertIs(type(made), kind)
            self.assertEqual((made.status, made.function), (status, "lr_f"))
            self.assertIn("lr_f: ", str(made))
            again = pickle.loads(pickle.dumps(made))
            self.assertEqual((type(again), again.status, str(again)), (kind, status, str(made)))
        self.assertEqual(str(error(-999, "f")), "f: unknown status")

    def test_calls_that_get_them(self):
        world, batch, S = self.world, self.batch, lr.Status
        stale = int(batch.create(1)[0])
        world.destroy_bodies(stale)
        source = world.add_vortex()
        source.remove()
        collider = world.add_sphere((0, 0, 0), 1)
        collider.destroy()
        other = world.create_batch(thin_leaf(), 1)
        other.destroy()
        junk, damaged = WORK / "junk.lrb", WORK / "damaged.lrb"
        asset = WORK / "errors.lrb"
        lr.bake_ellipsoid((0.04, 0.01, 0.001), asset)
        good = asset.read_bytes()
        junk.write_bytes(b"not an asset")
        damaged.write_bytes(good[:200] + bytes([good[200] ^ 1]) + good[201:])
        raw = native.lr_world_info()
        raw.struct_size = 4
        cases = [
            (S.NULL_ARGUMENT, TypeError, lambda: world._ask("lr_world_get_info", None)),
            (S.STRUCT_SIZE, TypeError, lambda: world._ask("lr_world_get_info", ctypes.byref(raw))),
            (S.INVALID_ARGUMENT, ValueError, lambda: world.create_batch(thin_leaf(), 0)),
            (S.NOT_FINITE, ValueError, lambda: world.set_gravity((0, float("nan"), 0))),
            (S.STALE_BODY, LookupError, lambda: world.state(stale)),
            (S.STALE_BODY, LookupError, lambda: world.destroy_bodies([stale])),
            (S.STALE_BATCH, LookupError, other.view),
            (S.STALE_WIND_SOURCE, LookupError, source.remove),
            (S.STALE_COLLIDER, LookupError, lambda: collider.state),
            (S.CAPACITY, lr.Error, lambda: batch.create(self.capacity + 1)),
            (S.FILE_NOT_FOUND, FileNotFoundError, lambda: lr.Asset.load("/nowhere/leaf.lrb")),
            (S.FILE_READ, OSError, lambda: lr.Asset.load(WORK)),
            (S.ASSET_FORMAT, ValueError, lambda: lr.Asset.load(junk)),
            (S.ASSET_CORRUPT, ValueError, lambda: lr.Asset.load(damaged)),
            (S.ASSET_CORRUPT, ValueError, lambda: lr.Asset.from_bytes(damaged.read_bytes())),
            (S.SNAPSHOT_FORMAT, ValueError, lambda: world.restore(b"no snapshot")),
            (S.SNAPSHOT_MISMATCH, ValueError, lambda: world.restore(lr.World().save())),
            (S.UNSUPPORTED, NotImplementedError, lambda: world.set_simd_target(lr.SimdTarget.WASM)),
            (S.TIMESTEP_ZERO, ValueError, lambda: world.step(0)),
            (S.TIMESTEP_NEGATIVE, ValueError, lambda: world.step(-1)),
            (S.TIMESTEP_NOT_FINITE, ValueError, lambda: world.step(float("inf"))),
            (S.TIMESTEP_TOO_LARGE, ValueError, lambda: world.step(10)),
            (S.SUBSTEPS, ValueError, lambda: world.step(0.1, 0)),
        ]
        for status, also, call in cases:
            with self.subTest(status.name):
                with self.assertRaises(lr.Error) as caught:
                    call()
                self.assertEqual(caught.exception.status, status)
                self.assertIsInstance(caught.exception, also)
                self.assertIsInstance(caught.exception, errors.BY_STATUS[status])
        self.assertGreaterEqual(len({status for status, _, _ in cases}), 21)

    def test_messages_say_which_value_is_wrong(self):
        with self.assertRaises(lr.InvalidArgumentError) as caught:
            self.batch.create(scale=1e9)
        self.assertIn("scale", str(caught.exception))
        with self.assertRaisesRegex(TypeError, "has no 'damping_gian': is 'damping_gain' meant"):
            self.world.create_batch(thin_leaf(), 1, damping_gian=1)
        with self.assertRaisesRegex(ValueError, "gravity: 2 numbers, but it has 3"):
            lr.World(gravity=(0, 1))
        for ids in (np.zeros(2, np.float32), [1.5], None):
            with self.assertRaisesRegex(TypeError, "bodies: expected integers, not "):
                self.world.destroy_bodies(ids)
        with self.assertRaisesRegex(TypeError, "bodies: ids are expected, not a mask"):
            self.world.destroy_bodies([True, False])
        for vector in (9.81, [9.81], (0, 9.81), ((0, 0, 0), (1, 1, 1))):  # a scalar was the vector (9.81, 9.81, 9.81)
            for name, call in (("gravity", self.world.set_gravity), ("velocity", self.world.set_uniform_wind),
                               ("low", lambda v: self.batch.spawn_box(v, (9, 9, 9), 1)),
                               ("force", lambda v: self.world.add_forces(self.batch.create(), v))):
                with self.assertRaisesRegex(ValueError, rf"{name}: shape .* is neither \(3,\) nor \(1, 3\)"):
                    call(vector)
        with self.assertRaisesRegex(OverflowError, "worker_count: -1"):
            lr.World(worker_count=-1)
        with self.assertRaises(lr.InvalidArgumentError):
            lr.World(worker_count=65)
        with self.assertRaisesRegex(TypeError, "asset: expected an Asset, not str"):
            self.world.create_batch("leaf.lrb", 10)
        with self.assertRaisesRegex(lr.InvalidArgumentError, "density: The value 0 .* Give a value from"):
            lr.Asset.ellipsoid(semi_axes=(1, 1, 1))

    def test_things_of_another_world_are_refused(self):  # their handles would name things of this one
        with lr.World() as other:
            theirs, ball = other.create_batch(thin_leaf(), 1), other.add_sphere((0, 0, 0), 1)
            with self.assertRaisesRegex(ValueError, "another world"):
                self.batch.set_body_contact(theirs)
            with self.assertRaisesRegex(ValueError, "another world"):
                self.batch.body_contact(theirs)
            with self.assertRaisesRegex(ValueError, "another world"):
                self.world.move_colliders([ball], (0, 0, 0))

    def test_arrays_of_a_wrong_shape_are_named(self):
        with self.assertRaisesRegex(ValueError, r"points: shape \(3, 2\), but expected \(n, 3\)"):
            lr.bake_triangles(np.zeros((3, 2)), [[0, 1, 2]], WORK / "flat.lrb")
        with self.assertRaisesRegex(ValueError, r"triangles: shape \(1, 4\)"):
            lr.bake_triangles(np.eye(3), [[0, 1, 2, 0]], WORK / "flat.lrb")
        with self.assertRaisesRegex(ValueError, "indices are from 0 to 5, but there are 3 points"):
            lr.bake_triangles(np.eye(3), [[0, 1, 5]], WORK / "flat.lrb")

    def test_faults_of_a_damaged_asset_have_number_and_remedy(self):
        with self.assertRaises(lr.AssetError) as caught:
            lr.Asset.from_bytes(b"x" * 100)
        self.assertTrue(caught.exception.faults)
        fault = caught.exception.faults[0]
        self.assertGreater(fault.number, 0)
        self.assertTrue(fault.what and fault.remedy)
        self.assertIn(str(fault.number), str(caught.exception))

    def test_help_has_the_headers_words(self):
        import inspect
        self.assertIn("noise_gain", inspect.signature(lr.World.create_batch).parameters)
        self.assertIn("multiplies the turbulent noise", lr.World.create_batch.__doc__)
        self.assertIn("m/s^2, 3 values", lr.library().lr_world_set_gravity.__doc__)


class Baking(unittest.TestCase):
    def test_a_mesh_with_its_report(self):
        report = lr.bake(ROOT / "assets" / "confetti.obj", WORK / "confetti.lrb", density=800, name="snip", grid=(16, 16, 8))
        asset = lr.Asset.load(WORK / "confetti.lrb")
        self.assertEqual(asset.info.name, "snip")
        self.assertAlmostEqual(report["mass"], asset.info.mass, delta=1e-12)
        np.testing.assert_allclose(np.reshape(report["added_mass"], (6, 6)), asset.info.added_mass)
        self.assertEqual(lr.inspect_asset(WORK / "confetti.lrb")["name"], "snip")
        self.assertEqual(lr.check_asset((WORK / "confetti.lrb").read_bytes()), [])

    def test_triangles_from_memory_bake_like_a_file(self):
        from langevin_rigid.mesh import Mesh
        mesh = Mesh.read_obj(ROOT / "assets" / "petal.obj")
        self.assertTrue((mesh.counts == 3).all())
        one = lr.bake_triangles(mesh.points, mesh.indices.reshape(-1, 3), WORK / "petal.lrb", density=700)
        two = lr.bake(ROOT / "assets" / "petal.obj", WORK / "petal2.lrb", density=700)
        self.assertEqual(one["name"], "petal")
        self.assertEqual(one["mass"], two["mass"])

    def test_a_bad_mesh_says_its_faults(self):
        bad = WORK / "bad.obj"
        bad.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
        with self.assertRaises(lr.BakeError) as caught:
            lr.bake(bad, WORK / "bad.lrb", strict=True)
        self.assertEqual(caught.exception.returncode, 1)
        fault = caught.exception.faults[0]
        self.assertEqual((fault.number, fault.what), (206, "The surface has a boundary edge."))
        self.assertIn("--sheet", fault.remedy)
        with self.assertRaises(lr.BakeError) as caught:
            lr.bake(bad, WORK / "bad.lrb", densty=3)
        self.assertEqual(caught.exception.returncode, 2)
        self.assertIn("densty", str(caught.exception))

    def test_a_rigid_body_by_numbers(self):
        info = thin_leaf().info
        asset = lr.Asset.rigid(mass=info.mass, volume=info.volume, inertia=info.inertia, added_mass=info.added_mass,
                               extents=(0.08, 0.02, 0.0001), aerodynamics=thin_leaf().aerodynamics.replace(intensity=0.0))
        self.assertEqual(asset.aerodynamics.intensity, 0)
        np.testing.assert_array_equal(asset.info.added_mass, info.added_mass)
        asset.close()
        with self.assertRaises(lr.ClosedError):
            asset.info.mass, asset.aerodynamics  # read the info before closing


class Names(unittest.TestCase):
    def test_all_is_all_that_users_need(self):
        given = {name for name, value in vars(lr).items() if not name.startswith("_") and not isinstance(value, types.ModuleType)}
        self.assertEqual(given | {"__version__"}, set(lr.__all__))
        self.assertEqual(len(lr.__all__), len(set(lr.__all__)))


if __name__ == "__main__":
    unittest.main()
