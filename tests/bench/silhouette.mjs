// Silhouettes of files as masks, drawn by orthographic projection in several views.

import { readdirSync, readFileSync } from 'node:fs';
import { dirname, basename, join } from 'node:path';

const SIZE = 512;
/** Directions of view: along the axes, and along four diagonals. */
const DIRECTIONS = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
  [1, 1, 1],
  [1, 1, -1],
  [-1, 1, 1],
  [-1, 1, -1],
];

/**
 * The masks of a file in every view. `views`: those of another file, so that both are seen alike; absent: such that the file
 * fills each of them. A mask has 1 where a triangle covers the middle of the pixel.
 */
export async function silhouettes(engine, path, views) {
  const { triangles, faces } = await worldTriangles(engine, path);
  const own = views ?? DIRECTIONS.map((direction) => viewAlong(direction, triangles));
  return { views: own, faces, masks: own.map((view) => draw(view, triangles)) };
}

/** The worst overlap (common pixels over all pixels) of the views, and the pixels behind which the result is empty though all around is covered. */
export function overlap(before, after) {
  let worst = 1;
  let holes = 0;
  before.masks.forEach((mask, view) => {
    const other = after.masks[view];
    let [both, any] = [0, 0];
    for (let i = 0; i < mask.length; ++i) {
      both += mask[i] & other[i];
      any += mask[i] | other[i];
    }
    worst = Math.min(worst, any === 0 ? 1 : both / any);
    holes += seenThrough(mask, other);
  });
  return { worst, holes };
}

/** Pixels that the input covers and the result does not, and that cannot be reached from outside: the outline may move, the inside may not open. */
function seenThrough(mask, other) {
  const isOutside = new Uint8Array(mask.length);
  const stack = [];
  const visit = (x, y) => {
    const i = y * SIZE + x;
    if (x < 0 || y < 0 || x >= SIZE || y >= SIZE || isOutside[i] || other[i]) return;
    isOutside[i] = 1;
    stack.push(i);
  };
  // What the input leaves open is outside too, holes of its own included.
  for (let i = 0; i < mask.length; ++i) if (!mask[i]) visit(i % SIZE, Math.floor(i / SIZE));
  while (stack.length > 0) {
    const i = stack.pop();
    const [x, y] = [i % SIZE, Math.floor(i / SIZE)];
    visit(x - 1, y);
    visit(x + 1, y);
    visit(x, y - 1);
    visit(x, y + 1);
  }
  let holes = 0;
  for (let i = 0; i < mask.length; ++i) holes += mask[i] && !other[i] && !isOutside[i] ? 1 : 0;
  return holes;
}

/** World positions of all triangles, nine numbers each, and how many the file has. */
async function worldTriangles(engine, path) {
  const companions = path.endsWith('.gltf')
    ? readdirSync(dirname(path), { recursive: true })
        .map(String)
        .filter((name) => /\.(bin|png|jpe?g|ktx2|webp)$/i.test(name))
    : [];
  const files = [basename(path), ...companions].map((name) => ({
    name,
    bytes: new Uint8Array(readFileSync(join(dirname(path), name))),
  }));
  const { document, bodies } = await engine.openModel(files);
  const meshes = document.getRoot().listMeshes();
  const triangles = [];
  for (const node of document.getRoot().listNodes()) {
    const body = bodies.find(({ mesh }) => meshes[mesh] === node.getMesh());
    if (!body) continue;
    const m = node.getWorldMatrix();
    for (const v of body.indices) {
      const [x, y, z] = body.positions.subarray(3 * v, 3 * v + 3);
      for (let c = 0; c < 3; ++c) triangles.push(m[c] * x + m[4 + c] * y + m[8 + c] * z + m[12 + c]);
    }
  }
  return { triangles, faces: bodies.reduce((sum, { indices }) => sum + indices.length / 3, 0) };
}

/** Two axes across the direction, and the square that holds all points with a margin. */
function viewAlong(direction, triangles) {
  const length = Math.hypot(...direction);
  const w = direction.map((value) => value / length);
  const up = Math.abs(w[1]) > 0.9 ? [0, 0, 1] : [0, 1, 0];
  const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
  const u = cross(up, w);
  const size = Math.hypot(...u);
  const axes = [u.map((value) => value / size)];
  axes.push(cross(w, axes[0]));
  const low = [Infinity, Infinity];
  const high = [-Infinity, -Infinity];
  for (let i = 0; i < triangles.length; i += 3)
    axes.forEach((axis, c) => {
      const at = axis[0] * triangles[i] + axis[1] * triangles[i + 1] + axis[2] * triangles[i + 2];
      low[c] = Math.min(low[c], at);
      high[c] = Math.max(high[c], at);
    });
  const span = 1.05 * Math.max(high[0] - low[0], high[1] - low[1], 1e-30);
  return { axes, origin: [0, 1].map((c) => (low[c] + high[c]) / 2 - span / 2), scale: SIZE / span };
}

function draw({ axes, origin, scale }, triangles) {
  const mask = new Uint8Array(SIZE * SIZE);
  const at = (i, c) =>
    (axes[c][0] * triangles[i] + axes[c][1] * triangles[i + 1] + axes[c][2] * triangles[i + 2] - origin[c]) *
    scale;
  for (let t = 0; t < triangles.length; t += 9)
    fill(
      mask,
      [0, 3, 6].map((k) => [at(t + k, 0), at(t + k, 1)]),
    );
  return mask;
}

/** Sets the pixels whose middles lie in the triangle. */
function fill(mask, [a, b, c]) {
  const clamp = (value) => Math.min(SIZE - 1, Math.max(0, value));
  const area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  if (area === 0) return;
  const side = (p, q, x, y) => ((q[0] - p[0]) * (y - p[1]) - (q[1] - p[1]) * (x - p[0])) * Math.sign(area);
  const y1 = clamp(Math.ceil(Math.max(a[1], b[1], c[1])));
  const x1 = clamp(Math.ceil(Math.max(a[0], b[0], c[0])));
  for (let y = clamp(Math.floor(Math.min(a[1], b[1], c[1]))); y <= y1; ++y)
    for (let x = clamp(Math.floor(Math.min(a[0], b[0], c[0]))); x <= x1; ++x) {
      const [px, py] = [x + 0.5, y + 0.5];
      if (side(a, b, px, py) >= 0 && side(b, c, px, py) >= 0 && side(c, a, px, py) >= 0)
        mask[y * SIZE + x] = 1;
    }
}
