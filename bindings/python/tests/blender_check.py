# SPDX-License-Identifier: MIT
"""The add-on in a real Blender:  blender -b --factory-startup -P blender_check.py -- FOLDER

Compares Blender's evaluated scene (instances of the carrier, keyframed objects) with the recording.
"""
import pathlib
import sys
import unittest

import bpy
import numpy as np
from mathutils import Vector

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent / "blender"), str(HERE)]
from leaf_storm import caches, colliders, command, panel, wind  # noqa: E402
from leaf_storm.leaf import bake_asset, object_of  # noqa: E402
from leaf_storm.simulate import Settings  # noqa: E402
from leaf_storm.storm import bake_storm  # noqa: E402
from leaf_storm.units import Problem  # noqa: E402

import langevin_rigid as lr  # noqa: E402
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
            panel.register()
        self.scene = bpy.context.scene
        self.scene.frame_start, self.scene.frame_end = 3, 26
        self.leaf = object_of(Mesh.read_obj(ROOT / "assets" / "leaf.obj"), "Leaf")
        self.scene.collection.objects.link(self.leaf)
        self.asset_path = WORK / "blender_leaf.lrb"
        if not self.asset_path.exists():
            bake_asset(self.leaf, self.asset_path, self.scene, density=350)
        self.asset = lr.Asset.load(self.asset_path)

    def storm(self, mode="POINTS", **settings):
        values = {"count": 40, "rate": 60, "lifetime": 0.3, "center": (0, 0, 3), "size": (2, 2, 1), "gusts": 0.5, **settings}
        cache = str(WORK / "blender.pc2")
        return bake_storm(self.scene, self.leaf, self.asset, Settings(**values), mode, cache)[0]

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
        drawn = next(o for o in bpy.data.objects if o.name.startswith("Leaf about"))
        self.assertFalse(drawn.visible_get())
        self.assertFalse(drawn.hide_viewport)  # it would hide the instances, too

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
        bake_asset(self.leaf, path, self.scene, density=350)
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
        bake_asset(self.leaf, path, self.scene, density=350)
        self.assertAlmostEqual(lr.Asset.load(path).info.mass, self.asset.info.mass, delta=1e-9)
        recording = self.storm(center=(0, 0, 300), size=(200, 200, 100))
        heights = np.concatenate([frame.position[:, 2] for frame in recording])
        self.assertTrue((heights > 1.5).all() and (heights < 4).all())
        self.compare(recording, lambda: instances("Leaf Storm"), 0.01)

    def test_leaves_land_on_colliders_that_move(self):
        bpy.ops.mesh.primitive_cube_add(size=2, location=(0, 0, 0), scale=(3, 3, 0.5))
        table = bpy.context.object
        self.scene.frame_end = 120
        table.keyframe_insert("location", frame=60)
        table.location.z = 0.5
        table.keyframe_insert("location", frame=110)
        recording = self.storm(rate=0, lifetime=0, colliders=[table], center=(0, 0, 1), size=(1, 1, 0.4), ground=False, gusts=0,
                               turbulence=0)
        low = [frame.position[:, 2].min() for frame in recording]
        self.assertGreater(min(low), 0.45)
        self.assertGreater(low[-1], 0.95)
        self.assertLess(low[50], 0.7)

    def add_collider(self, kind, **options):
        getattr(bpy.ops.mesh, f"primitive_{kind}_add")(**options)
        bpy.ops.object.modifier_add(type="COLLISION")
        bpy.context.view_layer.update()
        return bpy.context.object

    def test_objects_with_collision_physics_are_colliders(self):
        plane = self.add_collider("plane", size=8, location=(0, 0, -1))
        box = self.add_collider("cube", size=1, location=(1, 0, -0.5))
        bpy.ops.mesh.primitive_cube_add()
        ghost = bpy.context.object
        group = bpy.data.collections.new("More")
        group.objects.link(ghost)
        group.objects.link(box)
        found = colliders.of_scene(self.scene)
        self.assertEqual({thing.name for thing in found}, {plane.name, box.name})
        self.assertEqual({thing.name for thing in colliders.of_scene(self.scene, group)}, {plane.name, box.name, ghost.name})
        self.assertEqual(colliders.of_scene(self.scene, group, (ghost, box)), [plane])
        box.collision.use = False
        self.assertEqual(colliders.of_scene(self.scene), [plane])

    def test_the_lowest_plane_is_the_ground_and_others_keep_their_edges(self):
        down = np.array([0, 0, -9.81])
        floor = self.add_collider("plane", size=2, location=(0, 0, 0.1), rotation=(0.1, 0, 0))
        table = self.add_collider("plane", size=1, location=(0, 0, 1), rotation=(np.pi, 0, 0))
        wall = self.add_collider("plane", size=1, location=(2, 0, 1), rotation=(0, np.pi / 2, 0))
        box = self.add_collider("cube", size=0.4, location=(0, 0, 0.2))
        surfaces = [colliders.Surface(thing, 1.0) for thing in (floor, table, wall, box)]
        normals = colliders.grounds(surfaces, down, np.array([0, 0, 3]))
        np.testing.assert_allclose(normals[0], [0, -np.sin(0.1), np.cos(0.1)], atol=1e-6)
        self.assertEqual(normals[1:], [None] * 3)
        self.assertEqual(colliders.grounds(surfaces, down, np.array([0, 0, -3])), [None] * 4)
        self.assertEqual(colliders.grounds(surfaces, 0 * down, np.array([0, 0, 3])), [None] * 4)

    def test_leaves_land_on_planes_and_boxes_and_pass_edges(self):
        self.add_collider("plane", size=1)
        box = self.add_collider("cube", size=0.6, location=(0.4, 0, 0.3))
        box.scale.x = 2
        bpy.context.view_layer.update()
        self.scene.frame_end = 160
        recording = self.storm(count=60, rate=0, lifetime=0, ground=False, turbulence=0, gusts=0, center=(0, 0, 1.2), size=(2, 0.5, 0.2),
                               colliders=colliders.of_scene(self.scene))
        last = recording[-1].position
        on_box = (np.abs(last[:, 0] - 0.4) < 0.55) & (np.abs(last[:, 1]) < 0.25)
        self.assertGreater(on_box.sum(), 15)
        self.assertGreater(last[on_box, 2].min(), 0.59)
        outside = np.abs(last[:, 0]) > 0.7
        outside &= ~on_box
        self.assertGreater(outside.sum(), 3)  # beyond the plane's edge, and not fallen
        self.assertGreater(last[:, 2].min(), -0.01)

    def test_a_ground_that_moves_and_tilts(self):
        floor = self.add_collider("plane", size=2)
        floor.keyframe_insert("location", frame=3)
        floor.keyframe_insert("rotation_euler", frame=3)
        floor.location.z, floor.rotation_euler = 0.5, (0, 0.1, 1)
        floor.keyframe_insert("location", frame=7)
        floor.keyframe_insert("rotation_euler", frame=7)
        rays = np.array([[0, 0, 3], [10, 0, 3]], float)
        with lr.World(seed=1) as world:
            self.scene.frame_set(3)
            moving = colliders.Colliders(world, [floor], 1.0, np.array([0, 0, -9.81]), (0, 0, 3), 0.6)
            np.testing.assert_allclose(world.ray_cast(rays, (0, 0, -1), max_distance=9)["distance"], 3, atol=1e-5)
            self.scene.frame_set(7)
            moving.follow()
            world.step(1 / 24)
            normal = floor.matrix_world.to_3x3() @ Vector((0, 0, 1))
            wanted = [2.5, 2.5 + normal.x / normal.z * 10]
            np.testing.assert_allclose(world.ray_cast(rays, (0, 0, -1), max_distance=9)["distance"], wanted, atol=1e-4)

    def test_sheared_colliders(self):
        parent = self.add_collider("cube", size=1, scale=(3, 1, 1))
        child = self.add_collider("cube", size=1, rotation=(0, 0, 0.7))
        child.parent = parent
        bpy.context.view_layer.update()
        surface = colliders.Surface(child, 1.0)
        wanted = [child.matrix_world @ v.co for v in child.data.vertices]
        np.testing.assert_allclose(surface.world, np.array(wanted), atol=1e-6)

    def add_field(self, kind, location=(0, 0, 0), rotation=(0, 0, 0), **values):
        bpy.ops.object.effector_add(type=kind, location=location, rotation=rotation)
        thing = bpy.context.object
        for name, value in values.items():
            setattr(thing.field, name, value)
        bpy.context.view_layer.update()
        return thing

    def wind_at(self, points, **settings):
        with lr.World(seed=1) as world:
            blowing = wind.Wind(world, self.scene, Settings(**{"gusts": 0, "turbulence": 0, **settings}), 1.0)
            blowing.follow()
            world.step(1 / 60)
            return world.sample_wind(points)

    def test_force_fields_are_wind(self):
        here = [[0, 0, 0.2], [3, 0, 0]]
        self.add_field("WIND", rotation=(0, np.pi / 2, 0), strength=2)
        np.testing.assert_allclose(self.wind_at(here, wind=(0, 1, 0)), [[2, 1, 0]] * 2, atol=1e-5)
        self.scene.objects[-1].hide_render = True
        np.testing.assert_allclose(self.wind_at(here), 0, atol=1e-6)

        eddy = self.add_field("VORTEX", strength=4, distance_max=10, use_max_distance=True)
        eddy.empty_display_size = 0.5
        speeds = np.linalg.norm(self.wind_at([[x, 0, 0] for x in np.linspace(0.1, 2, 60)]), axis=1)
        self.assertAlmostEqual(speeds.max(), 4, delta=0.03)
        self.assertAlmostEqual(np.linspace(0.1, 2, 60)[speeds.argmax()], 0.5, delta=0.06)
        self.assertGreater(self.wind_at([[0.5, 0, 0]])[0, 1], 3.9)  # counter-clockwise, seen against its axis
        bpy.data.objects.remove(eddy)

        fan = self.add_field("WIND", location=(0, 0, 1), rotation=(np.pi, 0, 0), strength=5, use_max_distance=True, distance_max=4)
        fan.empty_display_size = 0.3
        down, beside, beyond = self.wind_at([[0, 0, 0.9], [2, 0, 0.9], [0, 0, -3.5]])
        self.assertLess(down[2], -4)
        self.assertLess(np.linalg.norm(beside), 0.2)
        self.assertEqual(np.linalg.norm(beyond), 0)
        bpy.data.objects.remove(fan)

        self.add_field("TURBULENCE", strength=1.5, size=0.5)
        self.add_field("DRAG")
        air = self.wind_at(np.random.default_rng(1).random((2000, 3)) * 30)
        self.assertAlmostEqual(air.std(), 1.5, delta=0.15)
        self.assertEqual([len(part) for part in wind.fields_of(self.scene)], [1, 1])

    def test_fields_that_move_and_change(self):
        fan = self.add_field("WIND", strength=1)
        fan.field.keyframe_insert("strength", frame=3)
        fan.field.strength = 9
        fan.field.keyframe_insert("strength", frame=7)
        self.scene.frame_set(3)
        with lr.World(seed=1) as world:
            blowing = wind.Wind(world, self.scene, Settings(gusts=0, turbulence=0), 1.0)
            np.testing.assert_allclose(world.uniform_wind, (0, 0, 1), atol=1e-6)
            self.scene.frame_set(7)
            blowing.follow()
            np.testing.assert_allclose(world.uniform_wind, (0, 0, 9), atol=1e-6)

    def test_one_mesh_for_other_programs(self):
        self.storm()
        carrier = caches.carrier()
        with caches.as_mesh(carrier):
            counts = set()
            for frame in (3, 12, 20):
                self.scene.frame_set(frame)
                mesh = carrier.evaluated_get(bpy.context.evaluated_depsgraph_get()).data
                counts.add(len(mesh.vertices))
            drawn = np.array([v.co for v in mesh.vertices]).reshape(-1, len(self.leaf.data.vertices), 3)
        self.assertEqual(len(counts), 1)
        placed = np.array(instances("Leaf Storm"))
        centred = next(o for o in bpy.data.objects if o.name.startswith("Leaf about"))
        own = np.array([(*v.co, 1) for v in centred.data.vertices])
        np.testing.assert_allclose(drawn, np.einsum("nij,vj->nvi", placed, own)[..., :3], atol=1e-5)
        self.assertEqual([m.type for m in carrier.modifiers], ["MESH_CACHE", "NODES"])

    def test_exports_by_blender(self):
        self.storm()
        self.scene.leaf_storm.leaf = self.leaf
        for end, part in ((".abc", "alembic"), (".usdc", "usd")):
            path = WORK / f"storm{end}"
            if not getattr(bpy.app.build_options, part):
                with self.assertRaisesRegex(RuntimeError, "was built without"):
                    bpy.ops.leaf_storm.export(filepath=str(path))
                print(f"SKIPPED: export to {end}, for want of a Blender with {part}: blender.org")
                continue
            self.assertEqual(bpy.ops.leaf_storm.export(filepath=str(path)), {"FINISHED"})
            before = set(bpy.data.objects)
            importer = bpy.ops.wm.alembic_import if part == "alembic" else bpy.ops.wm.usd_import
            importer(filepath=str(path))
            read = next(o for o in set(bpy.data.objects) - before if o.type == "MESH")
            self.scene.frame_set(20)
            depsgraph = bpy.context.evaluated_depsgraph_get()
            back = read.evaluated_get(depsgraph)
            got = np.array([back.matrix_world @ v.co for v in back.data.vertices])
            with caches.as_mesh(caches.carrier()):
                mesh = caches.carrier().evaluated_get(bpy.context.evaluated_depsgraph_get()).data
                np.testing.assert_allclose(got, [v.co for v in mesh.vertices], atol=1e-4)

    def test_the_command_with_the_panel_of_a_scene(self):
        with self.assertRaisesRegex(Problem, "has no leaf"):
            command.run(["--panel"])
        self.add_collider("plane", size=1)
        box = self.add_collider("cube", size=1, location=(0, 0, 5))
        bpy.ops.object.modifier_remove(modifier="Collision")
        box.hide_render = True
        storm = self.scene.leaf_storm
        storm.leaf, storm.count, storm.emitter, storm.ground = self.leaf, 30, box, False
        storm.asset, storm.cache = str(WORK / "panel.lrb"), str(WORK / "panel.pc2")
        recording, _ = command.run(["--panel", "--export", str(WORK / "panel.usda")])
        self.assertEqual(list(recording.frame_numbers), list(range(3, 27)))
        first = recording[0].position
        self.assertEqual(len(first), 30)
        self.assertTrue((np.abs(first - (0, 0, 5)) <= 0.5001).all())
        self.assertIn("PointInstancer", (WORK / "panel.usda").read_text()[:2000])

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
        self.assertEqual(bpy.ops.leaf_storm.export(filepath=str(WORK / "operator.usda")), {"FINISHED"})
        stage = usda_reader.read(WORK / "operator.usda")
        self.assertEqual(stage.metadata["upAxis"], "Z")
        self.assertEqual(len(stage.at("/Storm/Leaf").attributes["positions"]["value"][3]), 25)

    def test_a_saved_file_plays_by_itself(self):
        recording = self.storm()
        self.scene.frame_set(20)
        wanted = np.array(instances("Leaf Storm"))
        path = str(WORK / "storm.blend")
        bpy.ops.wm.save_as_mainfile(filepath=path)
        panel.unregister()
        bpy.ops.wm.read_factory_settings(use_empty=True)
        bpy.ops.wm.open_mainfile(filepath=path)
        bpy.context.scene.frame_set(20)
        np.testing.assert_allclose(np.array(instances("Leaf Storm")), wanted, atol=1e-6)
        self.assertEqual(len(recording), 24)


if __name__ == "__main__":
    result = unittest.main(argv=["blender_check"], exit=False, verbosity=1).result
    sys.stderr.flush()
    sys.exit(0 if result.wasSuccessful() and result.testsRun else 1)
