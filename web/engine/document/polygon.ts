/** Triangulates one polygon of a file. */

import earcut from 'earcut';
import { arcCosine, length3 } from '../core/exact_math';
import { grouped } from '../core/words';

/** A corner closer than this to the line through its neighbours is moved inwards by as much; relative to the size. */
const DENT = 1e-6;
/** A triangle lower than this times its longest side counts as degenerate; float32 cannot tell it from a line. */
const FLAT = 1e-6;
/** A polygon has no area if twice its area is below this times its size squared. */
const NO_AREA = 1e-12;

/** Ear clipping takes quadratic time, so larger polygons have to be convex. */
export const MAX_CORNERS = 10_000;
/** How far corners may dent a larger polygon, relative to its size: by rounding alone. */
const ROUNDING = 1e-6;

/**
 * Triangulates the polygon `corners` (at least 3 vertex indices, no two neighbours equal). Returns n - 2 index triples, so
 * that no corner is left out and adjacent polygons still meet. The result is a fan from the first corner that sees all
 * others, which every convex polygon has; polygons without one are ear-clipped in the plane of their Newell normal. Null for
 * a polygon of more than MAX_CORNERS corners that is not convex.
 */
export function triangulatePolygon(corners: number[], positions: Float32Array): number[] | null {
  if (corners.length === 3) return corners;
  const points = projectPolygon(corners, positions);
  if (corners.length > MAX_CORNERS) return points === null || isNearlyConvex(points) ? fan(corners, 0) : null;
  if (points !== null) {
    for (let start = 0; start < corners.length; ++start)
      if (isFanUpright(points, start)) return fan(corners, start);
    const ears = earcut(dentStraightCorners(points));
    if (ears.length === 3 * (corners.length - 2))
      return orient(ears, points).map((corner) => corners[corner]);
  }
  return fan(corners, 0);
}

/**
 * As `triangulatePolygon`, of corners that may repeat: a polygon with fewer than three distinct ones becomes one degenerate triangle,
 * which welding counts; one without corners becomes none.
 */
export function trianglesOfPolygon(polygon: number[], positions: Float32Array): number[] | null {
  const corners = polygon.filter(
    (vertex, i) => vertex !== polygon[(i + polygon.length - 1) % polygon.length],
  );
  if (corners.length === 0) return polygon.length > 0 ? [polygon[0], polygon[0], polygon[0]] : [];
  while (corners.length < 3) corners.push(corners[corners.length - 1]);
  return triangulatePolygon(corners, positions);
}

/** Why a polygon could not be triangulated, as a clause. */
export const describeTooLarge = (corners: number): string =>
  `a face that is not convex has ${grouped(corners)} corners, more than the ${grouped(MAX_CORNERS)} that can be triangulated: triangulate it before the export`;

function fan(corners: number[], start: number): number[] {
  const count = corners.length;
  const triangles: number[] = [];
  for (let i = 1; i + 1 < count; ++i)
    triangles.push(corners[start], corners[(start + i) % count], corners[(start + i + 1) % count]);
  return triangles;
}

/**
 * The corners in the plane of the Newell normal, scaled to size 1 and counter-clockwise: points[2 * i + c]; null if the
 * polygon has no area.
 */
function projectPolygon(corners: number[], positions: Float32Array): number[] | null {
  const at = (i: number, c: number) => positions[3 * corners[i % corners.length] + c];
  const normal = [0, 0, 0];
  let size = 0;
  for (let i = 0; i < corners.length; ++i)
    for (let c = 0; c < 3; ++c) {
      const [u, v] = [(c + 1) % 3, (c + 2) % 3];
      // Positions relative to the first corner avoid cancellation far from the origin.
      normal[c] +=
        (at(i, u) - at(0, u)) * (at(i + 1, v) - at(0, v)) - (at(i, v) - at(0, v)) * (at(i + 1, u) - at(0, u));
      size = Math.max(size, Math.abs(at(i, c) - at(0, c)));
    }
  const length = length3(normal[0], normal[1], normal[2]);
  if (!(length > NO_AREA * size * size)) return null;
  const unit = normal.map((value) => value / length);
  const [right, up] = planeAxes(unit);
  return corners.flatMap((_, i) => {
    const d = [0, 1, 2].map((c) => (at(i, c) - at(0, c)) / size);
    return [dot(d, right), dot(d, up)];
  });
}

/** Two unit vectors that form a right-handed frame with `normal`. */
function planeAxes(normal: number[]): [number[], number[]] {
  const smallest = normal.reduce(
    (best, value, c) => (Math.abs(value) < Math.abs(normal[best]) ? c : best),
    0,
  );
  const helper = [0, 1, 2].map((c) => (c === smallest ? 1 : 0));
  const raw = cross(helper, normal);
  const length = length3(raw[0], raw[1], raw[2]);
  const right = raw.map((value) => value / length);
  return [right, cross(normal, right)];
}

const dot = (a: number[], b: number[]) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a: number[], b: number[]) => [0, 1, 2].map((c) => crossPart(a, b, (c + 1) % 3, (c + 2) % 3));
const crossPart = (a: number[], b: number[], u: number, v: number) => a[u] * b[v] - a[v] * b[u];

/** Twice the signed area of the triangle of three corners. */
function doubledArea(points: number[], a: number, b: number, c: number): number {
  const [ax, ay] = [points[2 * a], points[2 * a + 1]];
  return (points[2 * b] - ax) * (points[2 * c + 1] - ay) - (points[2 * b + 1] - ay) * (points[2 * c] - ax);
}

/** Whether every triangle of the fan is counter-clockwise, and the fan goes around at most once. */
function isFanUpright(points: number[], start: number): boolean {
  const count = points.length / 2;
  for (let i = 1; i + 1 < count; ++i) {
    const [a, b] = [(start + i) % count, (start + i + 1) % count];
    const longest = longestSide(points, start, a, b);
    if (!(doubledArea(points, start, a, b) > FLAT * longest * longest)) return false;
  }
  return !windsTwice(points, start);
}

/**
 * Whether the fan from the first corner reverses no triangle, except by rounding, and goes around once. It then turns by the angle of
 * the corner, less than pi; where a polygon winds twice, by 2 pi or more.
 */
function isNearlyConvex(points: number[]): boolean {
  let turned = 0;
  for (let i = 1; i + 1 < points.length / 2; ++i) {
    const area = doubledArea(points, 0, i, i + 1);
    if (!(area > -ROUNDING * longestSide(points, 0, i, i + 1))) return false;
    const sides = distance(points, 0, i) * distance(points, 0, i + 1);
    turned += Math.sign(area) * (sides > 0 ? arcCosine(dotAt(points, i, i + 1) / sides) : 0);
  }
  return turned < 1.5 * Math.PI;
}

/** The dot product of the sides from corner 0 to two others. */
function dotAt(points: number[], a: number, b: number): number {
  const [x, y] = points;
  return (points[2 * a] - x) * (points[2 * b] - x) + (points[2 * a + 1] - y) * (points[2 * b + 1] - y);
}

const longestSide = (points: number[], a: number, b: number, c: number): number =>
  Math.max(distance(points, a, b), distance(points, b, c), distance(points, c, a));

function distance(points: number[], a: number, b: number): number {
  return length3(points[2 * a] - points[2 * b], points[2 * a + 1] - points[2 * b + 1], 0);
}

/** A fan of counter-clockwise triangles winds twice if one after the first contains the fan's first side again. */
function windsTwice(points: number[], start: number): boolean {
  const count = points.length / 2;
  const first = (start + 1) % count;
  for (let i = 2; i + 1 < count; ++i) {
    const [a, b] = [(start + i) % count, (start + i + 1) % count];
    if (doubledArea(points, start, a, first) > 0 && doubledArea(points, start, first, b) >= 0) return true;
  }
  return false;
}

/** earcut drops corners on straight sides, which would open cracks; corners that are moved slightly inwards stay. */
function dentStraightCorners(points: number[]): number[] {
  const count = points.length / 2;
  return points.map((value, at) => {
    const i = at >> 1;
    const [before, after] = [(i + count - 1) % count, (i + 1) % count];
    const length = distance(points, before, after);
    if (length === 0 || Math.abs(doubledArea(points, before, i, after)) > DENT * length) return value;
    const [x, y] = [points[2 * after] - points[2 * before], points[2 * after + 1] - points[2 * before + 1]];
    return value + (DENT * (at % 2 === 0 ? -y : x)) / length;
  });
}

/** Reverses the triangles that run clockwise. */
function orient(triangles: number[], points: number[]): number[] {
  for (let t = 0; t < triangles.length; t += 3) {
    const [a, b, c] = [triangles[t], triangles[t + 1], triangles[t + 2]];
    if (doubledArea(points, a, b, c) < 0) [triangles[t + 1], triangles[t + 2]] = [c, b];
  }
  return triangles;
}
