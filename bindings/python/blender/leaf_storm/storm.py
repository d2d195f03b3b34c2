# SPDX-License-Identifier: MIT
"""Bakes a storm into objects of the scene."""
import bpy

from .carrier import build_points
from .keyframes import build_keyframes
from .leaf import prototype_of
from .simulate import simulate
from .units import Problem, in_units, metres_per_unit

NAME = "Leaf Storm"  # of the collection and the carrier


def remove_old():
    old = bpy.data.collections.get(NAME)
    if old is not None:
        for thing in list(old.objects):
            bpy.data.objects.remove(thing, do_unlink=True)
        bpy.data.collections.remove(old)


def bake_storm(scene, leaf, asset, settings, mode, cache_path, progress=lambda part: None):
    """Simulates and builds objects; returns the recording in metres and the collection."""
    metres = metres_per_unit(scene)
    recording = simulate(scene, asset, settings, progress)
    if not any(len(frame.ids) for frame in recording):
        raise Problem("no leaf was spawned in these frames: raise the rate or the number of frames")
    remove_old()
    collection = bpy.data.collections.new(NAME)
    scene.collection.children.link(collection)
    prototype = prototype_of(leaf, asset, metres)
    scaled = in_units(recording, metres)
    if mode == "KEYFRAMES":
        build_keyframes(scaled, prototype, collection)
        bpy.data.objects.remove(prototype)
    else:
        collection.objects.link(prototype)
        prototype.hide_render = True
        for layer in scene.view_layers:  # not hide_viewport, which also hides its instances there
            prototype.hide_set(True, view_layer=layer)
        build_points(scaled, prototype, collection, cache_path)
    return recording, collection
