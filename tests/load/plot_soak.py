#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Plots the measurements of `lr_load soak HOURS CSV`: plot_soak.py CSV PNG"""
import csv
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt


def smooth(values, width):
    """Means over `width` minutes, so that curves stay distinguishable."""
    return [sum(values[max(0, i - width + 1) : i + 1]) / len(values[max(0, i - width + 1) : i + 1]) for i in range(len(values))]


def main():
    with open(sys.argv[1], newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    hours = [float(r["minute"]) / 60.0 for r in rows]

    def column(name, scale=1.0):
        return [float(r[name]) * scale for r in rows]

    figure, axes = plt.subplots(4, 1, figsize=(9, 9), sharex=True, constrained_layout=True)
    axes[0].plot(hours, column("world_bytes", 1 / 1024), label="world (memory_bytes)")
    axes[0].plot(hours, column("resident_bytes", 1 / 1024), label="process (resident)")
    axes[0].set(ylabel="KB", ylim=(0, None), title="Memory")
    axes[0].legend(loc="center right")
    axes[1].plot(hours, column("quaternion_error", 1e7), linewidth=0.7)
    axes[1].set(ylabel="1e-7", ylim=(0, None), title="Quaternions: largest | |q| - 1 | of each minute")
    for name in ("leaves", "discs", "petals", "wanderers"):
        axes[2].plot(hours, smooth(column(name + "_speed"), 20), linewidth=0.9, label=name)
    axes[2].set(ylabel="m/s", ylim=(0, None), title="Mean speed of those that move, over 20 minutes")
    axes[2].set_ylim(top=1.35 * axes[2].get_ylim()[1])
    axes[2].legend(loc="upper left", ncol=4)
    axes[3].plot(hours, column("bodies"), linewidth=0.7)
    axes[3].set(ylabel="bodies", xlabel="simulated hours", ylim=(0, None), title="Bodies alive")
    for a in axes:
        a.grid(alpha=0.3)
    figure.savefig(sys.argv[2], dpi=80)


main()
