#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Writes a storm of leaves over a ground as a USD point instancer and as a NumPy archive.

    storm_to_usd.py assets/leaf.obj storm.usda [--count 500] [--frames 120] [--density 350]
"""
import argparse
import os
import tempfile

import langevin_rigid as lr
from langevin_rigid.export import write_usda
from langevin_rigid.mesh import Mesh

parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
parser.add_argument("mesh")
parser.add_argument("out")
parser.add_argument("--count", type=int, default=500)
parser.add_argument("--frames", type=int, default=120)
parser.add_argument("--fps", type=float, default=24.0)
parser.add_argument("--density", type=float, default=350.0, help="kg/m^3")
options = parser.parse_args()

with tempfile.TemporaryDirectory() as folder:
    baked = os.path.join(folder, "leaf.lrb")
    lr.bake(options.mesh, baked, density=options.density)
    leaf = lr.Asset.load(baked)

# Transforms place the centre of mass, so the drawn mesh has its origin there.
drawn = Mesh.read_obj(options.mesh).moved(-leaf.info.center_of_mass)
recording = lr.Recording(fps=options.fps)

with lr.World(seed=7) as world:
    world.add_plane(friction=0.7)
    world.set_uniform_wind((2, 0, 0))
    world.add_gusts(direction=(1, 0, 0), rms=1.5, integral_time=2)
    world.add_turbulence(rms=0.5, integral_length=1)
    batch = world.create_batch(leaf, capacity=options.count)
    batch.set_emitter(shape=lr.EmitterShape.BOX, position=(0, 3, 0), size=(2, 0.5, 2), scale_min=0.7, scale_max=1.3)
    batch.emit(options.count)
    for _ in range(options.frames):
        recording.capture(batch)
        world.step(1 / options.fps, substeps=5)

write_usda(options.out, recording, drawn)
recording.save(os.path.splitext(options.out)[0] + ".npz")
print(f"{options.count} leaves, {len(recording)} frames: {options.out}, {os.path.getsize(options.out) / 1e6:.1f} MB")
