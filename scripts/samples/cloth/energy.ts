// The energy of a square cloth on a grid: springs along threads and diagonals, bending of a thin plate, and weight.

import type { Objective } from './minimise';

export interface Cloth {
  /** Vertices along a side; vertex i + side * j is on thread i from the left and j from the top. */
  side: number;
  /** Rest length of a cell's side, metres. */
  cell: number;
  /** Resistance to stretch and to shear, N/m. */
  stretch: number;
  shear: number;
  /** Resistance to bending, N m. */
  bending: number;
  /** Mass per area, kg/m2. */
  density: number;
  /** Vertices that do not move. */
  pins: readonly number[];
}

const gravity = 9.81;
/** Stiffness of threads along the border relative to the others: hems are sewn double. */
const hem = 2;

interface Spring {
  a: number;
  b: number;
  rest: number;
  stiffness: number;
}

/** A term with the energy stiffness |d|^2 / 2, where d is a second difference of positions. */
interface Bend {
  /** The difference is a - b + c - d: along a thread b equals d; over a cell it is the twist. */
  a: number;
  b: number;
  c: number;
  d: number;
  stiffness: number;
}

/** The energy in joules at positions x[3 v + axis]; the gradient of pinned vertices is 0. */
export function clothEnergy(cloth: Cloth): Objective {
  const springs = springsOf(cloth);
  const bends = bendsOf(cloth);
  const weights = weightsOf(cloth);
  return (x, gradient) => {
    gradient.fill(0);
    let energy = 0;
    for (const spring of springs) energy += addSpring(spring, x, gradient);
    for (const bend of bends) energy += addBend(bend, x, gradient);
    for (let v = 0; v < weights.length; v++) {
      energy += weights[v] * x[3 * v + 1];
      gradient[3 * v + 1] += weights[v];
    }
    for (const pin of cloth.pins) gradient.fill(0, 3 * pin, 3 * pin + 3);
    return energy;
  };
}

function addSpring({ a, b, rest, stiffness }: Spring, x: Float64Array, gradient: Float64Array): number {
  const dx = x[3 * b] - x[3 * a];
  const dy = x[3 * b + 1] - x[3 * a + 1];
  const dz = x[3 * b + 2] - x[3 * a + 2];
  const length = Math.sqrt(dx * dx + dy * dy + dz * dz);
  const excess = length - rest;
  const pull = (stiffness * excess) / length;
  gradient[3 * a] -= pull * dx;
  gradient[3 * a + 1] -= pull * dy;
  gradient[3 * a + 2] -= pull * dz;
  gradient[3 * b] += pull * dx;
  gradient[3 * b + 1] += pull * dy;
  gradient[3 * b + 2] += pull * dz;
  return 0.5 * stiffness * excess * excess;
}

function addBend({ a, b, c, d, stiffness }: Bend, x: Float64Array, gradient: Float64Array): number {
  let squares = 0;
  for (let axis = 0; axis < 3; axis++) {
    const difference = x[3 * a + axis] - x[3 * b + axis] + x[3 * c + axis] - x[3 * d + axis];
    const force = stiffness * difference;
    squares += difference * difference;
    gradient[3 * a + axis] += force;
    gradient[3 * b + axis] -= force;
    gradient[3 * c + axis] += force;
    gradient[3 * d + axis] -= force;
  }
  return 0.5 * stiffness * squares;
}

function springsOf({ side, cell, stretch, shear }: Cloth): Spring[] {
  const springs: Spring[] = [];
  const add = (a: number, b: number, rest: number, stiffness: number) =>
    springs.push({ a, b, rest, stiffness });
  for (let j = 0; j < side; j++)
    for (let i = 0; i < side; i++) {
      const v = i + side * j;
      const [ofColumn, ofRow] = [i, j].map((k) => stretch * (k === 0 || k === side - 1 ? hem : 1));
      if (i + 1 < side) add(v, v + 1, cell, ofRow);
      if (j + 1 < side) add(v, v + side, cell, ofColumn);
      if (i + 1 === side || j + 1 === side) continue;
      add(v, v + side + 1, cell * Math.SQRT2, shear);
      add(v + 1, v + side, cell * Math.SQRT2, shear);
    }
  return springs;
}

function bendsOf({ side, cell, bending }: Cloth): Bend[] {
  const stiffness = bending / (cell * cell);
  const bends: Bend[] = [];
  for (let j = 0; j < side; j++)
    for (let i = 0; i < side; i++) {
      const v = i + side * j;
      for (const [k, step] of [
        [i, 1],
        [j, side],
      ])
        if (k > 0 && k + 1 < side) bends.push({ a: v - step, b: v, c: v + step, d: v, stiffness });
      if (i + 1 < side && j + 1 < side)
        bends.push({ a: v, b: v + 1, c: v + side + 1, d: v + side, stiffness: 2 * stiffness });
    }
  return bends;
}

/** The weight of each vertex in newtons: a quarter of every cell around it. */
function weightsOf({ side, cell, density }: Cloth): Float64Array {
  const weights = new Float64Array(side * side);
  const quarter = (density * gravity * cell * cell) / 4;
  for (let j = 0; j + 1 < side; j++)
    for (let i = 0; i + 1 < side; i++)
      for (const v of [0, 1, side, side + 1]) weights[i + side * j + v] += quarter;
  return weights;
}
