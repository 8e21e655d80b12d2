/** Bars of square cross-section; E = rho = 1, omega in rad/s. */

import { signChanges } from './roots';

export interface Bar {
  side: number;
  length: number;
  poisson: number;
}

/** Saint-Venant's torsion constant of a square divided by side^4 (Timoshenko and Goodier 1970, section 109). */
export const SQUARE_TORSION = 0.1406;

/** Shear coefficient (Cowper 1966). */
export const squareShearFactor = (poisson: number) => (10 * (1 + poisson)) / (12 + 11 * poisson);

const shearModulus = (poisson: number) => 1 / (2 * (1 + poisson));

/** The n-th torsional frequency of a bar with free ends; with one end clamped n = 1/2, 3/2, .. */
export function twist({ length, poisson }: Bar, n: number): number {
  return ((n * Math.PI) / length) * Math.sqrt(shearModulus(poisson) * SQUARE_TORSION * 6);
}

/** The n-th longitudinal frequency of a thin bar with free ends; with one end clamped n = 1/2, 3/2, .. */
export const stretch = ({ length }: Bar, n: number) => (n * Math.PI) / length;

/** First bending frequency of the Euler-Bernoulli beam, free or clamped at one end. */
export function eulerBending({ side, length }: Bar, isClamped: boolean): number {
  return ((isClamped ? 1.8751041 : 4.7300407) / length) ** 2 * (side / Math.sqrt(12));
}

/**
 * The lowest `count` bending frequencies of Timoshenko's beam (shear and rotary inertia), with both ends free or one end
 * clamped. y = (deflection, rotation, moment, shear force) satisfies y' = A y; at a frequency the transfer matrix
 * exp(A length) allows moment and force to vanish at the far end.
 */
export function timoshenkoBending(bar: Bar, isClamped: boolean, count: number): number[] {
  const start = isClamped ? 2 : 0; // first of the two unknowns that are not 0 at the near end
  const condition = (omega: number): number => {
    const t = exponential(timoshenkoSystem(bar, omega));
    return t[2][start] * t[3][start + 1] - t[2][start + 1] * t[3][start];
  };
  const first = eulerBending(bar, isClamped);
  return signChanges(condition, 0.05 * first, 20 * count * first, 4000 * count, count);
}

function timoshenkoSystem({ side, length, poisson }: Bar, omega: number): number[][] {
  const area = side ** 2;
  const secondMoment = side ** 4 / 12;
  const shear = squareShearFactor(poisson) * area * shearModulus(poisson);
  return [
    [0, 1, 0, 1 / shear],
    [0, 0, 1 / secondMoment, 0],
    [0, -secondMoment * omega ** 2, 0, -1],
    [-area * omega ** 2, 0, 0, 0],
  ].map((row) => row.map((value) => value * length));
}

/** exp(A), from the Taylor series of A / 2^k squared k times. */
function exponential(matrix: number[][]): number[][] {
  const size = Math.max(...matrix.flat().map(Math.abs));
  const halvings = Math.max(0, Math.ceil(Math.log2(size)) + 4);
  const small = matrix.map((row) => row.map((value) => value / 2 ** halvings));
  const identity = matrix.map((row, i) => row.map((_, j) => Number(i === j)));
  let sum = identity;
  let term = identity;
  for (let k = 1; k <= 14; k++) {
    term = multiply(term, small).map((row) => row.map((value) => value / k));
    sum = sum.map((row, i) => row.map((value, j) => value + term[i][j]));
  }
  for (let k = 0; k < halvings; k++) sum = multiply(sum, sum);
  return sum;
}

function multiply(a: number[][], b: number[][]): number[][] {
  return a.map((row) => b[0].map((_, j) => row.reduce((sum, value, k) => sum + value * b[k][j], 0)));
}
