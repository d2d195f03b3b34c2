# SPDX-License-Identifier: MIT
"""Bakes a storm of falling leaves without a window.

    blender -b [scene.blend] -P leaf_storm/__main__.py -- --mesh leaf.obj [--count 300] [--frames 96] [--mode points|keyframes]
    blender -b scene.blend -P leaf_storm/__main__.py -- --panel

--mesh takes a leaf from a file, --panel the leaf and all settings that the scene's panel has. Both use the scene's colliders and
force fields. Then, for both: [--export storm.abc] [--save out.blend] [--render picture.png --at 60].
"""
import argparse
import os
import sys

import bpy
import langevin_rigid as lr
from langevin_rigid.mesh import Mesh

from . import caches, colliders, panel, picture
from .leaf import bake_asset, object_of
from .operators import checked_path
from .simulate import Settings
from .storm import bake_storm
from .units import Problem, metres_per_unit


def parse(arguments):
    parser = argparse.ArgumentParser(prog="leaf_storm", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    source = parser.add_mutually_exclusive_group(required=True)
    source.add_argument("--mesh", help="OBJ mesh of a leaf, in metres")
    source.add_argument("--panel", action="store_true", help="all from the panel of the scene that was opened")
    parser.add_argument("--asset", help="made by lr_bake from the same mesh; otherwise it is baked, for --mesh beside the cache")
    parser.add_argument("--density", type=float, default=350, help="density for the bake, kg/m^3")
    parser.add_argument("--count", type=int, default=300)
    parser.add_argument("--frames", type=int, help="from 1; default 96, with --panel the scene's")
    parser.add_argument("--wind", type=float, nargs=3, default=(1.0, 0.0, 0.0), metavar=("X", "Y", "Z"), help="m/s")
    parser.add_argument("--size", type=float, nargs=3, default=(2.0, 2.0, 1.0), metavar=("X", "Y", "Z"), help="size of the spawn box, m")
    parser.add_argument("--height", type=float, default=2.0, help="center of the spawn box, m")
    parser.add_argument("--mode", choices=("points", "keyframes"), default="points")
    parser.add_argument("--cache", default="leaf_storm.pc2")
    parser.add_argument("--export", help=f"cache for other programs: {caches.KINDS}")
    parser.add_argument("--save", help=".blend file to write")
    parser.add_argument("--render", help="picture of frame --at; with --panel as the scene is, else by Cycles with a ground and a sun")
    parser.add_argument("--at", type=int, default=48)
    return parser.parse_args(arguments)


def from_panel(options, scene):
    storm = scene.leaf_storm
    if storm.leaf is None:
        raise Problem("the panel of this scene has no leaf: choose it in Blender, and save the file")
    path = os.path.abspath(options.asset) if options.asset else checked_path(storm.asset, "Asset")
    checked_path(storm.cache, "Cache")
    return storm.leaf, path, storm.settings(scene), storm.mode, storm.cache, {"density": storm.density}


def from_options(options, scene):
    cache = os.path.abspath(options.cache)
    path = options.asset or os.path.join(os.path.dirname(cache), "leaf_storm.lrb")
    settings = Settings(count=options.count, wind=options.wind, center=(0, 0, options.height), size=options.size, gusts=0.5,
                        colliders=colliders.of_scene(scene))
    return object_of(Mesh.read_obj(options.mesh), "Leaf"), path, settings, options.mode.upper(), cache, {"density": options.density}


def run(arguments):
    """Carries out a command; returns the recording and the collection."""
    options = parse(arguments)
    if options.export:
        caches.kind_of(options.export)
    scene = bpy.context.scene
    if options.frames or not options.panel:
        scene.frame_start, scene.frame_end = 1, options.frames or 96
    leaf, path, settings, mode, cache, baking = (from_panel if options.panel else from_options)(options, scene)
    if not options.asset and not (options.panel and os.path.exists(path)):
        bake_asset(leaf, path, scene, **baking)
    asset = lr.Asset.load(path)
    recording, collection = bake_storm(scene, leaf, asset, settings, mode, cache)
    print(f"leaf_storm: {len(recording)} frames, {settings.count} leaves, {len(settings.colliders)} colliders, "
          f"{len(collection.objects)} objects")
    if options.export:
        export = os.path.abspath(options.export)
        if caches.kind_of(export) in caches.BY_BLENDER:
            caches.export_by_blender(scene, export)
        else:
            caches.export_points(scene, leaf, asset, settings, export, recording)
    if options.render:
        at = min(max(options.at, scene.frame_start), scene.frame_end)
        if options.panel:
            picture.render_frame(scene, at, os.path.abspath(options.render))
        else:
            middle = recording[at - scene.frame_start].position.mean(axis=0) / metres_per_unit(scene)
            picture.render(scene, leaf, at, middle.tolist(), os.path.abspath(options.render))
    if options.save:
        bpy.ops.wm.save_as_mainfile(filepath=os.path.abspath(options.save))
    return recording, collection


def start(arguments):
    """Runs as a program: a problem ends Blender with status 1."""
    if not hasattr(bpy.types.Scene, "leaf_storm"):
        panel.register()
    try:
        run(arguments)
    except (Problem, lr.Error, OSError) as problem:
        print(f"leaf_storm: {problem}", file=sys.stderr)
        sys.exit(1)
