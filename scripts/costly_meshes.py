#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Makes meshes of 30,000 triangles that are costly to solve, and bakes them if --bake names lr_bake.

    scripts/costly_meshes.py FOLDER [--bake PATH]

Prints seconds of processor time and memory of each bake; fails if one takes more than 20 s or 2 GB.
"""
import argparse
import math
import os
import pathlib
import random
import subprocess
import sys

SECONDS, MEGABYTES = 20, 2000


class Mesh:
    def __init__(self):
        self.vertices, self.faces = [], []

    def add(self, vertices, faces):
        first = len(self.vertices)
        self.vertices += vertices
        self.faces += [tuple(first + i for i in face) for face in faces]

    def grid(self, columns, rows, place):
        """place(u, v) on 0..1."""
        at = lambda i, j: i * (rows + 1) + j
        cells = [(i, j) for i in range(columns) for j in range(rows)]
        self.add([place(i / columns, j / rows) for i in range(columns + 1) for j in range(rows + 1)],
                 [f for i, j in cells for f in ((at(i, j), at(i + 1, j), at(i + 1, j + 1)), (at(i, j), at(i + 1, j + 1), at(i, j + 1)))])

    def write(self, path):
        lines = ["v %.7g %.7g %.7g" % tuple(v) for v in self.vertices] + ["f %d %d %d" % tuple(i + 1 for i in f) for f in self.faces]
        path.write_text("\n".join(lines) + "\n")


def circle(i, n, z=0.0):
    return math.cos(2 * math.pi * i / n), math.sin(2 * math.pi * i / n), z


def wavy(mesh):
    """A plain sheet."""
    mesh.grid(122, 122, lambda u, v: (u, v, 0.1 * math.sin(6 * u) * math.cos(5 * v)))


def fan(mesh):
    """Needles that meet in the middle of a disc."""
    n = 30000
    mesh.add([(0, 0, 0)] + [circle(i, n) for i in range(n)], [(0, 1 + i, 1 + (i + 1) % n) for i in range(n)])


def can(mesh):
    """A closed cylinder of needles."""
    n = 7500
    mesh.add([(0, 0, -1), (0, 0, 1)] + [circle(i, n, z) for i in range(n) for z in (-1, 1)], [])
    for i in range(n):
        a, b, c, d = 2 + 2 * i, 3 + 2 * i, 2 + 2 * ((i + 1) % n), 3 + 2 * ((i + 1) % n)
        mesh.faces += [(0, c, a), (1, b, d), (a, c, d), (a, d, b)]


def hair(mesh):
    """Loose strips a five-hundredth as wide as long."""
    for _ in range(15000):
        root = [random.uniform(-1, 1) for _ in range(3)]
        along = [random.gauss(0, 1) for _ in range(3)]
        scale = 0.5 / math.hypot(*along)
        tip = [r + scale * a for r, a in zip(root, along)]
        mesh.add([root, [root[0] + 0.001] + root[1:], tip, [tip[0] + 0.001] + tip[1:]], [(0, 1, 3), (0, 3, 2)])


def layers(mesh):
    """Fifteen sheets, each a ten-thousandth from the next."""
    for layer in range(15):
        mesh.grid(31, 32, lambda u, v: (u, v, 0.05 * u * v + 1e-4 * layer))


def onion(mesh):
    """Twelve shells, each a thousandth from the next."""
    for layer in range(12):
        r = 1 - 1e-3 * layer
        polar = lambda u: math.pi * (0.02 + 0.96 * u)
        mesh.grid(36, 34, lambda u, v: tuple(r * math.sin(polar(u)) * x for x in circle(v, 1)[:2]) + (r * math.cos(polar(u)),))


def grass(mesh):
    """Blades on a ground."""
    mesh.grid(30, 30, lambda u, v: (2 * u - 1, 2 * v - 1, 0))
    for _ in range(4700):
        x, y, turn, height = random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(0, 6.28), random.uniform(0.2, 0.5)
        ring = []
        for k in range(4):
            s = k / 3
            half = 0.004 * (1 - 0.9 * s)
            bend = 0.2 * height * s * s * math.sin(turn)
            ring += [(x + side * half * math.cos(turn) + bend, y + side * half * math.sin(turn), height * s) for side in (-1, 1)]
        mesh.add(ring, [f for k in range(0, 6, 2) for f in ((k, k + 1, k + 3), (k, k + 3, k + 2))])


def furniture(mesh):
    """Boxes without a bottom that cross, many of them thin."""
    for _ in range(250):
        centre = [random.uniform(-1, 1) for _ in range(3)]
        size = [random.choice([0.02, 0.02, 0.3, 0.8]) for _ in range(3)]
        for axis, side in ((0, -1), (0, 1), (1, -1), (1, 1), (2, 1)):
            def place(u, v):
                p = [0, 0, 0]
                p[axis], p[(axis + 1) % 3], p[(axis + 2) % 3] = side / 2, u - 0.5, v - 0.5
                return tuple(c + s * x for c, s, x in zip(centre, size, p))
            mesh.grid(3, 4, place)


def spring(mesh):
    """A closed coil of a thin tube."""
    def place(u, v):
        t = 24 * math.pi * u
        x, y, z = circle(v, 1)
        return (1 + 0.05 * x) * math.cos(t), (1 + 0.05 * x) * math.sin(t), 0.12 * t / math.pi + 0.05 * y
    mesh.grid(1500, 10, place)


def ribbon(mesh):
    """A coil of a narrow strip, whose rims take twenty times its triangles."""
    mesh.grid(15000, 1, lambda u, v: (*circle(30 * u, 1)[:2], 6 * u + 0.03 * v))


def soup(mesh):
    """Triangles of all sizes anywhere."""
    for _ in range(30000):
        centre, size = [random.uniform(-1, 1) for _ in range(3)], 10 ** random.uniform(-3, -0.3)
        mesh.add([tuple(random.gauss(c, size) for c in centre) for _ in range(3)], [(0, 1, 2)])


def bundle(mesh):
    """Closed needles side by side, a hundredth of their width apart."""
    for i in range(50):
        for j in range(50):
            x, y, w = 0.01 * i, 0.01 * j, 0.0099
            mesh.add([(x + w * (k & 1), y + w * (k >> 1 & 1), k >> 2) for k in range(8)],
                     [(0, 2, 3), (0, 3, 1), (4, 5, 7), (4, 7, 6), (0, 1, 5), (0, 5, 4), (2, 6, 7), (2, 7, 3), (0, 4, 6), (0, 6, 2),
                      (1, 3, 7), (1, 7, 5)])


def burr(mesh):
    """A closed ball of spikes."""
    def place(u, v):
        i, j = round(220 * u), round(68 * v)
        r = 1 if i % 2 and j % 2 else 0.2
        polar = math.pi * (0.02 + 0.96 * v)
        x, y, _ = circle(i % 220, 220)
        return r * math.sin(polar) * x, r * math.sin(polar) * y, r * math.cos(polar)
    mesh.grid(220, 68, place)


def crumpled(mesh):
    """A sheet crumpled into a ball."""
    waves = [([random.gauss(0, 4) for _ in range(2)], random.uniform(0, 6), [random.gauss(0, 0.15) for _ in range(3)]) for _ in range(40)]
    mesh.grid(122, 122, lambda u, v: tuple(sum(d[k] * math.sin(f[0] * u + f[1] * v + phase) for f, phase, d in waves) for k in range(3)))


def pleats(mesh):
    """A thin solid of pleats, as high as the solid, that fills the dense matrix."""
    n = 990
    ring = [(i / n, 0.05 * (i % 20 if i % 40 < 20 else 20 - i % 20) / 20) for i in range(n + 1)]
    outline = ring + [(x, y + 0.0005) for x, y in reversed(ring)]
    m = len(outline)
    mesh.add([(x, y, z) for x, y in outline for z in (0, 1)], [])
    for i in range(m):
        a, b = 2 * i, 2 * ((i + 1) % m)
        mesh.faces += [(a, b, b + 1), (a, b + 1, a + 1)]
    for i in range(n):
        a, b, c, d = i, i + 1, m - 2 - i, m - 1 - i
        mesh.faces += [(2 * a, 2 * c, 2 * b), (2 * a, 2 * d, 2 * c), (2 * a + 1, 2 * b + 1, 2 * c + 1), (2 * a + 1, 2 * c + 1, 2 * d + 1)]


def comb(mesh):
    """A closed plate with 1870 teeth: lines through its side meet them all."""
    n = 1870
    outline = [p for i in range(n) for p in ((i / n, 0), (i / n, 1), ((i + 0.5) / n, 1), ((i + 0.5) / n, 0))]
    outline += [(1, 0), (1, -0.1), (0, -0.1)]
    m = len(outline)
    mesh.add([(x, y, z) for x, y in outline for z in (0, 0.01)], [])
    for i in range(m):
        a, b = 2 * i, 2 * ((i + 1) % m)
        mesh.faces += [(a, b + 1, b), (a, a + 1, b + 1)]
    root = [k for i in range(n) for k in (4 * i, 4 * i + 3)] + [4 * n, m - 2]
    flat = [f for i in range(0, 4 * n, 4) for f in ((i, i + 2, i + 1), (i, i + 3, i + 2))]
    flat += [(m - 1, b, a) for a, b in zip(root, root[1:])]
    mesh.faces += [f for a, b, c in flat for f in ((2 * a, 2 * b, 2 * c), (2 * c + 1, 2 * b + 1, 2 * a + 1))]


def egg(mesh):
    """A smooth solid, whose hull has all its corners."""
    def place(u, v):
        polar, x = math.pi * v, circle(u, 1)
        r = (1 + 0.25 * math.cos(polar)) * (1 if 0 < v < 1 else 0)
        return r * math.sin(polar) * x[0], 0.7 * r * math.sin(polar) * x[1], (1 + 0.25 * math.cos(polar)) * math.cos(polar)
    mesh.grid(122, 123, place)


def bake(lr_bake, path):
    command = [lr_bake, "mesh", str(path), "-o", str(path.with_suffix(".lrb")), "--size", "50cm"]
    run = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    text = run.stderr.read()
    _, status, usage = os.wait4(run.pid, 0)
    run.returncode = os.waitstatus_to_exitcode(status)
    solved = next((line.split("surface of ")[1].split()[0] + " faces" for line in text.splitlines() if "coarser surface of " in line),
                  "one side" if "that of a sheet" in text else "convex hull" if "that of the convex hull" in text else "all")
    return usage.ru_utime + usage.ru_stime, usage.ru_maxrss // 1024, solved, run.returncode


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--bake", help="lr_bake")
    args = parser.parse_args()
    args.folder.mkdir(parents=True, exist_ok=True)
    good = True
    print("| mesh | triangles | s | MB | solved |\n|---|---|---|---|---|")
    for make in (wavy, fan, can, hair, layers, onion, grass, furniture, spring, ribbon, soup, bundle, burr, crumpled, pleats, comb, egg):
        random.seed(1)
        mesh = Mesh()
        make(mesh)
        path = args.folder / f"{make.__name__}.obj"
        mesh.write(path)
        if not args.bake:
            continue
        seconds, megabytes, solved, code = bake(args.bake, path)
        good = good and seconds <= SECONDS and megabytes <= MEGABYTES and code in {0, 1}
        print(f"| {make.__name__}: {make.__doc__.rstrip('.').lower()} | {len(mesh.faces)} | {seconds:.1f} | {megabytes} | {solved}"
              f"{'' if code == 0 else ', refused'} |", flush=True)
    sys.exit(0 if good else 1)


if __name__ == "__main__":
    main()
