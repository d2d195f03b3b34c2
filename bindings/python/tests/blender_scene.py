# SPDX-License-Identifier: MIT
"""The add-on's zip, installed as a user does it, in a real Blender:  blender -b -P blender_scene.py -- ZIP FOLDER [PICTURE.png]

Bakes 200 leaves over a plane and a box with Collision physics in a wind field by the operators, and checks how they lie. FOLDER gets
the scene as scene.blend. With PICTURE, renders the last frame by Workbench or, where there is no display, by Cycles, and looks for leaves in it.
"""
import os
import pathlib
import sys

import bpy
import numpy as np
from mathutils import Vector

ARCHIVE, FOLDER, *PICTURE = (str(pathlib.Path(path).resolve()) for path in sys.argv[sys.argv.index("--") + 1:])
LEAF = pathlib.Path(__file__).resolve().parents[3] / "assets" / "leaf.obj"


def install():
    """Installs and enables; returns the name of the module."""
    if bpy.app.version >= (4, 2):
        bpy.ops.extensions.package_install_files(filepath=ARCHIVE, repo="user_default", enable_on_install=True)
        return "bl_ext.user_default.leaf_storm"
    bpy.ops.preferences.addon_install(filepath=ARCHIVE)
    bpy.ops.preferences.addon_enable(module="leaf_storm")
    return "leaf_storm"


def coloured(thing, color):
    made = bpy.data.materials.new(thing.name)
    made.use_nodes = True
    made.diffuse_color = (*color, 1)
    made.node_tree.nodes["Principled BSDF"].inputs["Base Color"].default_value = (*color, 1)
    thing.data.materials.append(made)
    return thing


def collider(kind, color, **options):
    getattr(bpy.ops.mesh, f"primitive_{kind}_add")(**options)
    bpy.ops.object.modifier_add(type="COLLISION")
    return coloured(bpy.context.object, color)


def build(scene, module):
    """A plane, a box, an emitter, a wind field from -x, and the panel's settings."""
    leaf_of = __import__(f"{module}.leaf", fromlist=["object_of"]).object_of
    scene.frame_start, scene.frame_end = 1, 121
    collider("plane", (0.16, 0.2, 0.1), size=3)
    collider("cube", (0.35, 0.3, 0.28), size=0.5, location=(0.3, 0, 0.25))
    bpy.ops.mesh.primitive_cube_add(location=(-0.5, 0, 1.3))
    emitter = bpy.context.object
    emitter.scale, emitter.hide_render, emitter.display_type = (0.6, 0.4, 0.3), True, "WIRE"
    bpy.ops.object.effector_add(type="WIND", location=(-2, 0, 0.5), rotation=(0, np.pi / 2, 0))
    bpy.context.object.field.strength = 0.5
    from langevin_rigid.mesh import Mesh
    leaf = coloured(leaf_of(Mesh.read_obj(LEAF), "Leaf"), (0.6, 0.22, 0.04))
    leaf.location, leaf.hide_render = (0, 0, -5), True
    scene.collection.objects.link(leaf)
    bpy.context.view_layer.update()
    storm = scene.leaf_storm
    storm.leaf, storm.count, storm.emitter, storm.ground, storm.heaps = leaf, 200, emitter, False, True
    storm.gusts, storm.turbulence = 0.3, 0.2
    storm.asset, storm.cache = os.path.join(FOLDER, "leaf.lrb"), os.path.join(FOLDER, "storm.pc2")


def places(scene, frame):
    scene.frame_set(frame)
    found = bpy.context.evaluated_depsgraph_get().object_instances
    return np.array([i.matrix_world.copy() for i in found if i.is_instance and i.parent and i.parent.name == "Leaf Storm"])


def check(scene):
    first, last, before = places(scene, 1), places(scene, 121), places(scene, 120)
    assert len(first) == len(last) == 200, (len(first), len(last))
    start, end = first[:, :3, 3], last[:, :3, 3]
    assert (np.abs(start - (-0.5, 0, 1.3)) <= (0.601, 0.401, 0.301)).all(), f"spawned in the emitter: {start.min(0)} to {start.max(0)}"
    assert end[:, 2].min() > -0.01, f"none is below the ground: {end[:, 2].min()}"
    drift = (end - start)[:, 0].mean()
    assert 0.1 < drift < 2, f"the wind has carried them along x: {drift}"
    on_box = (np.abs(end[:, 0] - 0.3) < 0.25) & (np.abs(end[:, 1]) < 0.25) & (end[:, 2] > 0.45)
    inside = (np.abs(end[:, 0] - 0.3) < 0.23) & (np.abs(end[:, 1]) < 0.23) & (end[:, 2] < 0.45)
    assert on_box.sum() >= 5 and not inside.any(), f"{on_box.sum()} on the box, {inside.sum()} in it"
    axes = last[:, :3, 2] / np.linalg.norm(last[:, :3, 2], axis=1)[:, None]
    still = np.linalg.norm(end - before[:, :3, 3], axis=1) < 1e-3
    flat = np.abs(axes[still, 2]) > 0.8
    assert still.mean() > 0.6 and flat.mean() > 0.8, f"{still.mean():.0%} lie still, {flat.mean():.0%} of them flat"
    print(f"blender_scene: drift {drift:.2f} m, {on_box.sum()} on the box, {still.mean():.0%} lie still, {flat.mean():.0%} of them flat")


def render(scene, path):
    sun = bpy.data.objects.new("Sun", bpy.data.lights.new("Sun", "SUN"))
    sun.data.energy, sun.rotation_euler = 3, (0.8, 0.2, 0.6)
    camera = bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera"))
    camera.location = (0.4, -2.3, 1.5)
    camera.rotation_euler = (Vector((0.3, 0, 0.25)) - camera.location).to_track_quat("-Z", "Y").to_euler()
    for thing in (sun, camera):
        scene.collection.objects.link(thing)
    scene.camera = camera
    scene.render.engine = "BLENDER_WORKBENCH" if os.environ.get("DISPLAY") else "CYCLES"
    scene.display.shading.color_type, scene.display.shading.show_shadows = "MATERIAL", True
    scene.cycles.samples, scene.cycles.use_denoising = 32, False
    scene.render.resolution_x, scene.render.resolution_y, scene.render.resolution_percentage = 800, 500, 100
    scene.render.filepath = path
    bpy.ops.render.render(write_still=True)
    seen = np.array(bpy.data.images.load(path).pixels).reshape(-1, 4)
    leaves = (seen[:, 0] > 1.3 * seen[:, 1]) & (seen[:, 1] > 1.3 * seen[:, 2]) & (seen[:, 0] > 0.1)
    assert 0.02 < leaves.mean() < 0.3, f"{leaves.mean():.1%} of the picture are leaves"
    print(f"blender_scene: {leaves.mean():.1%} of the picture are leaves")


def main():
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    module = install()
    import langevin_rigid as lr
    assert lr.library_path().startswith(os.path.dirname(lr.__file__)), lr.library_path()
    print(f"blender_scene: Blender {bpy.app.version_string}, {module}, {lr.library_path()}")
    build(scene, module)
    assert bpy.ops.leaf_storm.bake_asset() == bpy.ops.leaf_storm.bake_storm() == {"FINISHED"}
    check(scene)
    bpy.ops.wm.save_as_mainfile(filepath=os.path.join(FOLDER, "scene.blend"))
    for path in PICTURE:
        render(scene, path)


main()
