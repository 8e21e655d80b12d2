/** Thin cylinders and rings with free ends; E = rho = 1, omega in rad/s. */

import { generalisedEigenvalues, zeros } from './eigenvalues';
import { BORDERS, gaussLegendre, integrate, legendreBasis } from './legendre';

export interface Tube {
  radius: number;
  length: number;
  thickness: number;
  poisson: number;
}

/** Rayleigh 1894, section 233: inextensional, equal bending of all cross-sections; n >= 2 waves around. */
export function rayleighTube({ radius, thickness, poisson }: Tube, n: number): number {
  const bending = thickness ** 2 / (12 * (1 - poisson ** 2) * radius ** 4);
  return Math.sqrt((bending * n ** 2 * (n ** 2 - 1) ** 2) / (n ** 2 + 1));
}

/** In-plane bending of a thin ring (Hoppe 1871; Love 1944, section 293) with the cross-section's secondMoment and area. */
export function ringInPlane(radius: number, secondMoment: number, area: number, n: number): number {
  const bending = secondMoment / (area * radius ** 4);
  return Math.sqrt((bending * n ** 2 * (n ** 2 - 1) ** 2) / (n ** 2 + 1));
}

/** Out-of-plane bending with twist of a thin ring (Michell 1889; Love 1944, section 293); `twist` is GJ / EI. */
export function ringOutOfPlane(radius: number, bendingOverArea: number, twist: number, n: number): number {
  const bending = bendingOverArea / radius ** 4;
  return Math.sqrt((bending * n ** 2 * (n ** 2 - 1) ** 2) / (n ** 2 + 1 / twist));
}

const TERMS = 36;

/**
 * The lowest `count` elastic frequencies with n >= 2 waves around, by the Ritz method on the thin-shell theory of Sanders
 * and Koiter (u = U cos nt along the axis, v = V sin nt around, w = W cos nt outwards; Legendre polynomials along the axis).
 */
export function tubeFrequencies(tube: Tube, n: number, count: number): number[] {
  const { radius, length, thickness, poisson } = tube;
  const quadrature = gaussLegendre(TERMS + 4);
  const basis = legendreBasis(TERMS, quadrature, BORDERS.free);
  const slope = 2 / length;
  const membrane = thickness / (1 - poisson ** 2);
  const weights = strainWeights(membrane, (membrane * thickness ** 2) / 12, poisson);
  // Strains [e_x, e_t, gamma, k_x, k_t, 2 k_xt] of the k-th function of each displacement.
  const strains = [0, 1, 2].flatMap((field) =>
    basis.map(({ value, first, second }) => {
      const scaled = (f: Float64Array, factor: number) => f.map((x) => factor * x);
      const none = new Float64Array(value.length);
      const d = scaled(first, slope);
      if (field === 0)
        return [d, none, scaled(value, -n / radius), none, none, scaled(value, n / (2 * radius ** 2))];
      if (field === 1) {
        const around = n / radius;
        return [
          none,
          scaled(value, around),
          d,
          none,
          scaled(value, around / radius),
          scaled(d, 1.5 / radius),
        ];
      }
      const bent = scaled(second, -(slope ** 2));
      const turned = scaled(value, n ** 2 / radius ** 2);
      return [none, scaled(value, 1 / radius), none, bent, turned, scaled(d, (2 * n) / radius)];
    }),
  );
  const stiffness = zeros(3 * TERMS);
  const mass = zeros(3 * TERMS);
  for (let i = 0; i < 3 * TERMS; i++) {
    mass.values[i * 3 * TERMS + i] = thickness;
    for (let j = 0; j < 3 * TERMS; j++)
      for (const [a, b, weight] of weights)
        stiffness.values[i * 3 * TERMS + j] += weight * integrate(quadrature, strains[i][a], strains[j][b]);
  }
  // The basis is orthonormal, so the mass matrix is diagonal; n >= 2 has no rigid motion.
  return generalisedEigenvalues(stiffness, mass)
    .slice(0, count)
    .map((lambda) => Math.sqrt(lambda));
}

/** Triples (a, b, weight) of the energy, which is the sum of weight strain_a strain_b / 2. */
function strainWeights(membrane: number, bending: number, poisson: number): [number, number, number][] {
  return [membrane, bending].flatMap((size, k): [number, number, number][] => {
    const x = 3 * k;
    return [
      [x, x, size],
      [x + 1, x + 1, size],
      [x, x + 1, size * poisson],
      [x + 1, x, size * poisson],
      [x + 2, x + 2, (size * (1 - poisson)) / 2],
    ];
  });
}
