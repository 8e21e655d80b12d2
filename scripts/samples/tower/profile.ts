// The tower's proportions: heights and widths in metres, and the map from its grid to space.

import type { Point } from '../shape';

export const heights = {
  plinth: 0.05,
  first: { bottom: 0.53, top: 0.605, lip: 0.562 },
  second: { bottom: 1.06, top: 1.12, lip: 1.086 },
  third: { bottom: 2.42, top: 2.475, lip: 2.447 },
} as const;

/** Distance of the outer faces from the axis, which defines the tower's silhouette. */
const halfWidth = (y: number) => 0.028 + 0.54 * Math.exp(-1.17 * y);
const legWidth = (y: number) => 0.085 + 0.155 * Math.exp(-1.3 * y);

/** Width of posts, rings and walls. */
export const strutWidth = (y: number) => 0.0105 + 0.0245 * Math.exp(-0.85 * y);
const overhang = (y: number) => 0.014 + 0.026 * Math.exp(-0.9 * y);

/** Distances of the grid's lines 0 to 5 from the axis, below the second platform's top. */
function legLines(y: number): number[] {
  const [outer, inner] = [halfWidth(y), halfWidth(y) - legWidth(y)];
  const strut = strutWidth(y);
  return [0, inner, inner + strut, outer - strut, outer, outer + overhang(y)];
}

/** The same above, where the four legs have merged into one shaft and the inner lines only taper. */
function shaftLines(y: number): number[] {
  const base = legLines(heights.second.top);
  const outer = halfWidth(y);
  const inside = outer - strutWidth(y);
  const taper = inside / base[3];
  return [0, base[1] * taper, base[2] * taper, inside, outer, outer + overhang(y)];
}

/**
 * Distance of grid coordinate `s` from the axis at height `y`. Along each horizontal axis |s| is 1 at a leg's inner
 * face, 2 and 3 at the inner sides of its two walls, 4 at its outer face and 5 at the platforms' edge.
 */
export function offset(s: number, y: number): number {
  const lines = y > heights.second.top ? shaftLines(y) : legLines(y);
  const line = Math.min(4, Math.floor(Math.abs(s)));
  const distance = lines[line] + (lines[line + 1] - lines[line]) * (Math.abs(s) - line);
  return Math.sign(s) * distance;
}

/** The point at grid coordinates (s, y, s). */
export const place = (sx: number, y: number, sz: number): Point => [offset(sx, y), y, offset(sz, y)];
