#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Plots the fall of a sheet released at several tilts, seen from the side, as a strobe light shows it. Needs matplotlib.

    plot_fall.py fall.png [--asset leaf.lrb] [--tilts 6] [--seconds 2]
"""
import argparse

import matplotlib
import numpy as np

import langevin_rigid as lr
from langevin_rigid.view import turned

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.collections import LineCollection  # noqa: E402

parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
parser.add_argument("out")
parser.add_argument("--asset", help="made by lr_bake from a mesh in its x-y plane; otherwise a disc of paper, 10 cm")
parser.add_argument("--tilts", type=int, default=6)
parser.add_argument("--seconds", type=float, default=2.0)
options = parser.parse_args()
if options.tilts < 1 or options.seconds <= 0:
    parser.error("--tilts must be at least 1 and --seconds greater than 0")

sheet = lr.Asset.load(options.asset) if options.asset else lr.Asset.ellipsoid(semi_axes=(0.05, 0.05, 0.00005), density=800)
tilts = np.radians(np.linspace(10, 80, options.tilts))
steps, flash = int(options.seconds * 240), 6  # a flash every 6 steps: 40 in a second
center = np.empty((steps, options.tilts, 3), np.float32)
arm = np.empty_like(center)

with lr.World(seed=1) as world:
    batch = world.create_batch(sheet, options.tilts, noise_gain=0)
    batch.set_aerodynamics(intensity=0)  # without noise the fall is the same for any seed
    lying = np.stack([np.sin((tilts - np.pi / 2) / 2), 0 * tilts, 0 * tilts, np.cos((tilts - np.pi / 2) / 2)], axis=-1)
    batch.create(orientation=lying)  # turned about x: the sheet's y axis is in the plane of the picture
    for step in range(steps):
        center[step] = batch.view().position.stack()
        arm[step] = turned(batch.view().orientation.stack(), np.tile(np.array([0, 1, 0], np.float32), (options.tilts, 1)))
        world.step(1 / 240, 1)

half = sheet.info.length_d / 2
ends = np.stack([center - half * arm, center + half * arm], axis=2)[..., [2, 1]]  # step, tilt, end, (sideways, height)
figure, axes = plt.subplots(figsize=(11, 4.2), layout="constrained")
right = 0.0
for i, tilt in enumerate(tilts):  # side by side, each with the room that it needs
    ends[:, i, :, 0] += right - ends[:, i, :, 0].min()
    right = ends[:, i, :, 0].max() + 0.15
    start = ends[0, i].mean(axis=0)
    axes.annotate(f"{np.degrees(tilt):.0f}°", start, xytext=(0, 12), textcoords="offset points", ha="center")
    strobe = LineCollection(list(ends[::flash, i]), array=np.arange(0, steps, flash) / 240, cmap="viridis", linewidth=1.5)
    axes.add_collection(strobe)
axes.set(xlabel="sideways, m", ylabel="height, m")
axes.set_title(f"{sheet.info.name}: released at these angles from lying flat", pad=24)
axes.autoscale()
axes.set_aspect("equal")
axes.spines[["top", "right"]].set_visible(False)
figure.colorbar(strobe, label="s", shrink=0.8)
figure.savefig(options.out, dpi=90)
print(f"{options.tilts} falls of {float(-center[-1, :, 1].mean()):.2f} m on average: {options.out}")
