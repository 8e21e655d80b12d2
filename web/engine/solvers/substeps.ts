/** The substeps that a solver of local constraints needs, from a bound on the fastest vibration of its mesh. */

import type { SolverConstants, SolverModel, TriangleMesh, Tuned } from '../core/core';
import { length3 } from '../core/exact_math';
import { cross, difference, dot } from '../core/vectors';
import type { Vector } from '../core/vectors';
import { vertexCount } from '../core/mesh';

/** Duration of a step in seconds. */
const STEP = 1 / 60;

/** A constraint with its stiffness (N/m over the squared unit of `norms`) and the norm of its gradient at each vertex. */
interface Constraint {
  vertices: number[];
  stiffness: number;
  norms: number[];
}

interface TunedMesh {
  mesh: TriangleMesh;
  model: SolverModel;
  /** tuned */
  constants: SolverConstants;
  tuned: Pick<
    Tuned,
    | 'stretchFactors'
    | 'bendFactors'
    | 'stretchField'
    | 'bendField'
    | 'stretchVertices'
    | 'bendVertices'
    | 'masses'
  >;
}

/**
 * The substeps of a step of 1/60 s at which a substep is no longer than 1 / omega of the fastest vibration, so that explicit steps
 * are stable, and XPBD and VBD lose little. omega^2 is bounded by the largest sum of a row of M^-1 K, in blocks (Gershgorin): the true
 * one is smaller, mostly by less than half. Null if no number is enough, as with a triangle of zero area.
 */
export function substepsNeeded(tunedMesh: TunedMesh): number | null {
  const { mesh, tuned } = tunedMesh;
  const rows = new Float64Array(vertexCount(mesh));
  for (const { vertices, stiffness, norms } of constraintsOf(tunedMesh)) {
    const total = norms.reduce((sum, norm) => sum + norm, 0);
    vertices.forEach((vertex, k) => (rows[vertex] += stiffness * norms[k] * total));
  }
  const largest = rows.reduce(
    (most, row, v) => (tuned.masses[v] > 0 ? Math.max(most, row / tuned.masses[v]) : most),
    0,
  );
  const needed = Math.max(1, Math.ceil(STEP * Math.sqrt(largest)));
  return Number.isFinite(needed) ? needed : null;
}

function* constraintsOf({ mesh, model, constants, tuned }: TunedMesh): Generator<Constraint> {
  const at = pointsOf(mesh, constants.unit);
  const isNet = model.stretch === 'edge-springs';
  const factor = (factors: Float64Array, field: Float64Array, c: number, vertices: number[]): number =>
    (factors[c] ?? 1) * (field.length > 0 ? Math.max(...vertices.map((v) => field[v])) : 1);
  for (const [c, vertices] of groups(tuned.stretchVertices, isNet ? 2 : 3)) {
    const scale = factor(tuned.stretchFactors, tuned.stretchField, c, vertices);
    yield isNet ? spring(vertices, scale * constants.stretch) : membrane(vertices, at, scale, constants);
  }
  const isCross = model.bend === 'cross-springs';
  for (const [c, vertices] of groups(tuned.bendVertices, isCross ? 2 : 4)) {
    const scale = factor(tuned.bendFactors, tuned.bendField, c, vertices);
    yield isCross
      ? spring(vertices, scale * constants.bend)
      : hinge(vertices, at, scale * constants.bend, model);
  }
}

function* groups(flat: Uint32Array, size: number): Generator<[number, number[]]> {
  for (let c = 0; size * c + size <= flat.length; ++c)
    yield [c, [...flat.subarray(size * c, size * c + size)]];
}

const pointsOf =
  ({ positions }: TriangleMesh, unit: number) =>
  (v: number): Vector => [unit * positions[3 * v], unit * positions[3 * v + 1], unit * positions[3 * v + 2]];

const spring = (vertices: number[], stiffness: number): Constraint => ({
  vertices,
  stiffness,
  norms: [1, 1],
});

/** The norms of the gradients of the shape functions are the inverse heights. */
function membrane(
  vertices: number[],
  at: (v: number) => Vector,
  scale: number,
  { stretch, secondStretch }: SolverConstants,
): Constraint {
  const [a, b, c] = vertices.map(at);
  const double = lengthOf(cross(difference(a, b), difference(a, c)));
  const norms = [difference(b, c), difference(c, a), difference(a, b)].map((edge) => lengthOf(edge) / double);
  return { vertices, stiffness: (scale * (secondStretch + 2 * stretch) * double) / 2, norms };
}

/** The angle changes by the inverse height for the opposite corners, and by shares of both for the ends of the edge. */
function hinge(vertices: number[], at: (v: number) => Vector, bend: number, model: SolverModel): Constraint {
  const [i, j, k, l] = vertices.map(at);
  const edge = difference(i, j);
  const length = lengthOf(edge);
  const doubles = [k, l].map((corner) => lengthOf(cross(edge, difference(i, corner))));
  const opposite = doubles.map((double) => length / double);
  const shares = [k, l].map((corner) => dot(difference(i, corner), edge) / (length * length));
  const ends = [0, 1].map((end) =>
    opposite.reduce(
      (sum, norm, side) => sum + norm * Math.abs(end === 0 ? 1 - shares[side] : shares[side]),
      0,
    ),
  );
  return { vertices, stiffness: bend * hingeScale(model, length, doubles), norms: [...ends, ...opposite] };
}

function hingeScale({ bend }: SolverModel, length: number, [first, second]: number[]): number {
  if (bend === 'hinge') return 1;
  if (bend === 'hinge-length') return length;
  return (6 * length * length) / (first + second);
}

const lengthOf = ([x, y, z]: Vector): number => length3(x, y, z);
