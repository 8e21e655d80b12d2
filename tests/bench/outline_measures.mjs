// What a result has kept of an open sheet: area, length of the outline, corners, bounding box; measured independently of
// the core, for tests/bench/outline.mjs and the tests of the fit.

/** A border vertex is a corner where its interior border angle is off 180 degrees by more than this. */
const CORNER_DEGREES = 30;

const pointOf = ({ positions }, v) => positions.subarray(3 * v, 3 * v + 3);
const minus = (p, q) => [p[0] - q[0], p[1] - q[1], p[2] - q[2]];
const cross = (p, q) => [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]];
const dot = (p, q) => p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
const lengthOf = (p) => Math.hypot(...p);
const distance = (p, q) => lengthOf(minus(p, q));

/** Vertex pairs [a, b] of the edges with one triangle. */
function bordersOf({ triangles }) {
  const seen = new Map();
  for (let t = 0; t < triangles.length; t += 3)
    for (let c = 0; c < 3; c++) {
      const [a, b] = [triangles[t + c], triangles[t + ((c + 1) % 3)]];
      const key = `${Math.min(a, b)},${Math.max(a, b)}`;
      seen.set(key, seen.has(key) ? null : [a, b]);
    }
  return [...seen.values()].filter((edge) => edge !== null);
}

export function areaOf(mesh) {
  const { triangles } = mesh;
  let area = 0;
  for (let t = 0; t < triangles.length; t += 3) {
    const [p, q, r] = [0, 1, 2].map((c) => pointOf(mesh, triangles[t + c]));
    area += lengthOf(cross(minus(q, p), minus(r, p))) / 2;
  }
  return area;
}

/** The sum of the triangles' angles at each vertex, degrees. */
function anglesOf(mesh) {
  const { positions, triangles } = mesh;
  const angles = new Float64Array(positions.length / 3);
  for (let t = 0; t < triangles.length; t += 3)
    for (let c = 0; c < 3; c++) {
      const [p, q, r] = [0, 1, 2].map((k) => pointOf(mesh, triangles[t + ((c + k) % 3)]));
      const [a, b] = [minus(q, p), minus(r, p)];
      angles[triangles[t + c]] += (Math.atan2(lengthOf(cross(a, b)), dot(a, b)) * 180) / Math.PI;
    }
  return angles;
}

/** { area, length of the border loops, low, high: the bounding box, diagonal, corners: points, border: points }. */
export function outlineOf(mesh) {
  const edges = bordersOf(mesh);
  const vertices = [...new Set(edges.flat())];
  const angles = anglesOf(mesh);
  const used = [...new Set(mesh.triangles)].map((v) => pointOf(mesh, v));
  const range = (best) =>
    [0, 1, 2].map((axis) => used.reduce((value, p) => best(value, p[axis]), used[0][axis]));
  const [low, high] = [range(Math.min), range(Math.max)];
  return {
    area: areaOf(mesh),
    length: edges.reduce((sum, [a, b]) => sum + distance(pointOf(mesh, a), pointOf(mesh, b)), 0),
    low,
    high,
    diagonal: distance(low, high),
    border: vertices.map((v) => pointOf(mesh, v)),
    corners: vertices.filter((v) => Math.abs(angles[v] - 180) > CORNER_DEGREES).map((v) => pointOf(mesh, v)),
  };
}

/**
 * What `result` has lost of `original` (both from outlineOf): area and length of the outline in % of the original's (null
 * without a border); the mean and largest distance of the original's corners from the nearest border vertex of the result,
 * and the largest shift of a side of the bounding box, in % of the diagonal.
 */
export function compareOutlines(original, result) {
  const percent = (after, before) => (before > 0 ? 100 * (after / before - 1) : null);
  const share = (length) => (100 * length) / original.diagonal;
  const moved = original.corners.map((corner) =>
    share(result.border.reduce((least, p) => Math.min(least, distance(corner, p)), Infinity)),
  );
  const sides = [0, 1, 2].flatMap((axis) => [
    Math.abs(original.low[axis] - result.low[axis]),
    Math.abs(original.high[axis] - result.high[axis]),
  ]);
  return {
    area: percent(result.area, original.area),
    length: percent(result.length, original.length),
    corners: moved.length,
    cornerMean: moved.length ? moved.reduce((sum, d) => sum + d, 0) / moved.length : null,
    cornerMost: moved.length ? Math.max(...moved) : null,
    box: share(Math.max(...sides)),
  };
}
