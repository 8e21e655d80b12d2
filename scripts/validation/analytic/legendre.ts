/** Legendre polynomials and Gauss quadrature on [-1, 1], as a basis for the Ritz method. */

/** Values and derivatives of one function at quadrature points. */
export interface Sampled {
  value: Float64Array;
  first: Float64Array;
  second: Float64Array;
}

export interface Quadrature {
  points: Float64Array;
  weights: Float64Array;
}

/** P_0 .. P_(count - 1) at x and their first two derivatives: [order][k]. */
function legendreAt(x: number, count: number): number[][] {
  const p = [1, x];
  const first = [0, 1];
  const second = [0, 0];
  for (let k = 1; k + 1 < Math.max(2, count); k++) {
    p.push(((2 * k + 1) * x * p[k] - k * p[k - 1]) / (k + 1));
    first.push(first[k - 1] + (2 * k + 1) * p[k]);
    second.push(second[k - 1] + (2 * k + 1) * first[k]);
  }
  return [p, first, second];
}

/** Gauss quadrature with `count` points, exact for polynomials up to degree 2 count - 1. */
export function gaussLegendre(count: number): Quadrature {
  const points = new Float64Array(count);
  const weights = new Float64Array(count);
  for (let i = 0; i < count; i++) {
    let x = Math.cos((Math.PI * (i + 0.75)) / (count + 0.5));
    let slope = 0;
    for (let step = 0; step < 20; step++) {
      const [p, first] = legendreAt(x, count + 1);
      slope = first[count];
      x -= p[count] / slope;
    }
    points[i] = x;
    weights[i] = 2 / ((1 - x * x) * slope * slope);
  }
  return { points, weights };
}

/** A factor of every basis function that enforces the boundary conditions, with its first two derivatives. */
export type Border = (x: number) => [value: number, first: number, second: number];

export const BORDERS = {
  free: (): [number, number, number] => [1, 0, 0],
  /** value and slope are 0 at x = -1 */
  clampedAtStart: (x: number): [number, number, number] => [(1 + x) ** 2, 2 * (1 + x), 2],
  /** value and slope are 0 at both ends */
  clamped: (x: number): [number, number, number] => [(1 - x * x) ** 2, -4 * x * (1 - x * x), 12 * x * x - 4],
} satisfies Record<string, Border>;

/** border(x) P_k(x) for k < count at quadrature points, scaled to magnitudes of about 1. */
export function legendreBasis(count: number, { points }: Quadrature, border: Border): Sampled[] {
  const sampled = Array.from({ length: count }, () => ({
    value: new Float64Array(points.length),
    first: new Float64Array(points.length),
    second: new Float64Array(points.length),
  }));
  points.forEach((x, at) => {
    const [b, b1, b2] = border(x);
    const [p, p1, p2] = legendreAt(x, count);
    sampled.forEach((f, k) => {
      const scale = Math.sqrt(k + 0.5);
      f.value[at] = scale * b * p[k];
      f.first[at] = scale * (b1 * p[k] + b * p1[k]);
      f.second[at] = scale * (b2 * p[k] + 2 * b1 * p1[k] + b * p2[k]);
    });
  });
  return sampled;
}

/** The integral of a product, from samples at quadrature points. */
export function integrate({ weights }: Quadrature, a: Float64Array, b: Float64Array): number {
  let sum = 0;
  for (let i = 0; i < weights.length; i++) sum += weights[i] * a[i] * b[i];
  return sum;
}
