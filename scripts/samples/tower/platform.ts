// Horizontal slabs of rectangles whose corners may be on a neighbour's side.

import type { CellComplex } from './cells';
import { place } from './profile';

/** [x0, x1, z0, z1] in grid coordinates. */
export type Rectangle = readonly [number, number, number, number];
type PlanPoint = readonly [number, number];

/** The outline of every rectangle, split at its neighbours' corners so that cells share whole faces. */
export function conformingOutlines(rectangles: readonly Rectangle[]): PlanPoint[][] {
  const corners = rectangles.flatMap(([x0, x1, z0, z1]): PlanPoint[] => [
    [x0, z0],
    [x1, z0],
    [x1, z1],
    [x0, z1],
  ]);
  /** The corners strictly between two ends of a side, ascending; `at` is the side's coordinate along the other axis. */
  const along = (axis: 0 | 1, at: number, from: number, to: number) => {
    const onSide = corners.filter((corner) => corner[1 - axis] === at).map((corner) => corner[axis]);
    return [...new Set(onSide)].filter((value) => value > from && value < to).sort((a, b) => a - b);
  };
  return rectangles.map(([x0, x1, z0, z1]) => {
    const [lowX, highX] = [along(0, z0, x0, x1), along(0, z1, x0, x1)];
    const [lowZ, highZ] = [along(1, x0, z0, z1), along(1, x1, z0, z1)];
    return [
      ...[x0, ...lowX].map((x): PlanPoint => [x, z0]),
      ...[z0, ...highZ].map((z): PlanPoint => [x1, z]),
      ...[x1, ...highX.reverse()].map((x): PlanPoint => [x, z1]),
      ...[z1, ...lowZ.reverse()].map((z): PlanPoint => [x0, z]),
    ];
  });
}

/** The slab of `outlines` between two heights. */
export function addSlab(
  complex: CellComplex,
  outlines: readonly (readonly PlanPoint[])[],
  bottom: number,
  top: number,
): void {
  for (const outline of outlines)
    complex.addPrism(
      outline.map(([x, z]) => place(x, bottom, z)),
      outline.map(([x, z]) => place(x, top, z)),
    );
}

/** All cells between adjacent lines. */
export function gridOf(xLines: readonly number[], zLines: readonly number[]): Rectangle[] {
  return xLines
    .slice(1)
    .flatMap((x1, i) => zLines.slice(1).map((z1, j): Rectangle => [xLines[i], x1, zLines[j], z1]));
}

/** A rectangle in each of the four quadrants. */
export const mirrored = ([x0, x1, z0, z1]: Rectangle): Rectangle[] => [
  [x0, x1, z0, z1],
  [-x1, -x0, z0, z1],
  [-x1, -x0, -z1, -z0],
  [x0, x1, -z1, -z0],
];
/** A rectangle that straddles the YZ plane, towards +Z, -Z, +X and -X. */
export const turned = ([x0, x1, z0, z1]: Rectangle): Rectangle[] => [
  [x0, x1, z0, z1],
  [x0, x1, -z1, -z0],
  [z0, z1, x0, x1],
  [-z1, -z0, x0, x1],
];
