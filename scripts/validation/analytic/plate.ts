/** Frequency parameters omega a^2 sqrt(rho h / D) of thin square plates (Kirchhoff). */

import { generalisedEigenvalues, zeros } from './eigenvalues';
import { BORDERS, gaussLegendre, integrate, legendreBasis } from './legendre';
import type { Border, Sampled } from './legendre';

export type PlateSupport = 'free' | 'clamped' | 'cantilever';

const TERMS = 12;

/**
 * The lowest `count` frequency parameters by the Ritz method with 12 x 12 Legendre polynomials: upper bounds, converged to
 * about four digits (most slowly at the corners of a cantilever). A cantilever is clamped along one side.
 */
export function plateFrequencies(support: PlateSupport, poisson: number, count: number): number[] {
  const across = support === 'clamped' ? BORDERS.clamped : BORDERS.free;
  const along = support === 'cantilever' ? BORDERS.clampedAtStart : across;
  const x = integrals(along);
  const y = integrals(across);
  const stiffness = zeros(TERMS * TERMS);
  const mass = zeros(TERMS * TERMS);
  for (let row = 0; row < stiffness.size; row++)
    for (let column = 0; column < stiffness.size; column++) {
      const [i, j] = [Math.floor(row / TERMS), row % TERMS];
      const [k, l] = [Math.floor(column / TERMS), column % TERMS];
      const at = row * stiffness.size + column;
      stiffness.values[at] =
        x.second[i][k] * y.value[j][l] +
        x.value[i][k] * y.second[j][l] +
        poisson * (x.mixed[i][k] * y.mixed[l][j] + x.mixed[k][i] * y.mixed[j][l]) +
        2 * (1 - poisson) * x.first[i][k] * y.first[j][l];
      mass.values[at] = x.value[i][k] * y.value[j][l];
    }
  const rigid = support === 'free' ? 3 : 0;
  const lambda = generalisedEigenvalues(stiffness, mass).slice(rigid, rigid + count);
  return lambda.map((value) => 4 * Math.sqrt(value)); // the side is 2 on [-1, 1]
}

/** [i][k]: the integrals of f_i'' f_k'', f_i'' f_k, f_i' f_k' and f_i f_k. */
function integrals(border: Border) {
  const quadrature = gaussLegendre(TERMS + 8);
  const basis = legendreBasis(TERMS, quadrature, border);
  const table = (left: keyof Sampled, right: keyof Sampled) =>
    basis.map((f) => basis.map((g) => integrate(quadrature, f[left], g[right])));
  return {
    second: table('second', 'second'),
    mixed: table('second', 'value'),
    first: table('first', 'first'),
    value: table('value', 'value'),
  };
}

/** All sides simply supported: pi^2 (m^2 + n^2), ascending. */
export function supportedPlateFrequencies(count: number): number[] {
  const all: number[] = [];
  for (let m = 1; m <= count; m++) for (let n = 1; n <= count; n++) all.push(Math.PI ** 2 * (m * m + n * n));
  return all.sort((a, b) => a - b).slice(0, count);
}
