/** Which modes of one solution move like those of another one of the same mesh. */

import type { ModeSet } from './core';

type Shapes = Pick<ModeSet, 'shapes' | 'modesPerComponent'>;

/** A modal assurance below this is no likeness: half of the motion is another one. */
const LEAST_ALIKE = 0.5;

/**
 * For each of `modes`, numbers from 1 of `before`, the number of the mode of `after` that moves most like it, every vertex counting the
 * same; null where none does. No two become one: the first of them keeps it. Both solutions are of one mesh.
 */
export function likeModes(before: Shapes, after: Shapes, modes: readonly number[]): (number | null)[] {
  const taken = new Set<number>();
  return modes.map((mode) => {
    const own = shapeOf(before, mode);
    const all = Array.from({ length: after.modesPerComponent }, (_, i) => i + 1);
    const alike = all
      .filter((number) => !taken.has(number))
      .map((number) => ({ number, assurance: assurance(own, shapeOf(after, number)) }));
    const best = alike.reduce((a, b) => (b.assurance > a.assurance ? b : a), { number: 0, assurance: 0 });
    if (best.assurance < LEAST_ALIKE) return null;
    taken.add(best.number);
    return best.number;
  });
}

function shapeOf({ shapes, modesPerComponent }: Shapes, mode: number): Float32Array {
  const length = shapes.length / modesPerComponent;
  return shapes.subarray((mode - 1) * length, mode * length);
}

/** (a . b)^2 / ((a . a) (b . b)), 0..1: the modal assurance criterion with masses left out. */
function assurance(a: Float32Array, b: Float32Array): number {
  let [ab, aa, bb] = [0, 0, 0];
  for (let i = 0; i < a.length; ++i) {
    ab += a[i] * b[i];
    aa += a[i] * a[i];
    bb += b[i] * b[i];
  }
  return aa > 0 && bb > 0 ? (ab * ab) / (aa * bb) : 0;
}
