/** Matches the modes of two solutions of one mesh by their shapes. */

import type { ModeSet } from './core';

type Shapes = Pick<ModeSet, 'shapes' | 'modesPerComponent'>;

/** Shapes with a lower MAC do not match: half of the motion differs. */
const MIN_MAC = 0.5;

/**
 * For each of `modes`, numbers from 1 of `before`, the number of the mode of `after` with the highest MAC, every vertex counting the
 * same; null without a match. No mode of `after` is matched twice: the first one gets it. Both solutions must be of one mesh.
 */
export function matchModes(before: Shapes, after: Shapes, modes: readonly number[]): (number | null)[] {
  const taken = new Set<number>();
  return modes.map((mode) => {
    const own = shapeOf(before, mode);
    const all = Array.from({ length: after.modesPerComponent }, (_, i) => i + 1);
    const candidates = all
      .filter((number) => !taken.has(number))
      .map((number) => ({ number, mac: macOf(own, shapeOf(after, number)) }));
    const best = candidates.reduce((a, b) => (b.mac > a.mac ? b : a), { number: 0, mac: 0 });
    if (best.mac < MIN_MAC) return null;
    taken.add(best.number);
    return best.number;
  });
}

function shapeOf({ shapes, modesPerComponent }: Shapes, mode: number): Float32Array {
  const length = shapes.length / modesPerComponent;
  return shapes.subarray((mode - 1) * length, mode * length);
}

/** (a . b)^2 / ((a . a) (b . b)), 0..1: the modal assurance criterion with masses left out. */
function macOf(a: Float32Array, b: Float32Array): number {
  let [ab, aa, bb] = [0, 0, 0];
  for (let i = 0; i < a.length; ++i) {
    ab += a[i] * b[i];
    aa += a[i] * a[i];
    bb += b[i] * b[i];
  }
  return aa > 0 && bb > 0 ? (ab * ab) / (aa * bb) : 0;
}
