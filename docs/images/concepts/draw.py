#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Draws the pictures of docs/guide/concepts.md, as SVG beside this file. The falls are computed by the library itself:

    LANGEVIN_RIGID_LIBRARY=PREFIX/lib PYTHONPATH=bindings/python docs/images/concepts/draw.py
"""
import math
from pathlib import Path

import numpy as np

import langevin_rigid as lr

HERE = Path(__file__).parent
INK, SOFT, PAPER, AIR, LEAF, RED, GREEN = "#2b2b2b", "#7a746b", "#fbfaf7", "#9ec5dd", "#d9822b", "#b33c00", "#5b8c3a"


class Picture:
    def __init__(self, name: str, width: int, height: int, title: str) -> None:
        self.path, self.parts = HERE / f"{name}.svg", []
        self.head = (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" font-family="sans-serif" font-size="13" '
                     f'fill="{INK}"><title>{title}</title><rect width="{width}" height="{height}" rx="8" fill="{PAPER}"/>\n')

    def add(self, text: str) -> None:
        self.parts.append(text)

    def text(self, x: float, y: float, words: str, anchor: str = "middle", color: str = INK, bold: bool = False, size: int = 13) -> None:
        self.add(f'<text x="{x:g}" y="{y:g}" text-anchor="{anchor}" fill="{color}" font-size="{size}"{" font-weight=" + chr(34) + "bold" + chr(34) if bold else ""}>{words}</text>')

    def box(self, x: float, y: float, w: float, h: float, fill: str = "none", stroke: str = SOFT, dash: str = "", r: float = 5) -> None:
        self.add(f'<rect x="{x:g}" y="{y:g}" width="{w:g}" height="{h:g}" rx="{r:g}" fill="{fill}" stroke="{stroke}"{f" stroke-dasharray={chr(34)}{dash}{chr(34)}" if dash else ""}/>')

    def line(self, points, color: str = INK, width: float = 1.5, extra: str = "") -> None:
        d = "M" + " L".join(f"{x:.1f} {y:.1f}" for x, y in points)
        self.add(f'<path d="{d}" fill="none" stroke="{color}" stroke-width="{width:g}" {extra}/>')

    def arrow(self, x0: float, y0: float, x1: float, y1: float, color: str = INK, width: float = 2) -> None:
        a, n = math.atan2(y1 - y0, x1 - x0), 4 + 2 * width
        head = [(x1 + n * math.cos(a + s), y1 + n * math.sin(a + s)) for s in (2.7, -2.7)]
        self.line([(x0, y0), (x1 - n * 0.7 * math.cos(a), y1 - n * 0.7 * math.sin(a))], color, width)
        self.add(f'<path d="M{x1:.1f} {y1:.1f} L{head[0][0]:.1f} {head[0][1]:.1f} L{head[1][0]:.1f} {head[1][1]:.1f}Z" fill="{color}"/>')

    def leaf(self, x: float, y: float, length: float, angle: float, color: str = LEAF, mesh: bool = False) -> None:
        """A leaf seen from above; mesh: with its triangles."""
        self.add(f'<g transform="translate({x:g} {y:g}) rotate({angle:g}) scale({length / 100:g})">'
                 f'<path d="M-50 0C-25-38 20-30 50 0C20 30-25 38-50 0Z" fill="{"none" if mesh else color}" stroke="{color}" stroke-width="{150 / length:g}"/>'
                 f'<path d="{"M-50 0L50 0M-20-26L-20 26M15-24L15 24M-20-26L15 24M15-24L50 0M-50 0L-20 26" if mesh else "M-66 0L42 0"}" stroke="{color if mesh else PAPER}" '
                 f'stroke-width="{(100 if mesh else 200) / length:g}" fill="none"/></g>')

    def write(self) -> None:
        self.path.write_text(self.head + "\n".join(self.parts) + "\n</svg>\n", encoding="utf-8")
        print(f"{self.path.name}: {self.path.stat().st_size} bytes")


def bake() -> None:
    p = Picture("bake", 760, 170, "From a mesh to motion")
    for i, (name, note) in enumerate((("mesh", "leaf.obj"), ("asset", "leaf.lrb"), ("batch", "in a world"), ("transforms", "for your renderer"))):
        x = 20 + 196 * i
        p.box(x, 40, 132, 92)
        p.text(x + 66, 30, name, bold=True)
        p.text(x + 66, 150, note, color=SOFT)
        if i < 3:
            p.arrow(x + 138, 86, x + 190, 86)
            p.text(x + 164, 76, ("lr_bake", "create", "step")[i], size=11)
    p.leaf(86, 86, 90, -20, GREEN, mesh=True)
    for k, words in enumerate(("mass, inertia", "added mass", "drag and lift", "hull")):
        p.text(282, 62 + 20 * k, words, size=12)
    for k in range(14):
        p.leaf(430 + (k % 5) * 24 + 5 * (k % 2), 56 + (k // 5) * 28 + 6 * (k % 3), 20, 47 * k)
    for k in range(4):
        p.text(674, 64 + 18 * k, ("0.6 -0.8 0 1.2", "0.8  0.6 0 5.1", "0  0  1  0.4", "…")[k], size=11)
    p.write()


def world() -> None:
    p = Picture("world", 760, 250, "A world, its batches, and their bodies")
    p.box(10, 30, 740, 210)
    p.text(20, 22, "world: a clock, a seed, gravity, a fluid", "start", bold=True)
    for i, (name, words) in enumerate((("wind", "uniform, gusts, vortices, blowers, grids"), ("water", "a surface, waves, a current"), ("colliders", "ground, boxes, meshes: still or moving"))):
        p.box(22 + 244 * i, 42, 230, 46)
        p.text(137 + 244 * i, 61, name, bold=True)
        p.text(137 + 244 * i, 79, words, size=11, color=SOFT)
    for row, (asset, awake, asleep, room) in enumerate((("leaf.lrb", 9, 12, 3), ("petal.lrb", 5, 3, 8))):
        y = 104 + 66 * row
        p.box(22, y, 718, 56)
        p.text(34, y + 22, "batch", "start", bold=True)
        p.text(34, y + 42, f"of {asset}", "start", color=SOFT, size=12)
        x = 130.0
        for count, fill, angle in ((awake, LEAF, 1), (asleep, "#b9a58c", 0), (room, "none", 0)):
            for k in range(count):
                p.box(x, y + 12, 22, 32, stroke="#c9c2b6", r=2)
                if fill != "none":
                    p.leaf(x + 11, y + 28, 19, 47 * k * angle, fill)
                x += 25
    p.text(242, 236, "awake bodies first", size=11, color=SOFT)
    p.text(500, 236, "then those asleep", size=11, color=SOFT)
    p.text(690, 236, "room up to capacity", size=11, color=SOFT)
    p.write()


def added_mass() -> None:
    p = Picture("added_mass", 760, 240, "Added mass: the air that moves along with a body")
    for x, title, rx, ry, w, h in ((200, "broadside: much air has to move along", 74, 52, 120, 6), (570, "edge on: hardly any", 9, 62, 6, 120)):
        p.text(x, 26, title, bold=True)
        p.add(f'<ellipse cx="{x}" cy="105" rx="{rx}" ry="{ry}" fill="{AIR}" opacity=".55"/>')
        p.box(x - w / 2, 105 - h / 2, w, h, LEAF, LEAF, r=2)
        p.arrow(x, 105 + h / 2 + 2, x, 105 + h / 2 + (80 if h < 50 else 36), RED)
    for side in (-1, 1): # the air goes round
        for k in range(2):
            p.add(f'<path d="M{200 + side * (30 + 24 * k)} 124C{200 + side * (88 + 26 * k)} 134 {200 + side * (88 + 26 * k)} 76 {200 + side * (30 + 24 * k)} 84" fill="none" stroke="#4c86a8" stroke-width="1.3"/>')
    p.text(380, 228, "so a plate that is pushed turns broadside to its path, and leaves flutter instead of falling like stones", "middle", SOFT, size=12)
    p.write()


def forces() -> None:
    p = Picture("forces", 760, 270, "Forces on a leaf")
    x, y, tilt = 330, 130, 22
    c, s = math.cos(math.radians(tilt)), math.sin(math.radians(tilt))
    for k in range(4):
        p.line([(40, 60 + 46 * k), (150, 60 + 46 * k)], AIR, 2)
        p.arrow(120, 60 + 46 * k, 160, 60 + 46 * k, "#4c86a8", 1.6)
    p.text(98, 30, "wind", color="#4c86a8", bold=True)
    for k in range(3): # its own wake
        p.add(f'<path d="M{x - 50 + 34 * k} {y - 30 - 6 * k}q10-14 0-26q-10-12 2-24" fill="none" stroke="{AIR}" stroke-width="2.2"/>')
    p.text(x - 16, y - 100, "its own wake: turbulence", color="#4c86a8", size=12)
    p.add(f'<path d="M{x - 70 * c:.1f} {y - 70 * s:.1f}L{x + 70 * c:.1f} {y + 70 * s:.1f}" stroke="{LEAF}" stroke-width="8" stroke-linecap="round"/>')
    p.arrow(x, y, x, y + 92, INK, 2.4)
    p.text(x - 8, y + 88, "weight less buoyancy", "end")
    p.arrow(x, y, x + 110 * c * .9, y + 110 * s * 2.1, "#999", 1.6)
    p.text(x + 98, y + 84, "velocity through the air", "start", SOFT, size=12)
    p.arrow(x, y, x - 64, y - 58, RED)
    p.text(x - 70, y - 62, "drag", "end", RED)
    p.arrow(x, y, x + 62, y - 74, RED)
    p.text(x + 68, y - 74, "lift", "start", RED)
    p.add(f'<path d="M{x + 84} {y - 6}a34 34 0 0 1 6 44" fill="none" stroke="{GREEN}" stroke-width="2"/>')
    p.arrow(x + 92, y + 30, x + 86, y + 46, GREEN)
    p.text(x + 106, y + 6, "moments: lift off the centre,", "start", GREEN)
    p.text(x + 106, y + 24, "added mass (Munk), damping of spin", "start", GREEN)
    p.line([(20, 252), (740, 252)], SOFT, 3)
    p.text(736, 244, "contact: friction, bounces, rolling resistance", "end", SOFT, size=12)
    p.write()


def steps() -> None:
    p = Picture("steps", 760, 190, "Steps, substeps and rates")
    left, frame = 170, 135
    p.text(20, 30, "lr_world_step(world, 1/60, 4)", "start", bold=True)
    for k in range(5):
        p.line([(left + frame * k, 42), (left + frame * k, 168)], "#c9c2b6", 1, 'stroke-dasharray="4 3"')
        if k < 4:
            p.text(left + frame * (k + .5), 48, f"step {k + 1}", color=SOFT, size=12)
    for y, name, substeps in ((74, "batch near the camera", 4), (110, "divisor 2", 2), (146, "divisor 4", 1)):
        p.text(left - 12, y + 4, name, "end", size=12)
        p.line([(left, y), (left + 4 * frame, y)], SOFT, 1)
        for k in range(4 * substeps):
            x0 = left + frame * k / substeps
            p.box(x0 + 2, y - 9, frame / substeps - 4, 18, LEAF if substeps == 4 else "#e5b27f" if substeps == 2 else "#f0d9c0", "none", r=3)
    p.text(left + 2 * frame, 182, "a box is a substep: batches far away take fewer, longer ones", color=SOFT, size=12)
    p.write()


def sleep() -> None:
    p = Picture("sleep", 760, 170, "Awake, asleep, held")
    for x, name, words in ((40, "awake", "stepped, drawn anew"), (330, "asleep", "costs a step nothing"), (610, "held", "where it was last valid")):
        p.box(x, 56, 130, 54, "#fff")
        p.text(x + 65, 78, name, bold=True)
        p.text(x + 65, 97, words, color=SOFT, size=11)
    p.arrow(174, 72, 324, 72)
    p.text(249, 62, "touches something, still", size=12)
    p.arrow(324, 96, 174, 96)
    p.text(249, 116, "a force, stronger wind,", size=12)
    p.text(249, 132, "a moving collider,", size=12)
    p.text(249, 148, "a support that is gone", size=12)
    p.add(f'<path d="M105 52C105 8 675 8 675 50" fill="none" stroke="{RED}" stroke-width="2"/>')
    p.arrow(675, 44, 675, 54, RED)
    p.text(390, 36, "diverged: forces beyond physics (or destroyed, or respawned)", color=RED, size=12)
    p.write()


def falls() -> None:
    """Side views of falls, the body drawn at even times. Of some bodies with the usual variation and wakes the `pick`th."""
    water = {"fluid_density": 1000.0, "fluid_viscosity": 1e-6}
    bodies = (("paper, 10 x 7 cm", (0.05, 0.035, 0.00005), 800, {}, 0.055, 1.5, 3), ("strip of paper, 8 x 2 cm", (0.04, 0.01, 0.0001), 800, {}, 0.03, 1.1, 0),
              ("confetti paper, 12 x 6 mm", (0.006, 0.003, 0.00005), 800, {}, 0.01, 0.35, 5), ("coin in water", (0.0116, 0.0116, 0.0012), 7800, water, 0.035, 0.45, 2))
    p = Picture("falls", 760, 330, "Falls, computed by the library")
    for i, (name, axes, density, fluid, every, height, pick) in enumerate(bodies):
        with lr.World(seed=3, **fluid) as scene:
            batch = scene.create_batch(lr.Asset.ellipsoid(semi_axes=axes, density=density, **fluid), capacity=8)
            batch.spawn_box((0, 0, 0), (0, 0, 0), 8)
            shapes = []
            for step in range(4000):
                view = batch.view()
                x, y = float(view.position.x[pick]), float(view.position.y[pick])
                if step % round(every * 480) == 0:
                    qx, qy, qz, qw = view.orientation.stack()[pick]
                    u = (1 - 2 * (qy * qy + qz * qz), 2 * (qx * qy + qw * qz)) # x and y of the long axis, and of the other
                    v = (2 * (qx * qy - qw * qz), 1 - 2 * (qx * qx + qz * qz))
                    shapes.append((x, y, u, v))
                if y < -height:
                    break
                scene.step(1 / 480, substeps=1)
        scale, cx = 270 / height, 95 + 190 * i
        middle = (min(s[0] for s in shapes) + max(s[0] for s in shapes)) / 2
        p.text(cx, 24, name, size=12, bold=True)
        if fluid:
            p.box(cx - 90, 36, 180, 286, "#dcecf5", "none")
        corners = [(1, 1), (1, -1), (-1, -1), (-1, 1)] if "paper" in name else [(math.cos(k * math.pi / 6), math.sin(k * math.pi / 6)) for k in range(12)]
        for x, y, u, v in shapes:
            a, b = axes[0] * scale, axes[1] * scale
            points = [(cx + (x - middle) * scale + a * c * u[0] + b * s * v[0], 48 - y * scale - a * c * u[1] - b * s * v[1]) for c, s in corners]
            p.add('<path d="M' + "L".join(f"{px:.1f} {py:.1f}" for px, py in points) + 'Z"/>')
    p.parts = [f'<g fill="{LEAF}" fill-opacity=".45" stroke="{LEAF}">' + "\n".join(q for q in p.parts if q.startswith("<path")) + "</g>"] + [q for q in p.parts if not q.startswith("<path")]
    p.parts.reverse()
    p.write()


for draw in (bake, world, added_mass, forces, steps, sleep, falls):
    draw()
