// SPDX-License-Identifier: MIT
// Models: the asset for the library, and a coarse sheet to draw in the same frame, x along, y across, z through.

const smooth = (x) => Math.max(0, Math.min(1, x));

/** Radius of a leaf by angle: five lobes, each a length and an angle from the tip, and a stem. */
function lobes(angle) {
  const far = (at) => Math.abs(Math.atan2(Math.sin(angle - at), Math.cos(angle - at)));
  const points = [[1, 0], [0.92, 0.96], [0.92, -0.96], [0.62, 1.95], [0.62, -1.95]];
  return Math.max(0.36, ...points.map(([length, at]) => length * (1 - 1.5 * far(at)))) + (far(Math.PI) < 0.06 ? 0.6 : 0);
}

/** Half width at u from -1 to 1 along, and height of the sheet there for v from -1 to 1 across. */
const shapes = {
  leaf: { along: 10, across: 4, width: (u) => 0.57 * (1 - u * u) ** 0.7 * (1 - 0.28 * u), bend: (u, v) => 0.1 * (1 - u * u) + 0.12 * Math.abs(v) * (1 - u * u) },
  maple: { around: 60, radius: lobes, bend: (u, v) => 0.12 * (1 - u * u) * (1 - v * v) },
  petal: { along: 8, across: 4, width: (u) => 0.75 * (1 - u * u) ** 0.6 * (1 + 0.35 * u), bend: (u, v) => 0.2 * (u * u + v * v) },
  paper: { along: 3, across: 2, width: () => 0.7, bend: (u) => 0.02 * u * u },
  confetti: { along: 2, across: 2, width: () => 0.5, bend: () => 0 },
  curled: { along: 10, across: 6, width: (u) => 0.5 * (1 - u * u) ** 0.6, bend: (u, v) => 0.06 * (1 - u * u) * v * v + 0.12 * u * v * (1 - u * u) ** 0.6 },
  seed: { along: 16, across: 4, at: [0.6, 0.08], width: (u) => (u < -0.72 ? 0.11 : 0.06 + 0.17 * smooth((u + 0.72) / 0.9)) * (1 - u ** 8) ** 0.5, bend: (u, v) => (u < -0.72 ? 0.07 * (1 - v * v) : 0) },
};

/** Vertices (x, y, z, u, v) and triangles of a sheet of half length 1. */
export function sheet(shape) {
  const vertices = [];
  const triangles = [];
  if (shape.radius) fan(shape, vertices, triangles);
  else grid(shape, vertices, triangles);
  return { vertices: new Float32Array(vertices), triangles: new Uint16Array(triangles) };
}

function fan({ around, radius, bend }, vertices, triangles) {
  vertices.push(0, 0, bend(0, 0), 0.5, 0.5);
  for (let i = 0; i < around; ++i) {
    const angle = (2 * Math.PI * i) / around;
    const [u, v] = [radius(angle) * Math.cos(angle), radius(angle) * Math.sin(angle)];
    vertices.push(u, v, bend(u, v), smooth((u + 1) / 2), smooth((v + 1) / 2));
    triangles.push(0, 1 + i, 1 + ((i + 1) % around));
  }
}

// at: of the sheet's middle, from the centre of mass
function grid({ along, across, width, bend, at: [x, y] = [0, 0] }, vertices, triangles) {
  for (let i = 0; i <= along; ++i) {
    const u = (2 * i) / along - 1;
    const half = width(u) || 0;
    for (let j = 0; j <= across; ++j) {
      const v = (2 * j) / across - 1;
      vertices.push(x + u, y + half * v, bend(u, v), smooth((u + 1) / 2), smooth((v + 1) / 2));
      if (i === along || j === across) continue;
      const at = i * (across + 1) + j;
      triangles.push(at, at + across + 1, at + 1, at + 1, at + across + 1, at + across + 2);
    }
  }
}

// half: half length, m. room: half width and height of the storm, m. fall: fall speed, m/s. substeps: at 60 Hz, docs/maintainers/numerics.md.
const autumn = [[0.93, 0.71, 0.1], [0.9, 0.45, 0.08], [0.72, 0.22, 0.06], [0.95, 0.82, 0.3], [0.55, 0.33, 0.12], [0.62, 0.6, 0.16]];
export const models = {
  leaf: { name: 'Leaf, 7 cm', file: 'leaf.lrb', half: 0.035, shape: shapes.leaf, room: [3, 3.4], fall: 1.2, substeps: 2, colours: autumn, ribs: 1 },
  maple: { name: 'Maple leaf, 6 cm', file: 'leaf_maple.lrb', half: 0.03, shape: shapes.maple, room: [3, 3.4], fall: 1.1, substeps: 2, colours: [[0.8, 0.18, 0.06], [0.88, 0.36, 0.07], [0.93, 0.62, 0.12], [0.6, 0.1, 0.07]], ribs: 1 },
  curled: { name: 'Curled leaf, 8 cm', file: 'curled_leaf.lrb', half: 0.04, shape: shapes.curled, room: [3, 3.4], fall: 0.9, substeps: 4, colours: autumn, ribs: 1 },
  seed: { name: 'Winged seed, 5.6 cm', file: 'samara.lrb', half: 0.028, shape: shapes.seed, room: [2.4, 2.8], fall: 1, substeps: 4, colours: [[0.72, 0.52, 0.25], [0.62, 0.45, 0.2], [0.8, 0.63, 0.35]], ribs: 0 },
  petal: { name: 'Cherry petal, 1.2 cm', file: 'petal.lrb', half: 0.006, shape: shapes.petal, room: [0.8, 0.9], fall: 0.9, substeps: 4, colours: [[1, 0.8, 0.86], [0.98, 0.7, 0.79], [1, 0.9, 0.93]], ribs: 0 },
  paper: { name: 'Sheet of paper, 10 x 7 cm', box: [0.05, 0.035, 0.00005], density: 800, half: 0.05, shape: shapes.paper, room: [4, 4.2], fall: 0.9, substeps: 2, colours: [[0.97, 0.96, 0.92], [0.93, 0.93, 0.96]], ribs: 0 },
  confetti: { name: 'Confetti, 12 x 6 mm', file: 'confetti.lrb', half: 0.006, shape: shapes.confetti, room: [0.8, 0.9], fall: 1, substeps: 4, colours: [[0.95, 0.2, 0.25], [0.15, 0.5, 0.95], [0.98, 0.8, 0.1], [0.2, 0.75, 0.35], [0.75, 0.3, 0.85], [0.98, 0.55, 0.1]], ribs: 0 },
};
