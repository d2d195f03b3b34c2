# SPDX-License-Identifier: MIT
"""The add-on in a real Blender:  blender -b --factory-startup -P blender_check.py -- FOLDER

Compares Blender's evaluated scene (instances of the carrier, keyframed objects) with the recording.
"""
import pathlib
import sys
import unittest

import bpy
import numpy as np

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent / "blender"), str(HERE)]
import leaf_storm  # noqa: E402
from leaf_storm import lr  # noqa: E402

from langevin_rigid.mesh import Mesh  # noqa: E402
from langevin_rigid.view import turned  # noqa: E402

ROOT = HERE.parents[2]
WORK = pathlib.Path(sys.argv[sys.argv.index("--") + 1]) if "--" in sys.argv else pathlib.Path(bpy.app.tempdir)


def matrices_of(frame, slot, count, metres):
    """The bodies of a frame as matrices in Blender's units, by slot; None for an empty slot."""
    found = [None] * count
    axes = np.stack([turned(frame.orientation, np.broadcast_to(a, frame.position.shape)) for a in np.eye(3, dtype=np.float32)], -1)
    for at, s in enumerate(slot):
        matrix = np.eye(4)
        matrix[:3, :3], matrix[:3, 3] = axes[at] * frame.scale[at], frame.position[at] / metres
        found[s] = matrix
    return found


def instances(carrier_name):
    depsgraph = bpy.context.evaluated_depsgraph_get()
    return [np.array(i.matrix_world) for i in depsgraph.object_instances
            if i.is_instance and i.parent and i.parent.name == carrier_name]


class Storm(unittest.TestCase):
    def setUp(self):
        bpy.ops.wm.read_factory_settings(use_empty=True)
        if not hasattr(bpy.types.Scene, "leaf_storm"):
            leaf_storm.register()
        self.scene = bpy.context.scene
        self.scene.frame_start, self.scene.frame_end = 3, 26
        self.leaf = leaf_storm.object_of(Mesh.read_obj(ROOT / "assets" / "leaf.obj"), "Leaf")
        self.scene.collection.objects.link(self.leaf)
        self.asset_path = WORK / "blender_leaf.lrb"
        if not self.asset_path.exists():
            leaf_storm.bake_asset(self.leaf, self.asset_path, self.scene, density=350)
        self.asset = lr.Asset.load(self.asset_path)

    def storm(self, mode="POINTS", **settings):
        values = {"count": 40, "rate": 60, "lifetime": 0.3, "center": (0, 0, 3), "size": (2, 2, 1), "gusts": 0.5, **settings}
        cache = str(WORK / "blender.pc2")
        return leaf_storm.bake_storm(self.scene, self.leaf, self.asset, leaf_storm.Settings(**values), mode, cache)[0]

    def compare(self, recording, evaluate, metres=1.0):
        slots, count = recording.slots()
        alive = 0
        for number, frame, slot in zip(recording.frame_numbers, recording, slots):
            self.scene.frame_set(number)
            got = evaluate()
            self.assertEqual(len(got), count)
            for wanted, matrix in zip(matrices_of(frame, slot, count, metres), got):
                if wanted is None:
                    self.assertLess(np.abs(matrix[:3, :3]).max(), 1e-6)
                else:
                    np.testing.assert_allclose(matrix, wanted, atol=2e-4 * max(1, 1 / metres / 10))
                    alive += 1
        self.assertGreater(alive, 200)

    def test_instances_are_where_bodies_are(self):
        recording = self.storm()
        self.compare(recording, lambda: instances("Leaf Storm"))

    def test_between_frames_they_are_between(self):
        recording = self.storm(rate=0, lifetime=0)
        a, b = recording[5], recording[6]
        np.testing.assert_array_equal(a.ids, b.ids)
        self.scene.frame_set(recording.frame_numbers[5], subframe=0.5)
        got = np.array(instances("Leaf Storm"))
        np.testing.assert_allclose(got[:, :3, 3], (a.position + b.position) / 2, atol=1e-5)
        self.assertTrue((np.abs(np.linalg.det(got[:, :3, :3])) > 0.01).all())

    def test_keyframed_objects_are_where_bodies_are(self):
        recording = self.storm("KEYFRAMES")
        leaves = [o for o in bpy.data.collections["Leaf Storm"].objects if o.name.startswith("Leaf ")]
        leaves.sort(key=lambda o: o.name)
        self.assertEqual(len({o.data.name for o in leaves}), 1)

        def evaluate():
            depsgraph = bpy.context.evaluated_depsgraph_get()
            return [np.array(leaf.evaluated_get(depsgraph).matrix_world) for leaf in leaves]

        self.compare(recording, evaluate)

    def test_the_drawn_mesh_is_about_its_centre_of_mass(self):
        for vertex in self.leaf.data.vertices:
            vertex.co.x += 0.5
        path = WORK / "blender_off.lrb"
        leaf_storm.bake_asset(self.leaf, path, self.scene, density=350)
        self.asset = lr.Asset.load(path)
        self.assertAlmostEqual(self.asset.info.center_of_mass[0], 0.5, places=4)
        self.storm()
        drawn = next(o for o in bpy.data.objects if o.name.startswith("Leaf about"))
        xs = [v.co.x for v in drawn.data.vertices]
        self.assertAlmostEqual((min(xs) + max(xs)) / 2, 0, places=2)

    def test_scenes_in_centimetres(self):
        self.scene.unit_settings.system, self.scene.unit_settings.scale_length = "METRIC", 0.01
        self.scene.gravity = (0, 0, -981)
        for vertex in self.leaf.data.vertices:
            vertex.co *= 100
        path = WORK / "blender_cm.lrb"
        leaf_storm.bake_asset(self.leaf, path, self.scene, density=350)
        self.assertAlmostEqual(lr.Asset.load(path).info.mass, self.asset.info.mass, delta=1e-9)
        recording = self.storm(center=(0, 0, 300), size=(200, 200, 100))
        heights = np.concatenate([frame.position[:, 2] for frame in recording])
        self.assertTrue((heights > 1.5).all() and (heights < 4).all())
        self.compare(recording, lambda: instances("Leaf Storm"), 0.01)

    def test_leaves_land_on_obstacles_that_move(self):
        bpy.ops.mesh.primitive_cube_add(size=2, location=(0, 0, 0), scale=(3, 3, 0.5))
        table = bpy.context.object
        self.scene.frame_end = 120
        table.keyframe_insert("location", frame=60)
        table.location.z = 0.5
        table.keyframe_insert("location", frame=110)
        recording = self.storm(rate=0, lifetime=0, obstacles=[table], center=(0, 0, 1), size=(1, 1, 0.4), ground=False, gusts=0,
                               turbulence=0)
        low = [frame.position[:, 2].min() for frame in recording]
        self.assertGreater(min(low), 0.45)
        self.assertGreater(low[-1], 0.95)
        self.assertLess(low[50], 0.7)

    def test_operators_and_their_problems(self):
        storm = self.scene.leaf_storm
        with self.assertRaisesRegex(RuntimeError, "choose the leaf"):
            bpy.ops.leaf_storm.bake_storm()
        storm.leaf, storm.count = self.leaf, 25
        with self.assertRaisesRegex(RuntimeError, "save the file first"):
            bpy.ops.leaf_storm.bake_asset()
        storm.asset = str(WORK / "missing.lrb")
        with self.assertRaisesRegex(RuntimeError, "missing.lrb: no such file|missing.lrb"):
            bpy.ops.leaf_storm.bake_storm()
        storm.asset, storm.cache = str(WORK / "operator.lrb"), str(WORK / "operator.pc2")
        self.leaf.scale.x = 2
        with self.assertRaisesRegex(RuntimeError, "apply its scale"):
            bpy.ops.leaf_storm.bake_asset()
        self.leaf.scale.x = 1
        self.assertEqual(bpy.ops.leaf_storm.bake_asset(), {"FINISHED"})
        self.assertEqual(bpy.ops.leaf_storm.bake_storm(), {"FINISHED"})
        self.assertEqual(bpy.ops.leaf_storm.bake_storm(), {"FINISHED"})  # replaces the first storm
        self.assertEqual(sum(o.name.startswith("Leaf Storm") for o in bpy.data.objects), 1)
        self.scene.frame_set(10)
        self.assertEqual(len(instances("Leaf Storm")), 25)
        import usda_reader
        self.assertEqual(bpy.ops.leaf_storm.export_usd(filepath=str(WORK / "operator.usda")), {"FINISHED"})
        stage = usda_reader.read(WORK / "operator.usda")
        self.assertEqual(stage.metadata["upAxis"], "Z")
        self.assertEqual(len(stage.at("/Storm/Leaf").attributes["positions"]["value"][3]), 25)

    def test_a_saved_file_plays_by_itself(self):
        recording = self.storm()
        self.scene.frame_set(20)
        wanted = np.array(instances("Leaf Storm"))
        path = str(WORK / "storm.blend")
        bpy.ops.wm.save_as_mainfile(filepath=path)
        leaf_storm.unregister()
        bpy.ops.wm.read_factory_settings(use_empty=True)
        bpy.ops.wm.open_mainfile(filepath=path)
        bpy.context.scene.frame_set(20)
        np.testing.assert_allclose(np.array(instances("Leaf Storm")), wanted, atol=1e-6)
        self.assertEqual(len(recording), 24)


if __name__ == "__main__":
    result = unittest.main(argv=["blender_check"], exit=False, verbosity=1).result
    sys.stderr.flush()
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
