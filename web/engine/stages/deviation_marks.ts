/** Where along a history the surface has moved by so much: marks for the slider that replays it. */

/** Per cent of the diagonal. */
export const MARKED_DEVIATIONS = [0.1, 0.5, 1];

export interface DeviationMark {
  /** % of the diagonal */
  deviation: number;
  /** fewest faces found whose deviation is at most that */
  faces: number;
}

/** Two numbers of faces this close are one place on the slider. */
const CLOSE = 1.02;

/**
 * The fewest faces, to 2 %, that stay within each deviation, largest number of faces first; deviations that the floor of
 * the history stays within have no mark. `deviationAt` may be asked for any number of faces from `floor` to `total`, and is
 * asked for each at most once; it should fall with more faces, and where it does not, a mark is at one of its crossings.
 */
export function markDeviations(
  deviationAt: (faces: number) => number,
  { floor, total, deviations = MARKED_DEVIATIONS }: { floor: number; total: number; deviations?: number[] },
): DeviationMark[] {
  const known = new Map([[total, 0]]);
  const at = (faces: number): number => {
    if (!known.has(faces)) known.set(faces, deviationAt(faces));
    return known.get(faces)!;
  };
  if (total <= floor) return [];
  return deviations
    .filter((deviation) => at(floor) > deviation)
    .map((deviation) => ({ deviation, faces: crossing(at, known, { floor, total, deviation }) }));
}

/** Halves the ratio between a number of faces that is too far off and one that is not, from what is known already. */
function crossing(
  at: (faces: number) => number,
  known: Map<number, number>,
  { floor, total, deviation }: { floor: number; total: number; deviation: number },
): number {
  let [low, high] = [floor, total];
  for (const [faces, value] of [...known].sort(([a], [b]) => a - b))
    if (value > deviation) low = Math.max(low, faces);
  for (const [faces, value] of known) if (value <= deviation && faces > low) high = Math.min(high, faces);
  while (high > CLOSE * low && high > low + 1) {
    const middle = Math.min(high - 1, Math.max(low + 1, Math.round(Math.sqrt(low * high))));
    if (at(middle) > deviation) low = middle;
    else high = middle;
  }
  return high;
}
