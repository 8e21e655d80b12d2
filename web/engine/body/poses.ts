/**
 * How the animations of a file bend a skinned body, and its morph targets any body, as few fields over its vertices that can count in
 * the error of a collapse. `Rest` is the rest pose.
 *
 * The error of a collapse in a pose is the error at rest plus that of interpolating the pose's displacements. What is affine in
 * the displacements of a pose costs nothing, so it is subtracted. The remainder of the poses of animations is reduced to its principal
 * fields (proper orthogonal decomposition: Sirovich 1987): the squares of the fields, scaled by their amplitudes, add up to the mean over
 * the poses as well as so few fields can. Morph targets are many and move few vertices each, so theirs are mixtures; see `mixtures`.
 */

import type { Document } from '@gltf-transform/core';
import type { WeldResult } from '../core/core';
import { vertexCount } from '../core/mesh';
import type { Body } from '../document/model';
import { posesOfTargets } from './morphing';
import { posesInAnimations } from './skinning';
import type { PosedPositions } from './skinning';

/** values[size * v + d]: displacements of welded vertices, in units of the mesh; size is 3 for each field. */
export interface Poses {
  values: Float32Array;
  size: number;
  /** how many of the last fields are those of animations */
  animated: number;
}

/** At most `most` fields; null where nothing bends the body. */
export function posesOf(document: Document, body: Body, weld: WeldResult, most: number): Poses | null {
  const rest = Float64Array.from(weld.mesh.positions);
  const bending = (posed: PosedPositions): Float64Array => bendingOf(rest, weldedPose(posed, weld));
  const [animated, targets] = [posesInAnimations, posesOfTargets].map((find) =>
    find(document, body).map(bending),
  );
  const ofTargets = targets.length === 0 ? 0 : Math.floor(most / (animated.length === 0 ? 1 : 2));
  const principal = principalFields(animated, most - ofTargets);
  const fields = [...mixtures(targets, ofTargets), ...principal];
  if (fields.length === 0) return null;
  const size = 3 * fields.length;
  const values = new Float32Array(size * vertexCount(weld.mesh));
  fields.forEach((field, k) =>
    field.forEach((value, i) => (values[size * Math.floor(i / 3) + 3 * k + (i % 3)] = value)),
  );
  return { values, size, animated: principal.length };
}

function weldedPose(posed: Float64Array, { vertexOfSource, mesh }: WeldResult): Float64Array {
  const welded = new Float64Array(mesh.positions.length);
  vertexOfSource.forEach((v, source) => {
    if (3 * v + 2 < welded.length) welded.set(posed.subarray(3 * source, 3 * source + 3), 3 * v);
  });
  return welded;
}

/** A pose about its middle, without its best affine approximation from the rest pose, scaled to the size of the body at rest. */
function bendingOf(rest: Float64Array, pose: Float64Array): Float64Array {
  const [from, to] = [aboutMiddle(rest), aboutMiddle(pose)];
  const scale = Math.sqrt(squares(from) / Math.max(squares(to), Number.MIN_VALUE));
  const basis = orthonormalAxes(from);
  for (let c = 0; c < 3; ++c)
    for (const axis of basis) {
      let share = 0;
      axis.forEach((value, v) => (share += value * to[3 * v + c]));
      axis.forEach((value, v) => (to[3 * v + c] -= share * value));
    }
  return to.map((value) => scale * value);
}

/** The coordinates x, y, z of the vertices, each as a field over them, made orthonormal; those that vanish are left out. */
function orthonormalAxes(points: Float64Array): Float64Array[] {
  const basis: Float64Array[] = [];
  for (let c = 0; c < 3; ++c) {
    const axis = Float64Array.from({ length: points.length / 3 }, (_, v) => points[3 * v + c]);
    const before = squares(axis);
    for (const other of basis) {
      const share = product(axis, other);
      axis.forEach((_, v) => (axis[v] -= share * other[v]));
    }
    const length = Math.sqrt(squares(axis));
    if (length * length > 1e-12 * before) basis.push(axis.map((value) => value / length));
  }
  return basis;
}

function aboutMiddle(points: Float64Array): Float64Array {
  const middle = [0, 0, 0];
  points.forEach((value, i) => (middle[i % 3] += (3 * value) / points.length));
  return points.map((value, i) => value - middle[i % 3]);
}

/** Fields with amplitude, so that their squares sum up to the mean over the poses as nearly as `most` of them can. */
function principalFields(poses: Float64Array[], most: number): Float64Array[] {
  const rest = poses.map((pose) => pose.slice());
  const fields: Float64Array[] = [];
  const whole = rest.reduce((total, pose) => total + squares(pose), 0);
  while (fields.length < most) {
    const direction = principalDirection(rest);
    const left = rest.reduce((total, pose) => total + squares(pose), 0);
    if (!direction || !(left > 1e-6 * whole)) break;
    const shares = rest.map((pose) => product(pose, direction));
    const amplitude = Math.sqrt(shares.reduce((total, share) => total + share * share, 0) / rest.length);
    fields.push(direction.map((value) => amplitude * value));
    rest.forEach((pose, i) => pose.forEach((_, v) => (pose[v] -= shares[i] * direction[v])));
  }
  return fields;
}

const POWER_STEPS = 50;

/** The unit field with the largest sum of squared products with the poses, by power iteration from the largest pose. */
function principalDirection(poses: Float64Array[]): Float64Array | null {
  let largest: Float64Array | null = null;
  for (const pose of poses) if (squares(pose) > (largest ? squares(largest) : 0)) largest = pose;
  if (!largest) return null;
  let direction = unit(largest);
  for (let step = 0; step < POWER_STEPS; ++step) {
    const next = new Float64Array(direction.length);
    for (const pose of poses) {
      const share = product(pose, direction);
      pose.forEach((value, i) => (next[i] += share * value));
    }
    direction = unit(next);
  }
  return direction;
}

const unit = (field: Float64Array): Float64Array => {
  const length = Math.sqrt(squares(field));
  return field.map((value) => value / length);
};

const squares = (field: Float64Array): number => product(field, field);

function product(a: Float64Array, b: Float64Array): number {
  let total = 0;
  for (let i = 0; i < a.length; ++i) total += a[i] * b[i];
  return total;
}

/** The mean square of a morph target's weight that is uniformly distributed in [0, 1]. */
const MEAN_SQUARE_WEIGHT = 1 / 3;

/**
 * Fields whose squares add up, at each vertex, to that of the target which moves it most, times the mean square of its weight. They
 * are sums of all targets with signs that alternate differently in each field, by which squares of sums are on average sums of squares
 * (random projections: Achlioptas 2003, section 2), scaled down where targets overlap.
 */
function mixtures(poses: Float64Array[], count: number): Float64Array[] {
  if (poses.length === 0) return [];
  const amplitude = Math.sqrt(MEAN_SQUARE_WEIGHT / count);
  const weights = Float64Array.from(
    { length: poses[0].length / 3 },
    (_, v) => amplitude * shareOfMost(poses, v),
  );
  return Array.from({ length: count }, (_, k) => {
    const field = new Float64Array(poses[0].length);
    poses.forEach((pose, t) => {
      const sign = isOdd(k & t) ? -1 : 1;
      pose.forEach((value, i) => (field[i] += sign * weights[Math.floor(i / 3)] * value));
    });
    return field;
  });
}

/** The largest displacement of vertex v in any pose, over the root of the sum of squares over all poses. */
function shareOfMost(poses: Float64Array[], v: number): number {
  let [most, sum] = [0, 0];
  for (const pose of poses) {
    const squared = squares(pose.subarray(3 * v, 3 * v + 3));
    most = Math.max(most, squared);
    sum += squared;
  }
  return sum > 0 ? Math.sqrt(most / sum) : 0;
}

/** Whether the binary form of the number has an odd number of ones: such signs are those of Hadamard matrices. */
function isOdd(number: number): boolean {
  let ones = 0;
  for (let rest = number; rest > 0; rest >>= 1) ones += rest & 1;
  return ones % 2 === 1;
}
