#!/usr/bin/env python3
"""Makes the source meshes of this folder: triangle meshes in metres, closed and wound outward but for two, as Wavefront OBJ.

    python3 make_assets.py [OUTDIR]        OUTDIR: initially the folder of this script

Only the standard library; the same bytes every time. Every closed mesh is checked before it is written: each edge has exactly
two faces that run through it in opposite directions, the volume is positive, no triangle is degenerate, the surface is
one piece. A mesh that fails is not written and the exit code is 1.

All bodies lie with their long axis along x and their thin direction along z, centred near the origin. Sheets are made
of "pages" (top and bottom of a leaf; top, left and right of a paper plane) that share the vertices of their rims: the
thickness falls to zero there, which spares the baker a rim of slivers.

SPDX-License-Identifier: MIT
"""
import math
import os
import sys

from mesh import Mesh, add, scaled, smoothstep, unit
from paper_planes import dart, paper_plane, paper_plane_layers, paper_plane_surface


# --------------------------------------------------------------------------------------------------------------------
# A sheet over the unit disc: rings of 6, 12, 18... points, so that the middle line (the midrib) is made of edges and
# left and right are mirror images.

def disc(rings):
    """Points (r, turn 0..1) and counter-clockwise triangles."""
    points, start = [(0.0, 0.0)], [0]
    for k in range(1, rings + 1):
        start.append(len(points))
        points += [(k / rings, j / (6 * k)) for j in range(6 * k)]
    triangles = []
    for k in range(1, rings + 1):
        for sector in range(6):
            inner = [start[k - 1] + (sector * (k - 1) + j) % max(1, 6 * (k - 1)) for j in range(k)]
            outer = [start[k] + (sector * k + j) % (6 * k) for j in range(k + 1)]
            triangles += [(inner[j], outer[j], outer[j + 1]) for j in range(k)]
            triangles += [(inner[j], outer[j + 1], inner[j + 1]) for j in range(k - 1)]
    return points, triangles


def sheet(name, text, rings, outline, lift, thickness, taper):
    """Thickens the surface z = lift(x, y) over `outline`, which maps the disc (r, turn) to the plane.

    thickness: m, in the middle; it falls to zero at the rim over the outer fraction `taper` of the radius.
    """
    mesh = Mesh(name, text)
    parameters, triangles = disc(rings)
    flat = relax(outline(parameters), triangles, [r == 1.0 for r, _ in parameters])
    low_x, size = min(x for x, _ in flat), max(x for x, _ in flat) - min(x for x, _ in flat)
    top, bottom = [], []
    for (r, _), (x, y) in zip(parameters, flat):
        h = 1e-6
        slope_x = (lift(x + h, y) - lift(x - h, y)) / (2.0 * h)
        slope_y = (lift(x, y + h) - lift(x, y - h)) / (2.0 * h)
        normal = unit((-slope_x, -slope_y, 1.0))
        half = 0.5 * thickness * math.sqrt(max(0.0, 1.0 - max(0.0, (r - 1.0 + taper) / taper) ** 2))
        middle, uv = (x, y, lift(x, y)), ((x - low_x) / size, 0.5 + y / size)
        top.append(mesh.add(add(middle, scaled(normal, half)), uv))
        bottom.append(top[-1] if r == 1.0 else mesh.add(add(middle, scaled(normal, -half)), uv))
    mesh.faces += [(top[a], top[b], top[c]) for a, b, c in triangles]
    mesh.faces += [(bottom[a], bottom[c], bottom[b]) for a, b, c in triangles]
    mesh.centre()
    return mesh


def relax(points, triangles, fixed, rounds=30):
    """Evens out the triangles of a plane mesh: an inner point goes towards the mean of its neighbours, unless that
    makes the worst triangle around it worse (a plain mean would fold the mesh over in the bays of a lobed leaf)."""
    around = [[] for _ in points]
    for t in triangles:
        for i in t:
            around[i].append(t)

    def worst(i, at):
        least = math.inf
        for t in around[i]:
            (ax, ay), (bx, by), (cx, cy) = (at if j == i else points[j] for j in t)
            area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
            least = min(least, area / ((bx - ax) ** 2 + (by - ay) ** 2 + (cx - bx) ** 2 + (cy - by) ** 2
                                       + (ax - cx) ** 2 + (ay - cy) ** 2))
        return least

    points = list(points)
    mirrored = {(round(x, 9), round(y, 9)): i for i, (x, y) in enumerate(points)}
    twin = [mirrored.get((round(x, 9), round(-y, 9)), i) for i, (x, y) in enumerate(points)]
    for _ in range(rounds):
        for i, p in enumerate(points):
            if fixed[i] or p[1] < -1e-12:
                continue
            ring = sorted({j for t in around[i] for j in t if j != i})
            mean = tuple(sum(points[j][k] for j in ring) / len(ring) for k in range(2))
            at = (0.5 * (p[0] + mean[0]), 0.5 * (p[1] + mean[1]) if twin[i] != i else 0.0)
            reach = 0.3 * min(math.dist(p, points[j]) for j in ring)
            tries = [at] + [(p[0] + reach * math.cos(k), p[1] + (reach * math.sin(k) if twin[i] != i else 0.0))
                            for k in range(7)]
            best = max(tries, key=lambda q: worst(i, q))
            if worst(i, best) >= worst(i, p):
                points[i] = best
                points[twin[i]] = (best[0], -best[1]) if twin[i] != i else best
    if min(worst(i, p) for i, p in enumerate(points)) <= 0.0:
        raise ValueError("the outline folds the mesh over")
    return points


def by_width(half_length, width):
    """Outline of a blade: width(s) turns the ellipse of s = x / half_length into another shape."""
    def outline(parameters):
        points = []
        for r, turn in parameters:
            s, t = r * math.cos(2.0 * math.pi * turn), r * math.sin(2.0 * math.pi * turn)
            points.append((half_length * s, width(s) * (0.0 if abs(t) < 1e-12 else t)))
        return points
    return outline


def by_radius(corners, count_of_rim):
    """Outline through polar corners (degrees, m), given for one side and mirrored. Rim points lie evenly on it."""
    line = [(d * math.cos(math.radians(a)), d * math.sin(math.radians(a))) for a, d in corners]
    line = line + [(x, -y) for x, y in reversed(line[1:-1])]
    sides = [math.dist(line[i], line[(i + 1) % len(line)]) for i in range(len(line))]
    # Each corner is kept as a rim point: a side gets points by its length, at least one.
    half = sides[:len(sides) // 2]
    counts = [1] * len(half)
    while sum(counts) < count_of_rim // 2:
        counts[max(range(len(half)), key=lambda i: half[i] / counts[i])] += 1
    counts = counts + counts[::-1]
    rim = []
    for i, count in enumerate(counts):
        (ax, ay), (bx, by) = line[i], line[(i + 1) % len(line)]
        rim += [(ax + (bx - ax) * j / count, ay + (by - ay) * j / count) for j in range(count)]

    def outline(parameters):
        points = []
        for r, turn in parameters:
            at = turn * len(rim)
            i, f = int(at) % len(rim), at - int(at)
            (ax, ay), (bx, by) = rim[i], rim[(i + 1) % len(rim)]
            # Towards the middle the lobes give way to a circle, or the rings would cut through one another.
            w, core = r ** 3, min(math.hypot(x, y) for x, y in rim)
            x, y = core * math.cos(2.0 * math.pi * turn), core * math.sin(2.0 * math.pi * turn)
            points.append((r * (x + w * (ax + (bx - ax) * f - x)), r * (y + w * (ay + (by - ay) * f - y))))
        return points
    return outline


def leaf():
    def width(s):  # widest behind the middle, drawn out to a point at the tip
        return 0.0197 * (1.0 - 0.20 * s - 0.16 * s * s) * math.sqrt(max(0.0, 1.0 - 0.80 * smoothstep(0.25, 1.05, s)))

    def lift(x, y):
        fold = math.sqrt(y * y + 0.0008 ** 2) - 0.0008
        return -3.6 * x * x - 18.0 * x ** 3 + 0.24 * fold
    return sheet("leaf", "broad ovate leaf, 7 cm x 4 cm, 0.3 mm, bent along the midrib, folded across it",
                 10, by_width(0.035, width), lift, 0.0003, 0.35)


def leaf_maple():
    corners = [(0, 0.042), (6, 0.033), (11, 0.0335), (13, 0.026), (24, 0.0175), (34, 0.028), (37, 0.034), (48, 0.0375),
               (52, 0.031), (60, 0.030), (64, 0.024), (84, 0.0165), (97, 0.023), (103, 0.0285), (111, 0.0305),
               (120, 0.026), (140, 0.0215), (162, 0.0185), (180, 0.0125)]

    def lift(x, y):
        return -4.0 * (x * x + y * y) + 0.0012 * math.cos(6.0 * math.atan2(y, x)) * smoothstep(0.0, 0.02, math.hypot(x, y))
    return sheet("leaf_maple", "lobed leaf, 5.5 cm x 6 cm, 0.3 mm, slightly domed", 12, by_radius(corners, 72), lift,
                 0.0003, 0.3)


def petal():
    def width(s):
        return 0.0052 * (1.0 + 0.22 * s)

    def outline(parameters):
        points = by_width(0.006, width)(parameters)
        # The notch at the tip of a cherry petal.
        return [(x - 0.0012 * smoothstep(0.0, 0.006, x) * math.exp(-(y / 0.0011) ** 2), y) for x, y in points]

    def lift(x, y):
        return 38.0 * (y * y + 0.6 * x * x) + 0.0006 * smoothstep(0.002, 0.006, x)
    return sheet("petal", "cupped cherry petal, 1.2 cm, 0.15 mm", 8, outline, lift, 0.00015, 0.35)


def curled_leaf():
    def width(s):
        return 0.0200 * (1.0 - 0.10 * s) * math.sqrt(max(0.0, 1.0 - 0.5 * smoothstep(0.3, 1.05, abs(s))))

    def lift(x, y):  # curled along the midrib, and twisted
        return 6.0 * y * y + 6.0 * x * y
    return sheet("curled_leaf", "leaf, 8 cm x 4 cm, 0.3 mm, curled along its midrib and twisted", 10, by_width(0.040, width),
                 lift, 0.0003, 0.35)


def samara():
    """Winged seed of a maple: an ellipsoid of 8 x 6 x 4 mm and a wing with a rib along its leading edge, two pages of rows.

    x from the nut to the tip, y from the leading to the trailing edge. The tip is 4.47 cm from the centre of mass, the mean
    chord 1.15 cm; the nut has 72 % of the mass, the rib half of the rest.
    """
    rows, columns = 36, 12
    length_, width, thickness, root, tip, area = 0.008, 0.006, 0.004, 0.0028, 0.0517, 0.0447 * 0.0115
    wing = math.pi / 6.0 * length_ * width * thickness * 0.28 / 0.72
    membrane, rib = 0.5 * wing / area, 0.5 * wing / (0.11 * area)

    def planform(part):
        before = 0.45 + 0.55 * math.sin(0.5 * math.pi * min(part / 0.62, 1.0))
        return before * math.sqrt(max(0.0, 1.0 - (max(0.0, part - 0.62) / 0.38) ** 2.2))
    widest = area / ((tip - root) * sum(planform((i + 0.5) / 400) for i in range(400)) / 400)
    nut_y = 0.31 * widest

    def spaced(i, n):
        return 0.5 - 0.5 * math.cos(math.pi * i / n)

    def part_of(x):
        return min(1.0, max(0.0, (x - root) / (tip - root)))

    def edges(x):
        end, blade = 2.0 * x / length_, smoothstep(0.0, root, x)
        half = 0.5 * width * math.sqrt(max(0.0, 1.0 - end * end))
        back = nut_y + half if abs(end) < 1.0 else 0.0
        return (nut_y - half) * (1.0 - blade), max(back, widest * planform(part_of(x)) * blade)

    def half_thickness(x, y, across):
        nut = thickness * math.sqrt(max(0.0, 1.0 - (2.0 * x / length_) ** 2 - (2.0 * (y - nut_y) / width) ** 2))
        ribbed = rib * (1.5 - part_of(x)) * (1.0 - smoothstep(0.06, 0.16, across))
        return 0.5 * max(nut, membrane + ribbed)
    mesh = Mesh("samara", "winged seed of a maple, 5.6 cm: a nut and a wing of 0.04 mm with a rib")
    low = -0.5 * length_
    pages = []
    for i in range(rows + 1):
        x = low + (tip - low) * spaced(i, rows)
        front, back = edges(x)
        line = []
        for j in range(columns + 1) if 0 < i < rows else [columns // 2]:
            across = spaced(j, columns)
            y = front + (back - front) * across if i else nut_y
            half = half_thickness(x, y, across) if 0 < i < rows and 0 < j < columns else 0.0
            uv = ((x - low) / (tip - low), 0.5 + (y - 0.5 * widest) / (tip - low))
            upper = mesh.add((x, y, half), uv)
            line.append((upper, mesh.add((x, y, -half), uv) if half else upper))
        pages.append(line)
    for a, b in zip(pages, pages[1:]):
        for j in range(columns):
            for page in (0, 1):
                corners = [line[min(k, len(line) - 1)][page] for line, k in ((a, j), (b, j), (b, j + 1), (a, j + 1))]
                for t in ((corners[0], corners[1], corners[3]), (corners[1], corners[2], corners[3])):
                    if len(set(t)) == 3:
                        mesh.faces.append(t if page == 0 else (t[0], t[2], t[1]))
    mesh.centre()
    return mesh


# --------------------------------------------------------------------------------------------------------------------

def rectangle(name, text, cells, size):
    """A cuboid with a grid on its large faces. The diagonals are mirrored, so that the mesh has all three planes."""
    mesh = Mesh(name, text)
    (nx, ny), (sx, sy, sz) = cells, size
    grid = {}
    for k in (0, 1):
        for i in range(nx + 1):
            for j in range(ny + 1):
                grid[i, j, k] = mesh.add(((i / nx - 0.5) * sx, (j / ny - 0.5) * sy, (k - 0.5) * sz),
                                         (i / nx, 0.5 + (j / ny - 0.5) * sy / sx))

    def quad(a, b, c, d, other):
        mesh.faces.extend([(a, b, d), (b, c, d)] if other else [(a, b, c), (a, c, d)])
    for i in range(nx):
        for j in range(ny):
            other = (2 * i < nx) != (2 * j < ny)
            a, b, c, d = ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1))
            quad(grid[a + (1,)], grid[b + (1,)], grid[c + (1,)], grid[d + (1,)], other)
            quad(grid[a + (0,)], grid[d + (0,)], grid[c + (0,)], grid[b + (0,)], other)
    ring = [(i, 0) for i in range(nx)] + [(nx, j) for j in range(ny)]
    ring += [(nx - i, ny) for i in range(nx)] + [(0, ny - j) for j in range(ny)]
    for n, a in enumerate(ring):
        b = ring[(n + 1) % len(ring)]
        quad(grid[a + (0,)], grid[b + (0,)], grid[b + (1,)], grid[a + (1,)], n % 2 == 0)
    return mesh


def ellipsoid(name, text, axes, subdivisions):
    g = (1.0 + math.sqrt(5.0)) / 2.0
    points = [unit(p) for p in ((-1, g, 0), (1, g, 0), (-1, -g, 0), (1, -g, 0), (0, -1, g), (0, 1, g), (0, -1, -g),
                                (0, 1, -g), (g, 0, -1), (g, 0, 1), (-g, 0, -1), (-g, 0, 1))]
    faces = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4), (11, 10, 2), (10, 7, 6),
             (7, 1, 8), (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8), (3, 8, 9), (4, 9, 5), (2, 4, 11), (6, 2, 10),
             (8, 6, 7), (9, 8, 1)]
    for _ in range(subdivisions):
        middle, finer = {}, []

        def between(a, b):
            key = (min(a, b), max(a, b))
            if key not in middle:
                points.append(unit(scaled(add(points[a], points[b]), 0.5)))
                middle[key] = len(points) - 1
            return middle[key]
        for a, b, c in faces:
            ab, bc, ca = between(a, b), between(b, c), between(c, a)
            finer += [(a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca)]
        faces = finer
    mesh = Mesh(name, text)
    for p in points:
        x, y, z = (p[i] * axes[i] for i in range(3))
        mesh.add((x, y, z), (0.5 + 0.5 * p[0], 0.5 + 0.5 * y / axes[0]))
    mesh.faces = faces
    return mesh


def main(arguments):
    if len(arguments) > 2 or (len(arguments) == 2 and arguments[1].startswith("-")):
        print(__doc__)
        return 0 if arguments[1:] in (["-h"], ["--help"]) else 1
    folder = arguments[1] if len(arguments) == 2 else os.path.dirname(os.path.abspath(__file__))
    os.makedirs(folder, exist_ok=True)
    failed = False
    for make in (leaf, leaf_maple, curled_leaf, samara, dart, paper_plane, paper_plane_surface, paper_plane_layers, lambda: paper_plane_surface(1.0),
                 lambda: paper_plane_layers(1.0), petal,
                 lambda: rectangle("confetti", "rectangle of paper, 12 mm x 6 mm, 0.1 mm", (20, 10), (0.012, 0.006, 0.0001)),
                 lambda: rectangle("paper", "sheet of paper, 105 mm x 74 mm (A7), 0.1 mm", (14, 10), (0.105, 0.074, 0.0001)),
                 lambda: ellipsoid(
            "ellipsoid_leaf", "the leaf of the paper: semi-axes 4 cm and 1 cm, 0.01 cm thick", (0.04, 0.01, 5e-5), 3),
            lambda: ellipsoid("ellipsoid_rubber", "the rubber ellipsoid of the paper: semi-axes 4, 2 and 1 cm",
                              (0.04, 0.02, 0.01), 3),
            lambda: ellipsoid("ellipsoid_rubber_coarse", "the same with a quarter of the triangles",
                              (0.04, 0.02, 0.01), 2)):
        mesh = make()
        mesh.points = [tuple(round(x, 8) + 0.0 for x in p) for p in mesh.points]
        faults = mesh.faults()
        for fault in faults:
            print(f"{mesh.name}: {fault}", file=sys.stderr)
        if faults:
            failed = True
            continue
        mesh.write(os.path.join(folder, mesh.name + ".obj"))
        size = [max(p[i] for p in mesh.points) - min(p[i] for p in mesh.points) for i in range(3)]
        print(f"{mesh.name + '.obj':20s} {len(mesh.faces):5d} triangles  " + " x ".join(f"{1e3 * s:.2f}" for s in size)
              + (f" mm  {mesh.area() * 1e6:9.3f} mm^2  smallest" if mesh.open else f" mm  {mesh.volume() * 1e9:9.3f} mm^3  smallest")
              + f" angle {mesh.smallest_angle():.1f} degrees")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv))
