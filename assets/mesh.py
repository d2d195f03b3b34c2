"""A triangle mesh with its checks and its file, and the vectors for it: for make_assets.py. SPDX-License-Identifier: MIT"""
import math
import os


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
