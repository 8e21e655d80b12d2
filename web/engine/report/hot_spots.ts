/** Whether modes strain the same regions: the hot spots of each mode, and their overlap. */

/** Faces of at least this strain rank are hot: the most strained tenth of their part. A float32. */
export const HOT_RANK = Math.fround(0.9);

/** Two modes whose hot faces overlap by less than this share strain different regions. */
export const DIFFERENT_BELOW = 0.25;

/** Per triangle 1 where it is hot; `rank` as StrainGuidance gives it for one mode. */
export function hotFaces(rank: Float32Array): Uint8Array {
  // Loops here and below, because a call for each of a million faces would take longer than finding the modes.
  const hot = new Uint8Array(rank.length);
  for (let face = 0; face < rank.length; face++) hot[face] = rank[face] >= HOT_RANK ? 1 : 0;
  return hot;
}

/**
 * shared[a * hot.length + b]: the part, in [0, 1], of the hot faces of ordinal a that are hot in ordinal b too; 0 where a has
 * none. `hot`: one array per ordinal, all of the same length.
 */
export function sharedHotSpots(hot: Uint8Array[]): Float32Array {
  const shared = new Float32Array(hot.length * hot.length);
  hot.forEach((a, i) => {
    const faces = indicesOf(a);
    hot.forEach((b, j) => {
      let common = 0;
      for (const face of faces) common += b[face];
      shared[i * hot.length + j] = faces.length > 0 ? common / faces.length : 0;
    });
  });
  return shared;
}

/** The indices of the entries that are 1. */
function indicesOf(isHot: Uint8Array): number[] {
  const indices: number[] = [];
  for (let i = 0; i < isHot.length; i++) if (isHot[i] === 1) indices.push(i);
  return indices;
}

export interface ModePair {
  /** modes from 1, first < second */
  first: number;
  second: number;
  /** the overlap of their hot faces, in [0, 1]: the larger of the two shares */
  common: number;
}

/** Pairs among `modes` (numbers from 1) that strain different regions, those with least in common first. */
export function differentPairs(shared: Float32Array, modesPerComponent: number, modes: number[]): ModePair[] {
  const known = modes.filter((mode) => mode <= modesPerComponent).sort((a, b) => a - b);
  const part = (a: number, b: number) => shared[(a - 1) * modesPerComponent + b - 1];
  const pairs = known.flatMap((first, i) =>
    known
      .slice(i + 1)
      .map((second) => ({ first, second, common: Math.max(part(first, second), part(second, first)) })),
  );
  return pairs
    .filter(({ common }) => common < DIFFERENT_BELOW)
    .sort((a, b) => a.common - b.common || a.first - b.first || a.second - b.second);
}

/** One sentence on guiding modes that strain different regions; '' where none do. */
export function describeHotSpots(pairs: ModePair[]): string {
  if (pairs.length === 0) return '';
  const [{ first, second, common }, ...others] = pairs;
  const more = others.length === 1 ? '1 other pair does' : `${others.length} other pairs do`;
  const end = others.length === 0 ? 'faces stay at both' : `${more}, too, and faces stay at all of them`;
  return `Modes ${first} and ${second} strain different places (${Math.floor(100 * common)} % in common): ${end}.`;
}
