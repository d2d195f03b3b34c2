# SPDX-License-Identifier: MIT
"""Caches for other programs: Alembic and USD by Blender's own exporters, and USD point instancers by langevin_rigid."""
import contextlib
import os

import bpy
from langevin_rigid.export import write_usda

from .leaf import to_mesh
from .nodes import realize_group
from .simulate import simulate
from .storm import NAME
from .units import Problem, metres_per_unit

BY_BLENDER = {".abc": "alembic", ".usd": "usd", ".usdc": "usd"}
KINDS = ".abc (Alembic), .usd, .usdc (USD: one mesh that moves) or .usda (USD: a point instancer)"


def kind_of(path):
    end = os.path.splitext(path)[1].lower()
    if end not in BY_BLENDER and end != ".usda":
        raise Problem(f"{os.path.basename(path)}: the name of a cache ends in {KINDS}")
    return end


def carrier():
    made = bpy.data.objects.get(NAME)
    if made is None or not made.modifiers:
        raise Problem("bake the storm first, as instances")
    return made


@contextlib.contextmanager
def as_mesh(thing):
    """Turns the carrier's instances into one mesh. Its vertices are the same in all frames: a leaf that does not exist yet, or no
    longer, has size 0. Every program reads that; instances come and go, which Alembic has no way to say."""
    modifier = thing.modifiers.new("As a mesh", "NODES")
    modifier.node_group = realize_group()
    try:
        yield
    finally:
        thing.modifiers.remove(modifier)


@contextlib.contextmanager
def selected_alone(thing):
    layer = bpy.context.view_layer
    before, active = [other for other in layer.objects if other.select_get()], layer.objects.active
    for other in before:
        other.select_set(False)
    thing.select_set(True)
    layer.objects.active = thing
    try:
        yield
    finally:
        thing.select_set(False)
        for other in before:
            other.select_set(True)
        layer.objects.active = active


def export_by_blender(scene, path):
    """Writes the baked storm as one mesh whose vertices move, by Blender's exporter for the name's ending."""
    kind = BY_BLENDER[kind_of(path)]
    if not getattr(bpy.app.build_options, kind):
        raise Problem(f"this Blender {bpy.app.version_string} was built without {'Alembic' if kind == 'alembic' else 'USD'} (Debian's is): "
                      "take blender.org's, or write .usda")
    thing = carrier()
    with as_mesh(thing), selected_alone(thing):
        if kind == "alembic":
            done = bpy.ops.wm.alembic_export(filepath=path, selected=True, start=scene.frame_start, end=scene.frame_end,
                                             evaluation_mode="RENDER", as_background_job=False, check_existing=False)
        else:
            done = bpy.ops.wm.usd_export(filepath=path, selected_objects_only=True, export_animation=True,
                                         evaluation_mode="RENDER", check_existing=False)
    if done != {"FINISHED"} or not os.path.exists(path):
        raise Problem(f"{path}: Blender did not write it")


def export_points(scene, leaf, asset, settings, path, recording=None):
    """Writes a point instancer by langevin_rigid: a recording, or the scene simulated anew."""
    mesh = to_mesh(leaf.data, metres_per_unit(scene)).moved(-asset.info.center_of_mass)
    write_usda(path, recording or simulate(scene, asset, settings), mesh, up_axis="Z", names=[leaf.name])
