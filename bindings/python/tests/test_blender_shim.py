# SPDX-License-Identifier: MIT
"""The add-on's command against a shim of bpy. blender_check.py tests in a real Blender."""
import sys
import unittest

import numpy as np
from support import HERE, ROOT, WORK, lr

from langevin_rigid.export import read_pc2


class Command(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        sys.path[:0] = [str(HERE / "bpy_shim"), str(HERE.parent / "blender")]
        import bpy
        from leaf_storm import command, panel
        cls.asset = []  # baked by the first command
        cls.bpy, cls.command, cls.panel = bpy, command, panel
        panel.register()

    @classmethod
    def tearDownClass(cls):
        cls.panel.unregister()
        for name in [name for name in sys.modules if name.split(".")[0] in ("bpy", "mathutils", "leaf_storm")]:
            del sys.modules[name]
        del sys.path[:2]

    def run_command(self, mode, *more):
        recording = self.command.run(["--mesh", str(ROOT / "assets" / "leaf.obj"), "--count", "12", "--frames", "20", "--mode", mode,
                                      "--cache", str(WORK / "shim.pc2"), *self.asset, *more])[0]
        self.asset[:] = ["--asset", str(WORK / "leaf_storm.lrb")]
        return recording

    def test_points(self):
        recording = self.run_command("points")
        carrier = self.bpy.data.objects["Leaf Storm"]
        moves, draws = carrier.stack
        start, _, samples = read_pc2(moves.filepath)
        self.assertEqual((moves.cache_format, moves.frame_start, start, samples.shape), ("PC2", 1, 1, (20, 36, 3)))
        self.assertEqual(len(carrier.data.vertices), 36)
        np.testing.assert_array_equal(samples[7, ::3], recording[7].position)
        prototype = next(iter(draws.inputs.values()))
        center = lr.Asset.load(WORK / "leaf_storm.lrb").info.center_of_mass
        leaf = self.bpy.data.meshes["Leaf"] if "Leaf" in self.bpy.data.meshes else None
        self.assertIsNotNone(leaf)
        np.testing.assert_allclose(prototype.data.vertices.arrays["co"].reshape(-1, 3),
                                   leaf.vertices.arrays["co"].reshape(-1, 3) - center, atol=1e-6)
        self.assertEqual((prototype.hide_render, prototype.hidden, prototype.hide_viewport), (True, True, False))
        tree = draws.node_group
        place = next(node for node in tree.made if node.kind == "GeometryNodeInstanceOnPoints")
        fed = {end.name for _, end in tree.linked if any(end is socket for socket in place.inputs)}
        self.assertEqual(fed, {"Points", "Selection", "Instance", "Rotation", "Scale"})

    def test_alembic_is_of_one_mesh(self):
        path = WORK / "shim.abc"
        self.run_command("points", "--export", str(path))
        self.assertEqual(self.bpy.exported.pop(), (["Leaf Storm"], ["Leaf Storm Instances", "Leaf Storm Mesh"], 1, 20, "RENDER"))
        self.assertTrue(path.exists())
        self.assertEqual([m.type for m in self.bpy.data.objects["Leaf Storm"].stack], ["MESH_CACHE", "NODES"])
        self.assertFalse(any(thing.selected for thing in self.bpy.data.objects.values()))

    def test_exports_that_cannot_be(self):
        from leaf_storm.units import Problem
        for path, why in (("a.usdc", "built without USD"), ("a.obj", "ends in .abc"), ("a", "ends in .abc")):
            with self.assertRaisesRegex(Problem, why):
                self.run_command("points", "--export", str(WORK / path))
        with self.assertRaisesRegex(Problem, "as instances"):
            self.run_command("keyframes", "--export", str(WORK / "b.abc"))
        self.run_command("keyframes", "--export", str(WORK / "shim.usda"))
        self.assertIn("PointInstancer", (WORK / "shim.usda").read_text()[:2000])

    def test_keyframes(self):
        recording = self.run_command("keyframes")
        leaves = sorted((o for o in self.bpy.data.objects.values() if o.name.startswith("Leaf 0")), key=lambda o: o.name)
        self.assertEqual(len(leaves), 12)
        for body, leaf in enumerate(leaves):
            self.assertEqual(leaf.rotation_mode, "QUATERNION")
            got = {}
            for curve in leaf.action.action.curves:
                points = curve.keyframe_points.arrays["co"].reshape(-1, 2)
                np.testing.assert_array_equal(points[:, 0], np.arange(1, 21))
                got[curve.data_path, curve.array_index] = points[:, 1]
            self.assertEqual(len(got), 10)
            for at, frame in enumerate(recording):
                np.testing.assert_allclose([got["location", i][at] for i in range(3)], frame.position[body], rtol=1e-6)
                np.testing.assert_allclose([got["scale", i][at] for i in range(3)], [frame.scale[body]] * 3, rtol=1e-6)
                turn = np.array([got["rotation_quaternion", i][at] for i in range(4)])
                self.assertAlmostEqual(abs(float(turn @ frame.orientation[body][[3, 0, 1, 2]])), 1, places=5)
                if at:
                    before = np.array([got["rotation_quaternion", i][at - 1] for i in range(4)])
                    self.assertGreaterEqual(float(turn @ before), 0)


if __name__ == "__main__":
    unittest.main()
