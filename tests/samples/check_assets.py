#!/usr/bin/env python3
"""Checks the meshes in assets: that the script still makes these bytes, and, read anew from the files, that they
are closed, outward-wound and of the right volume, or open and of the right area.    usage: check_assets.py ROOT        SPDX-License-Identifier: MIT"""
import collections
import filecmp
import math
import os
import subprocess
import sys
import tempfile

EXPECTED = {  # mm^3: closed forms if they exist, else the size of the sheet
    "confetti.obj": (7.2, 1e-6), "paper.obj": (777.0, 1e-6), "ellipsoid_leaf.obj": (4.0 / 3.0 * math.pi * 40 * 10 * 0.05, 0.01),
    # Triangles inscribed in the surface miss 0.8 %; a quarter as many, 3.1 %.
    "ellipsoid_rubber.obj": (4.0 / 3.0 * math.pi * 40 * 20 * 10, 0.01),
    "ellipsoid_rubber_coarse.obj": (4.0 / 3.0 * math.pi * 40 * 20 * 10 * 0.969, 0.005),
    "leaf.obj": (515.0, 0.05), "leaf_maple.obj": (460.0, 0.05), "paper_plane.obj": (518.0, 0.05), "petal.obj": (11.8, 0.05),
    "curled_leaf.obj": (601.0, 0.05), "samara.obj": (139.6, 0.05),  # 232 mg of 1662 kg/m^3
    "dart.obj": (200.0 * (52.5 + 12.5) * 0.3, 0.35),  # its thickness falls to zero at the rims
}
OPEN = {  # mm^2
    "paper_plane_surface.obj": (2450.7, 1e-3), "paper_plane_layers.obj": (83.0 * 83.0, 1e-5),  # folds keep the area
    "paper_plane_uneven_surface.obj": (2512.0, 1e-3), "paper_plane_uneven_layers.obj": (83.0 * 83.0, 1e-5),
}


def read(path):
    points, faces = [], []
    with open(path, encoding="ascii") as file:
        lines = file.read().split("\n")
    assert lines[0].startswith("#"), "no header"
    for line in lines:
        words = line.split()
        if words[:1] == ["v"]:
            points.append(tuple(1e3 * float(x) for x in words[1:]))
        elif words[:1] == ["f"]:
            faces.append(tuple(int(w.split("/")[0]) - 1 for w in words[1:]))
    return points, faces


def check_shape(points, even=True):
    size = [max(p[i] for p in points) - min(p[i] for p in points) for i in range(3)]
    assert size[0] >= size[1] >= size[2], "axes"
    mirrored = {(x, -y, z) for x, y, z in points}
    assert (mirrored == set(points)) == even, "not the same left and right"


def check_open(path, expected, tolerance):
    points, faces = read(path)
    area = 0.0
    for a, b, c in ((points[i] for i in f) for f in faces):
        u, v = ([q[i] - a[i] for i in range(3)] for q in (b, c))
        area += 0.5 * math.hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
    assert abs(area / expected - 1.0) <= tolerance, f"area {area} mm^2"
    check_shape(points, "uneven" not in path)


def check(path, expected, tolerance):
    points, faces = read(path)
    edges = collections.Counter((f[i], f[(i + 1) % 3]) for f in faces for i in range(3))
    assert all(n == 1 and edges[b, a] == 1 for (a, b), n in list(edges.items())), "not closed"
    volume = sum(a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0])
                 for a, b, c in ((points[i] for i in f) for f in faces)) / 6.0
    assert abs(volume / expected - 1.0) <= tolerance, f"volume {volume} mm^3"
    check_shape(points, not os.path.basename(path).startswith(("curled", "samara")))


def main(root):
    folder = os.path.join(root, "assets")
    assert sorted(n for n in os.listdir(folder) if n.endswith(".obj")) == sorted({**EXPECTED, **OPEN}), "other files than expected"
    with tempfile.TemporaryDirectory() as fresh:
        subprocess.run([sys.executable, os.path.join(root, "assets", "make_assets.py"), fresh], check=True,
                       stdout=subprocess.DEVNULL)
        for name, (size, tolerance) in {**EXPECTED, **OPEN}.items():
            assert filecmp.cmp(os.path.join(folder, name), os.path.join(fresh, name), shallow=False), f"{name} differs"
            try:
                (check_open if name in OPEN else check)(os.path.join(folder, name), size, tolerance)
            except AssertionError as error:
                sys.exit(f"{name}: {error}")
    print(f"{len(EXPECTED) + len(OPEN)} meshes are right")


if __name__ == "__main__":
    main(sys.argv[1])
