/** The singular value decomposition of a 3 x 3 matrix: a rotation, a scale along the axes, and another rotation. */

import { length3 } from '../../core/exact_math';
import { cross, dot } from '../../core/vectors';
import type { Vector } from '../../core/vectors';

/** x, y, z, w, of length 1 */
export type Quaternion = [number, number, number, number];

/** The matrix is the rotation `outer`, times the scale, times the rotation `inner`. */
export interface MatrixFactors {
  outer: Quaternion;
  /** negative along one axis where the matrix is a reflection */
  scale: Vector;
  inner: Quaternion;
  /** the rotation and the scale that come closest to the matrix without its shear */
  closest: { rotation: Quaternion; scale: Vector };
}

/** Far more rounds than are ever needed, since convergence is quadratic. */
const MAX_ROUNDS = 30;
/** Cosines below this are rounding errors. */
const ROUNDING = 1e-15;
/** A column shorter than this share of the longest counts as 0. */
const NEGLIGIBLE = 1e-14;

/**
 * The factors of the matrix with these columns, by one-sided Jacobi: rotations of two axes at a time make its columns
 * perpendicular. Columns that are so already, or of length 0, leave `inner` exactly the identity.
 */
export function factorsOf(columns: readonly Vector[]): MatrixFactors {
  const unit = Math.max(...columns.flat().map(Math.abs)) || 1;
  const axes = columns.map((column) => column.map((value) => value / unit) as Vector);
  const turned: Vector[] = [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ];
  for (let round = 0; round < MAX_ROUNDS; ++round) {
    const isDone = PAIRS.map(([i, j]) => makePerpendicular(axes, turned, [i, j])).every((is) => is);
    if (isDone) break;
  }
  const outer = frameOf(axes);
  const scale = outer.map((direction, k) => unit * dot(direction, axes[k])) as Vector;
  const inner = transposed(turned);
  // U S Vᵀ = (U Vᵀ)(V S Vᵀ), of which the second factor keeps its diagonal.
  const rotation = inner.map((column) => combined(outer, column));
  const stretch = [0, 1, 2].map((c) => scale.reduce((sum, s, k) => sum + s * turned[k][c] ** 2, 0));
  return {
    outer: quaternionOf(outer),
    scale,
    inner: quaternionOf(inner),
    closest: { rotation: quaternionOf(rotation), scale: stretch as Vector },
  };
}

const PAIRS = [
  [0, 1],
  [0, 2],
  [1, 2],
] as const;

/** Rotates two of the axes so that they are perpendicular, and the columns of `turned` with them. Returns whether they were already. */
function makePerpendicular(axes: Vector[], turned: Vector[], [i, j]: readonly [number, number]): boolean {
  const [a, b] = [dot(axes[i], axes[i]), dot(axes[j], axes[j])];
  const product = dot(axes[i], axes[j]);
  if (Math.abs(product) <= ROUNDING * Math.sqrt(a) * Math.sqrt(b)) return true;
  const ratio = (b - a) / (2 * product);
  const tangent = (ratio < 0 ? -1 : 1) / (Math.abs(ratio) + Math.sqrt(1 + ratio * ratio));
  const cosine = 1 / Math.sqrt(1 + tangent * tangent);
  for (const columns of [axes, turned]) {
    const [first, second] = [columns[i], columns[j]];
    columns[i] = first.map((value, c) => cosine * (value - tangent * second[c])) as Vector;
    columns[j] = first.map((value, c) => cosine * (tangent * value + second[c])) as Vector;
  }
  return false;
}

/** A right-handed frame with the directions of these perpendicular axes; the shortest one may be reversed. */
function frameOf(axes: readonly Vector[]): Vector[] {
  const lengths = axes.map(([x, y, z]) => length3(x, y, z));
  const last = lengths.indexOf(Math.min(...lengths));
  const [first, second] = [(last + 1) % 3, (last + 2) % 3];
  const frame: Vector[] = [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ];
  const least = NEGLIGIBLE * Math.max(...lengths);
  const [hasFirst, hasSecond] = [lengths[first] > least, lengths[second] > least];
  if (!hasFirst && !hasSecond) return frame;
  if (hasFirst) frame[first] = unitOf(axes[first]);
  frame[second] = hasSecond ? unitOf(axes[second]) : perpendicularTo(frame[first]);
  if (!hasFirst) frame[first] = perpendicularTo(frame[second]);
  frame[last] = cross(frame[first], frame[second]);
  return frame;
}

/** A direction perpendicular to another: the coordinate axis that is farthest from it, made orthogonal. */
function perpendicularTo(direction: Vector): Vector {
  const sizes = direction.map(Math.abs);
  const axis: Vector = [0, 0, 0];
  axis[sizes.indexOf(Math.min(...sizes))] = 1;
  return unitOf(cross(direction, axis));
}

/** The quaternion of a rotation with these columns, computed from its largest component to avoid cancellation. */
function quaternionOf([[a, b, c], [d, e, f], [g, h, i]]: readonly Vector[]): Quaternion {
  const squares = [1 + a - e - i, 1 - a + e - i, 1 - a - e + i, 1 + a + e + i];
  const largest = squares.indexOf(Math.max(...squares));
  const size = squares[largest];
  const rows: Quaternion[] = [
    [size, b + d, g + c, f - h],
    [b + d, size, f + h, g - c],
    [g + c, f + h, size, b - d],
    [f - h, g - c, b - d, size],
  ];
  const row = rows[largest];
  const length = Math.sqrt(row.reduce((sum, value) => sum + value * value, 0));
  return row.map((value) => value / length) as Quaternion;
}

const unitOf = ([x, y, z]: Vector): Vector => {
  const length = length3(x, y, z);
  return [x / length, y / length, z / length];
};

const transposed = (columns: readonly Vector[]): Vector[] =>
  [0, 1, 2].map((row) => columns.map((column) => column[row]) as Vector);

const combined = (columns: readonly Vector[], factors: Vector): Vector =>
  [0, 1, 2].map((c) => columns.reduce((sum, column, k) => sum + factors[k] * column[c], 0)) as Vector;
