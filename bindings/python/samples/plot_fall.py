#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Plots paths of a leaf released at several tilts, seen from the side. Needs matplotlib.

    plot_fall.py fall.png [--asset leaf.lrb] [--tilts 7] [--seconds 3]
"""
import argparse

import matplotlib
import numpy as np

import langevin_rigid as lr

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402

parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
parser.add_argument("out")
parser.add_argument("--asset", help="made by lr_bake; otherwise a thin ellipsoid")
parser.add_argument("--tilts", type=int, default=7)
parser.add_argument("--seconds", type=float, default=3.0)
options = parser.parse_args()

leaf = lr.Asset.load(options.asset) if options.asset else lr.Asset.ellipsoid(semi_axes=(0.04, 0.02, 0.0002), density=800)
tilts = np.radians(np.linspace(5, 85, options.tilts))
steps = int(options.seconds * 240)
path = np.empty((steps, options.tilts, 3), np.float32)

with lr.World(seed=1) as world:
    batch = world.create_batch(leaf, options.tilts, noise_gain=0)
    batch.set_aerodynamics(intensity=0)  # without noise the fall is the same for any seed
    lying = np.stack([np.sin((tilts - np.pi / 2) / 2), 0 * tilts, 0 * tilts, np.cos((tilts - np.pi / 2) / 2)], axis=-1)
    ids = batch.create(orientation=lying)
    for step in range(steps):
        world.step(1 / 240, 1)
        path[step] = batch.view().position.stack()

figure, axes = plt.subplots(figsize=(9, 4.5), layout="constrained")
for i, tilt in enumerate(tilts):
    axes.plot(path[:, i, 2] + 0.5 * i, path[:, i, 1], label=f"{np.degrees(tilt):.0f}°")
axes.set(xlabel="sideways, m (starts are 0.5 m apart)", ylabel="height, m", title=f"{leaf.info.name}: {options.seconds:g} s of falling")
axes.set_aspect("equal")
axes.legend(title="released at", loc="center left", bbox_to_anchor=(1, 0.5))
figure.savefig(options.out, dpi=90)
print(f"{options.tilts} falls of {float(-path[-1, :, 1].mean()):.2f} m on average: {options.out}")
