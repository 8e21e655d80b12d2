/** The scale of colours by curvature. */

const scales = new WeakMap<Float32Array, number>();

/** The curvature that gets the brightest colour: the 98th percentile, so that a single spike does not hide the rest. */
export function curvatureScale(curvature: Float32Array): number {
  const known = scales.get(curvature);
  if (known !== undefined) return known;
  const sorted = Float32Array.from(curvature).sort();
  const scale = sorted[Math.floor(0.98 * (sorted.length - 1))] || sorted[sorted.length - 1] || 1;
  scales.set(curvature, scale);
  return scale;
}
