/** Whole shares of `total` in proportion to `weights`; what is left over goes to the largest remainders, lowest first. */
export function shareInProportion(total: number, weights: number[]): number[] {
  const sum = weights.reduce((a, b) => a + b, 0);
  const exact = weights.map((weight) => (total * weight) / sum);
  const shares = exact.map(Math.floor);
  const left = total - shares.reduce((a, b) => a + b, 0);
  const byRemainder = exact
    .map((_, i) => i)
    .sort((a, b) => exact[b] - shares[b] - (exact[a] - shares[a]) || a - b);
  for (const i of byRemainder.slice(0, left)) shares[i] += 1;
  return shares;
}

/** The faces that a ratio leaves of so many; the sum keeps 0.3 * 10 from becoming 2. */
export const facesByRatio = (ratio: number, faces: number): number => Math.floor(ratio * faces + 1e-9);
