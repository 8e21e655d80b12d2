/** Converts the material of a thin plate to solver constants, and back. */

import type { SolverConstants } from '../core/core';
import type { SolverMaterial } from './profile';

type Plate = Pick<SolverMaterial, 'young' | 'poisson' | 'thickness'>;

/** Shear modulus and plane-stress Lame constant times the thickness, N/m, and flexural rigidity, N m. */
export function plateConstants({
  young,
  poisson,
  thickness,
}: Plate): Pick<SolverConstants, 'stretch' | 'secondStretch' | 'bend' | 'poisson'> {
  const strip = young / (1 - poisson * poisson);
  return {
    stretch: (young * thickness) / (2 * (1 + poisson)),
    secondStretch: strip * poisson * thickness,
    bend: (strip * thickness * thickness * thickness) / 12,
    poisson,
  };
}

/**
 * The plate that has these constants. With mu = stretch and lambda = secondStretch: lambda / mu = 2 nu / (1 - nu), and
 * bend = mu thickness^2 / (6 (1 - nu)).
 */
export function plateOf({
  stretch,
  secondStretch,
  bend,
}: Pick<SolverConstants, 'stretch' | 'secondStretch' | 'bend'>): Plate {
  const ratio = secondStretch / stretch;
  const poisson = ratio / (2 + ratio);
  const thickness = Math.sqrt((6 * (1 - poisson) * bend) / stretch);
  return { poisson, thickness, young: (2 * (1 + poisson) * stretch) / thickness };
}

/**
 * The stiffness (N/m) of the springs of a net of equilateral triangles that resists stretching as the plate does: a net of
 * springs k has Young's modulus times thickness 2 k / sqrt(3) (Ostoja-Starzewski 2002, Lattice models in micromechanics).
 */
export const springOfPlate = ({ young, thickness }: Plate): number => (Math.sqrt(3) / 2) * young * thickness;

/**
 * The stiffness (N m) of the hinges of a net of equilateral triangles that bends as the plate does: 3 D l^2 / (A1 + A2)
 * (Grinspun et al. 2003) with the area sqrt(3) / 4 l^2 for both triangles, which is the same for any l.
 */
export const hingeOfPlate = (plate: Plate): number => 2 * Math.sqrt(3) * plateConstants(plate).bend;
