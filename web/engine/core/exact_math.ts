/**
 * Lengths and angles that are bit-equal in every JavaScript engine. The language allows Math.hypot, Math.acos and the like
 * to differ between engines, but not sums, products, quotients and Math.sqrt.
 */

export function length3(x: number, y: number, z: number): number {
  return Math.sqrt(x * x + y * y + z * z);
}

/** The angle in radians, with an error below 2e-8. Abramowitz and Stegun, Handbook of Mathematical Functions, 4.4.46. */
export function arcCosine(cosine: number): number {
  const x = Math.min(1, Math.abs(cosine));
  let polynomial = 0;
  for (const coefficient of ARC_COSINE) polynomial = polynomial * x + coefficient;
  const angle = Math.sqrt(1 - x) * polynomial;
  return cosine < 0 ? Math.PI - angle : angle;
}

/** Coefficients a7 down to a0. */
const ARC_COSINE = [
  -0.0012624911, 0.00667009, -0.0170881256, 0.030891881, -0.0501743046, 0.0889789874, -0.2145988016,
  1.570796305,
];
