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


class Mesh:
    def __init__(self, name, text):
        self.name, self.text, self.open = name, text, False
        self.points, self.uvs, self.faces = [], [], []

    def add(self, point, uv):
        self.points.append(point)
        self.uvs.append(uv)
        return len(self.points) - 1

    def centre(self):
        """Moves the centre of the volume to the origin."""
        six_volume, sums = 0.0, [0.0, 0.0, 0.0]
        for a, b, c in self.corners():
            d = dot(a, cross(b, c))
            six_volume += d
            for i in range(3):
                sums[i] += d * (a[i] + b[i] + c[i]) / 4.0
        shift = [s / six_volume for s in sums]
        self.points = [tuple(p[i] - shift[i] for i in range(3)) for p in self.points]

    def corners(self):
        for face in self.faces:
            yield tuple(self.points[i] for i in face)

    def volume(self):
        return sum(dot(a, cross(b, c)) for a, b, c in self.corners()) / 6.0

    def area(self):
        return sum(length(cross(sub(b, a), sub(c, a))) for a, b, c in self.corners()) / 2.0

    def smallest_angle(self):
        return min(min(angles(*t)) for t in self.corners())

    def faults(self):
        found, edges, parent = [], {}, list(range(len(self.points)))
        if self.open:
            return [f"triangle {i + 1} is degenerate" for i, t in enumerate(self.corners()) if min(angles(*t)) < 1e-3]
        for f in self.faces:
            for k in range(3):
                edge = (f[k], f[(k + 1) % 3])
                edges[edge] = edges.get(edge, 0) + 1
                a, b = root(parent, edge[0]), root(parent, edge[1])
                parent[a] = b
        for (a, b), times in edges.items():
            if times != 1 or edges.get((b, a), 0) != 1:
                found.append(f"edge {a + 1}-{b + 1} is not shared by two opposite faces")
        if len({root(parent, i) for i in range(len(self.points))}) != 1:
            found.append("the surface is not one piece, or has unused vertices")
        if len(self.points) - len(edges) // 2 + len(self.faces) != 2:
            found.append("the surface is not a sphere in the topological sense")
        if len(set(self.points)) != len(self.points):
            found.append("two vertices have the same place")
        if not self.volume() > 0.0:
            found.append("the volume is not positive: wound inside out")
        size = max(abs(x) for p in self.points for x in p)
        for i, (a, b, c) in enumerate(self.corners()):
            if length(cross(sub(b, a), sub(c, a))) < 1e-9 * size * size:
                found.append(f"triangle {i + 1} is degenerate")
        return found

    def write(self, path):
        kind = "open" if self.open else "closed, wound outward"
        size = f"area {self.area() * 1e6:.2f} mm^2" if self.open else f"volume {self.volume() * 1e9:.4f} mm^3"
        lines = [f"# {self.name}: {self.text}", f"# metres; x: long axis, z: thin direction; {kind}",
                 f"# {len(self.points)} vertices, {len(self.faces)} triangles, {size}",
                 "# made by make_assets.py of Langevin Rigid; SPDX-License-Identifier: MIT", f"o {self.name}"]
        # 10 nm: exact enough for a sheet of 0.1 mm, and short enough to read.
        lines += ["v " + " ".join(f"{round(x, 8) + 0.0:.8f}" for x in p) for p in self.points]
        lines += [f"vt {u:.5f} {v:.5f}" for u, v in self.uvs]
        lines += ["f " + " ".join(f"{i + 1}/{i + 1}" for i in f) for f in self.faces]
        part = path + ".part"
        with open(part, "w", encoding="ascii", newline="\n") as file:
            file.write("\n".join(lines) + "\n")
        os.replace(part, path)


def sub(a, b): return tuple(x - y for x, y in zip(a, b))
def add(a, b): return tuple(x + y for x, y in zip(a, b))
def scaled(a, s): return tuple(x * s for x in a)
def dot(a, b): return sum(x * y for x, y in zip(a, b))
def cross(a, b): return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])
def length(a): return math.sqrt(dot(a, a))
def unit(a): return scaled(a, 1.0 / length(a))


def root(parent, i):
    while parent[i] != i:
        parent[i] = parent[parent[i]]
        i = parent[i]
    return i


def angles(a, b, c):
    sides = [sub(b, a), sub(c, b), sub(a, c)]
    for k in range(3):
        u, v = sides[k], scaled(sides[k - 1], -1.0)
        yield math.degrees(math.atan2(length(cross(u, v)), dot(u, v)))


def smoothstep(low, high, x):
    x = min(1.0, max(0.0, (x - low) / (high - low)))
    return x * x * (3.0 - 2.0 * x)


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


# The dart: a square folded in half along x, its front corners folded to the middle (45 degrees from the middle line), the
# edges so made folded there again (22.5 degrees), and the wings folded out from the keel (7.5 degrees). All folds pass the
# nose. Measures in m, from the nose along the crease of the wings.
square, edge_fold, wing_fold = 0.083, math.radians(22.5), math.radians(7.5)
dart_root, dart_lean = square / math.cos(wing_fold), math.tan(wing_fold)
dart_span = square / math.cos(edge_fold) * math.sin(edge_fold - wing_fold)
dart_keel = square * math.sin(wing_fold)
dart_rise = math.atan(0.10)  # dihedral
# About the centroid of the surface: each of the triangles has one corner at the nose and one at the end of the crease.
_wings, _keel = 2.0 * dart_span, dart_keel
dart_centre = (2.0 / 3.0 * dart_root + dart_lean * (_wings * dart_span - _keel * dart_keel) / (_wings + _keel) / 3.0,
               (_wings * dart_span * math.sin(dart_rise) - _keel * dart_keel) / (_wings + _keel) / 3.0)


def dart_place(along, sideways, down):
    """A point of the wings (along the crease, off it, 0) or the keel (along, 0, below it), in the frame of the meshes."""
    return (dart_centre[0] - along, sideways * math.cos(dart_rise),
            abs(sideways) * math.sin(dart_rise) - down - dart_centre[1])


def folds(uneven):
    """Degrees by which the second fold goes farther on the left than on the right; the sides with their angles."""
    return (1.0, edge_fold + math.radians(uneven)), (-1.0, edge_fold)


def dart_mesh(what, text, uneven):
    name = "paper_plane_uneven_" if uneven else "paper_plane_"
    mesh = Mesh(name + what, "dart folded from a square sheet of 8.3 cm" + (", a degree unevenly" if uneven else "") + text)
    mesh.open = True
    return mesh


def paper_plane_surface(uneven=0.0):
    """Wings and keel. Behind the tail of either wing the flap that the second fold turned inwards stands out: its edge runs
    from the crease of the first fold to the corner of the square, parallel to the middle line before that fold."""
    mesh = dart_mesh("surface", ", as a surface", uneven)

    def add(along, off, down=0.0):
        return mesh.add(dart_place(along, off, down), (along / square, 0.5 + (off + down) / square))
    nose, tail = add(0.0, 0.0), add(dart_root, 0.0)
    for hand, fold in folds(uneven):
        corner = turned((square, -0.5 * square), 2.0 * fold)
        way = turned((1.0, 0.0), 2.0 * fold)
        inner = tuple(c - w * (corner[0] - square) / way[0] for c, w in zip(corner, way))
        inner, behind, tip = (add(along, hand * off) for along, off in (
            turned(p, -wing_fold) for p in (inner, corner, (square, square * math.tan(fold)))))
        mesh.faces += [(nose, tail, inner), (nose, inner, tip), (inner, behind, tip)]
    mesh.faces.append((nose, add(dart_root - dart_lean * dart_keel, 0.0, dart_keel), tail))
    return mesh


def split(polygon, angle):
    """Parts of a convex polygon below and above the line through the origin at this angle."""
    def side(p):
        return p[1] * math.cos(angle) - p[0] * math.sin(angle)
    below, above = [], []
    for p, q in zip(polygon, polygon[1:] + polygon[:1]):
        sp, sq = side(p), side(q)
        if sp <= 1e-12:
            below.append(p)
        if sp >= -1e-12:
            above.append(p)
        if min(sp, sq) < -1e-12 and max(sp, sq) > 1e-12:
            cut = tuple(a + (b - a) * sp / (sp - sq) for a, b in zip(p, q))
            below.append(cut)
            above.append(cut)
    return tuple(part if len(part) > 2 and abs(area_of(part)) > 1e-10 else None for part in (below, above))


def area_of(polygon):
    return 0.5 * sum(p[0] * q[1] - q[0] * p[1] for p, q in zip(polygon, polygon[1:] + polygon[:1]))


def turned(p, angle):
    c, s = math.cos(angle), math.sin(angle)
    return (c * p[0] - s * p[1], s * p[0] + c * p[1])


def paper_plane_layers(uneven=0.0):
    """Every layer of the paper where the folds put it: the half of the square on one side of the middle line, and the other."""
    mesh = dart_mesh("layers", ": all layers of the paper, of which several lie at one place", uneven)
    known = {}  # corners at one place are one, whichever layer has them

    def corner(place, uv):
        key = tuple(round(x, 8) for x in place)
        if key not in known:
            known[key] = mesh.add(place, uv)
        return known[key]

    for hand, second in folds(uneven):
        pieces = [[(0.0, 0.0), (square, 0.0), (square, 0.5 * square), (0.0, 0.5 * square)]]
        for fold in (math.radians(45.0), second):
            folded = []
            for piece in pieces:
                below, above = split(piece, fold)
                if below:
                    folded.append(below)
                if above:
                    folded.append([turned((x, -y), 2.0 * fold) for x, y in above][::-1])
            pieces = folded
        for piece in pieces:
            for part, is_wing in zip(split(piece, wing_fold), (False, True)):
                if not part:
                    continue
                line = []
                for p in part:
                    along, off = turned(p, -wing_fold)
                    place = dart_place(along, hand * off, 0.0) if is_wing else dart_place(along, 0.0, -off)
                    line.append(corner(place, (along / square, 0.5 + (hand * off if is_wing else -off) / square)))
                mesh.faces += [(line[0], line[i], line[i + 1]) for i in range(1, len(line) - 1)]
    return mesh


def solid_dart(mesh, rows, reach, span, keel, lean, put):
    """A dart as a solid of 0.3 mm: three pages that meet along their rims. A page is a triangle of rows from the nose to the
    tail. put(along, sideways, down): the place of a point.
    """
    half = 0.00015

    def parts(row, width):
        return max(1, math.ceil(width / reach * row - 1e-9))

    def inside(row, f):
        """0 on the rim, 1 inside: how much of the thickness there is. f: 0 at the root, 1 at the outer edge."""
        edge = min(1.0, (1.0 - f) * parts(row, span) / 1.5)
        return min(edge, (rows - row) / 1.5, 1.0)

    def place(row, sideways, down):
        return put(lean[0] * row / rows + lean[1] * (abs(sideways) - down), sideways, down)

    cache = {}

    def vertex(kind, row, i, n, page):
        """kind: wing of +y, wing of -y, keel; page: top, right, left."""
        f, t = i / n, row / rows
        rim = row in (0, rows) or i == n
        key = ("nose",) if row == 0 else (("root", row, page) if i == 0 else (kind, row, i, None if rim else page))
        if i == 0 and row == rows:
            key = ("tail",)
        if key in cache:
            return cache[key]
        if kind == "keel":
            base = place(row, 0.0, keel * t * f)
            offset = (0.0, {"right": half, "left": -half}.get(page, 0.0), 0.0)
        else:
            base = place(row, (span if kind == "+y" else -span) * t * f, 0.0)
            offset = (0.0, 0.0, half if page == "top" else -half)
        if i == 0:
            offset = {"top": (0.0, 0.0, half), "right": (0.0, half, -half), "left": (0.0, -half, -half)}[page]
        thick = 0.0 if rim else inside(row, f)
        u = t
        v = 0.5 + (keel * t * f if kind == "keel" else base[1]) / reach
        cache[key] = mesh.add(add(base, scaled(offset, thick)), (u, v))
        return cache[key]

    def page(strips, name, flip):
        """strips: (kind, width), from one rim over the root to the other."""
        def row_of(row):
            line = []
            for side, (kind, width) in enumerate(strips):
                n = parts(row, width)
                order = range(n, -1, -1) if side == 0 else range(1, n + 1)
                line += [(vertex(kind, row, i, n, name), (-i if side == 0 else i) / n) for i in order]
            return line
        for row in range(rows):
            a = [(vertex("keel", 0, 0, 1, name), 0.0)] if row == 0 else row_of(row)
            b = row_of(row + 1)
            i = j = 0
            while i + 1 < len(a) or j + 1 < len(b):
                step_b = i + 1 >= len(a) or (j + 1 < len(b) and better(b[j + 1], a[i], a[i + 1], b[j]))
                if row + 1 == rows and j + 1 < len(b) and i + 1 < len(a):
                    # In the corners of the tail an edge from rim to rim would be in two pages.
                    step_b = i > 0 and (i + 2 == len(a) or step_b)
                t = (a[i][0], b[j][0], b[j + 1][0]) if step_b else (a[i][0], b[j][0], a[i + 1][0])
                i, j = (i, j + 1) if step_b else (i + 1, j)
                mesh.faces.append((t[0], t[2], t[1]) if flip else t)

    def better(b_next, a_here, a_next, b_here):
        """The shorter of the two diagonals; the one that keeps to its own side of the root when they tie."""
        to_b = length(sub(mesh.points[b_next[0]], mesh.points[a_here[0]]))
        to_a = length(sub(mesh.points[a_next[0]], mesh.points[b_here[0]]))
        return to_b < to_a - 1e-9 or (abs(to_b - to_a) <= 1e-9 and b_here[1] < 0.0)

    page([("-y", span), ("+y", span)], "top", True)
    page([("keel", keel), ("+y", span)], "right", False)
    page([("keel", keel), ("-y", span)], "left", True)
    if mesh.volume() < 0.0:
        mesh.faces = [(a, c, b) for a, b, c in mesh.faces]
    return mesh


def paper_plane():
    """The dart to be drawn, without the ends of the flaps behind its tail; 0.3 mm is about the mean of the layers."""
    return solid_dart(Mesh("paper_plane", "dart folded from a square sheet of 8.3 cm, as one sheet of 0.3 mm"), 22, square,
                      dart_span, dart_keel, (dart_root, dart_lean), dart_place)


def dart():
    """A dart trimmed for glides: a straight tail, the last tenth of its wings bent up by 6 degrees."""
    size, rise, flap = 0.20, 0.12, math.tan(math.radians(6.0))

    def put(along, sideways, down):
        return (-along, sideways, rise * abs(sideways) - down + (flap * max(0.0, along - 0.9 * size) if down == 0.0 else 0.0))
    mesh = solid_dart(Mesh("dart", "dart of 20 cm, 10.5 cm wide, 0.3 mm, the last tenth of its wings bent up"), 20, size,
                      0.0525, 0.025, (size, 0.0), put)
    mesh.centre()
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
