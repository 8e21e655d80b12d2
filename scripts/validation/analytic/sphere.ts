/** Frequencies omega R / c_T of a free elastic sphere (Lamb 1882), with shear wave speed c_T = sqrt(G / rho). */

import { signChanges } from './roots';

const HIGHEST = 12;

/** Spherical Bessel function j_l(x), x > 0, by upward recurrence, which is accurate only for l not much above x. */
function bessel(l: number, x: number): number {
  let [low, high] = [Math.sin(x) / x, Math.sin(x) / x ** 2 - Math.cos(x) / x];
  if (l === 0) return low;
  for (let k = 1; k < l; k++) [low, high] = [high, ((2 * k + 1) / x) * high - low];
  return high;
}

/** c_T / c_L. */
const speedRatio = (poisson: number) => Math.sqrt((1 - 2 * poisson) / (2 * (1 - poisson)));

/** Torsional frequencies of degree l >= 1, each with multiplicity 2 l + 1. */
export function torsional(l: number, count: number): number[] {
  const condition = (x: number) => (l - 1) * bessel(l, x) - x * bessel(l + 1, x);
  return signChanges(condition, 0.5, HIGHEST, 2000, count);
}

/** Breathing frequencies of degree 0, each with multiplicity 1. */
export function breathing(poisson: number, count: number): number[] {
  const condition = (x: number): number => {
    const y = speedRatio(poisson) * x;
    return (1 - x ** 2 / 4) * Math.sin(y) - y * Math.cos(y);
  };
  return signChanges(condition, 0.5, HIGHEST, 2000, count);
}

/** Spheroidal frequencies of degree l >= 1, from the determinant of two boundary conditions; multiplicity 2 l + 1. */
export function spheroidal(l: number, poisson: number, count: number): number[] {
  const condition = (x: number): number => {
    const y = speedRatio(poisson) * x;
    const normalLong = (l * l - l - x ** 2 / 2) * bessel(l, y) + 2 * y * bessel(l + 1, y);
    const normalShear = l * (l + 1) * ((l - 1) * bessel(l, x) - x * bessel(l + 1, x));
    const tangentLong = (l - 1) * bessel(l, y) - y * bessel(l + 1, y);
    const tangentShear = (l * l - 1 - x ** 2 / 2) * bessel(l, x) + x * bessel(l + 1, x);
    return normalLong * tangentShear - normalShear * tangentLong;
  };
  return signChanges(condition, 0.5, HIGHEST, 2000, count);
}
