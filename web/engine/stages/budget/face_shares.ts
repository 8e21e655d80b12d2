/** How many faces each body of a file may keep. */

import { sum } from '../../core/mesh';

/** Integer shares of `total` in proportion to `weights`; the remainder goes to the largest fractions, of equal ones the first. */
export function shareInProportion(total: number, weights: number[]): number[] {
  const all = sum(weights);
  const exact = weights.map((weight) => (total * weight) / all);
  const shares = exact.map(Math.floor);
  const left = total - sum(shares);
  const byRemainder = exact
    .map((_, i) => i)
    .sort((a, b) => exact[b] - shares[b] - (exact[a] - shares[a]) || a - b);
  for (const i of byRemainder.slice(0, left)) shares[i] += 1;
  return shares;
}

/** The number of faces that a ratio leaves; the small term keeps 0.3 * 10 from becoming 2. */
export const facesByRatio = (ratio: number, faces: number): number => Math.floor(ratio * faces + 1e-9);

/** The requested number of faces: `faces` of the whole file, and `ratio` of its faces; null: not requested. */
export interface FaceTarget {
  faces: number | null;
  ratio: number | null;
}

/** Per body the larger of both targets, since reaching either of them stops; 1 without a target. */
export function targetsOf(counts: number[], { faces, ratio }: FaceTarget): number[] {
  const shares = faces === null ? null : shareInProportion(faces, counts);
  return counts.map((count, i) =>
    Math.max(1, ratio === null ? 0 : facesByRatio(ratio, count), shares ? shares[i] : 0),
  );
}
