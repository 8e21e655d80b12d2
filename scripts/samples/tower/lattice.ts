// Braced walls: posts, rings and X braces are prisms through the thickness of a wall.

import { mix, type Point } from '../shape';
import type { CellComplex } from './cells';

/** A point in the plane of a wall: coordinate across it (grid) and height (metres). */
export type WallPoint = readonly [number, number];

export interface Wall {
  /** Maps a wall point on the inner (0) or outer (1) face of the wall to space. */
  place(point: WallPoint, side: 0 | 1): Point;
  from: number;
  to: number;
}

/** The levels of a storey: rings, and between two rings a bay that may be braced. */
export interface Storey {
  rings: { bottom: number; top: number }[];
  /** Per bay: where braces end, as a fraction of its width from the posts and of its height from the rings. */
  gussets: number[];
  /** Numbers of segments of a post between the ends of a bay's braces, and of a brace's arm from end to middle. */
  pieces: { post: number; arm: number };
}

/** The fraction at which an X brace of bars `bar` wide meets the sides of a bay. */
export const gussetOf = (bar: number, width: number, height: number) =>
  (bar * Math.hypot(width, height)) / (2 * width * height);

export function addWallCell(complex: CellComplex, wall: Wall, polygon: readonly WallPoint[]): void {
  complex.addPrism(
    polygon.map((point) => wall.place(point, 0)),
    polygon.map((point) => wall.place(point, 1)),
  );
}

/** The heights at which a post is cut so that rings and braces meet it face to face. */
export function postCuts({ rings, gussets, pieces }: Storey): number[] {
  const cuts = [rings[0].bottom, rings[0].top];
  gussets.forEach((gusset, bay) => {
    const [low, high] = [rings[bay].top, rings[bay + 1].bottom];
    for (let piece = 0; piece <= pieces.post; piece++)
      cuts.push(mix(low, high, mix(gusset, 1 - gusset, piece / pieces.post)));
    cuts.push(high, rings[bay + 1].top);
  });
  return cuts;
}

/** The rings of a wall, split where braces end; `extra` are further corners along the bottom of the lowest ring. */
export function addRings(
  complex: CellComplex,
  wall: Wall,
  storey: Storey,
  extra: readonly number[] = [],
): void {
  const across = (fractions: number[]) => fractions.map((fraction) => mix(wall.from, wall.to, fraction));
  storey.rings.forEach(({ bottom, top }, i) => {
    const [gussetBelow, gussetAbove] = [storey.gussets[i - 1], storey.gussets[i]];
    const below = gussetBelow === undefined ? extra : across([gussetBelow, 1 - gussetBelow]);
    const above = gussetAbove === undefined ? [] : across([1 - gussetAbove, gussetAbove]);
    addWallCell(complex, wall, [
      ...[wall.from, ...below, wall.to].map((u): WallPoint => [u, bottom]),
      ...[wall.to, ...above, wall.from].map((u): WallPoint => [u, top]),
    ]);
  });
}

/** The rings of an open wall, where no braces end. */
export function addPlainRings(complex: CellComplex, wall: Wall, { rings }: Storey): void {
  for (const { bottom, top } of rings)
    addWallCell(complex, wall, [
      [wall.from, bottom],
      [wall.to, bottom],
      [wall.to, top],
      [wall.from, top],
    ]);
}

/** An X brace in every bay: four straight arms, joined in the middle. */
export function addBraces(complex: CellComplex, wall: Wall, { rings, gussets, pieces }: Storey): void {
  gussets.forEach((gusset, bay) => {
    const [low, high] = [rings[bay].top, rings[bay + 1].bottom];
    const at = (across: number, up: number): WallPoint => [
      mix(wall.from, wall.to, across),
      mix(low, high, up),
    ];
    const [near, far] = [0.5 - gusset, 0.5 + gusset];
    addWallCell(complex, wall, [at(0.5, near), at(far, 0.5), at(0.5, far), at(near, 0.5)]);
    for (const isRight of [false, true])
      for (const isUpper of [false, true]) {
        const corner = (across: number, up: number) =>
          at(isRight ? 1 - across : across, isUpper ? 1 - up : up);
        addWallCell(complex, wall, [corner(0, 0), corner(gusset, 0), corner(0, gusset)]);
        const [start, end] = [
          [corner(gusset, 0), corner(0, gusset)],
          [corner(0.5, near), corner(near, 0.5)],
        ].map((cut) => ([0, 1] as const).map((side) => cut.map((point) => wall.place(point, side))));
        addArm(complex, start.flat(), end.flat(), pieces.arm);
      }
  });
}

/** A straight bar between two sections, each of two points on the wall's inner face and two on its outer face. */
function addArm(complex: CellComplex, start: readonly Point[], end: readonly Point[], pieces: number): void {
  const cut = (piece: number) => {
    const [a, b, c, d] = start.map((point, i) => between(point, end[i], piece / pieces));
    return [a, b, d, c];
  };
  for (let piece = 0; piece < pieces; piece++) complex.addPrism(cut(piece), cut(piece + 1));
}

const between = (a: Point, b: Point, fraction: number): Point => [
  mix(a[0], b[0], fraction),
  mix(a[1], b[1], fraction),
  mix(a[2], b[2], fraction),
];
