"""Paper planes: darts as surfaces, as all layers of their paper, and as solids: for make_assets.py. SPDX-License-Identifier: MIT"""
import math

from mesh import Mesh, add, length, scaled, sub


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
