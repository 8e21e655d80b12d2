// The arches at the foot: ribs between two legs, hung from the first platform.

import { mix, type Point } from '../shape';
import type { CellComplex } from './cells';
import { heights, offset, place } from './profile';

/** The heights where the rib leaves the legs, and those of its crown. */
export interface ArchEnds {
  /** Heights of the corners on the leg's post that the end of the rib covers, ascending. */
  spring: readonly number[];
  crownInner: number;
  crownOuter: number;
}

/** Number of hangers along the platform's edge between two legs; each is narrower than the gaps next to it. */
const hangers = 4;
const hangerToGap = 0.5;

/** Grid coordinates of the platform's cells between two legs, from -1 to 1: gaps and hangers in turn. */
export const columnLines = symmetricLines();

function symmetricLines(): number[] {
  const gap = 2 / (hangers * hangerToGap + hangers + 1);
  const half = Array.from({ length: hangers + 1 }, (_, line) => {
    const [gapsBefore, hangersBefore] = [Math.ceil(line / 2), Math.floor(line / 2)];
    return gap * (gapsBefore + hangersBefore * hangerToGap) - 1;
  });
  return [...half, ...half.map((line) => -line).reverse()];
}

type ArchPoint = readonly [number, number];

/** Exponent of the arch: fuller than a parabola (2), but steep enough at its ends to clear the inclined legs. */
const fullness = 2.5;

/** The point of an arch at `fraction` of its half width, -1 to 1. */
const archPoint = ([halfWidth, foot]: ArchPoint, crown: number, fraction: number): ArchPoint => [
  halfWidth * fraction,
  crown - (crown - foot) * Math.abs(fraction) ** fullness,
];

/** Corresponding points along both sides of the rib; `hung` are its segments below hangers. */
function ribPoints({ spring, crownInner, crownOuter }: ArchEnds) {
  const [innerFoot, outerFoot] = [spring[0], spring[spring.length - 1]].map((y): ArchPoint => [
    offset(1, y),
    y,
  ]);
  const half = offset(1, heights.first.bottom);
  const hungFrom = columnLines.slice(1, -1).map((line) => (line * half) / outerFoot[0]);
  const last = hungFrom[hungFrom.length - 1];
  const beside = [0.4, 0.7].map((step) => mix(last, 1, step));
  const fractions = [-1, ...beside.map((f) => -f).reverse(), ...hungFrom, ...beside, 1];
  return {
    inner: fractions.map((fraction) => archPoint(innerFoot, crownInner, fraction)),
    outer: fractions.map((fraction) => archPoint(outerFoot, crownOuter, fraction)),
    hung: hungFrom.slice(1).flatMap((_, i) => (i % 2 === 0 ? [i + beside.length + 1] : [])),
  };
}

/** Adds the four arches, each in the plane of the legs' outer walls. */
export function addArches(complex: CellComplex, ends: ArchEnds): void {
  const { inner, outer, hung } = ribPoints(ends);
  const top = heights.first.bottom;
  const postSide = (side: number) => ends.spring.slice(1, -1).map((y): ArchPoint => [side * offset(1, y), y]);
  const pieces = inner.slice(1).map((_, i) => [inner[i], inner[i + 1], outer[i + 1], outer[i]]);
  pieces[0].push(...postSide(-1).reverse());
  pieces[pieces.length - 1].splice(2, 0, ...postSide(1));
  for (const i of hung) pieces.push([outer[i], outer[i + 1], [outer[i + 1][0], top], [outer[i][0], top]]);
  for (const onSide of sides)
    for (const piece of pieces)
      complex.addPrism(
        piece.map((point) => onSide(point, 3)),
        piece.map((point) => onSide(point, 4)),
      );
}

/** For each of the four sides: maps a point of the arch's plane, on one face of the wall, to space. */
const sides: ((point: ArchPoint, line: number) => Point)[] = [1, -1].flatMap((sign) => [
  ([x, y]: ArchPoint, line: number) => place(x / offset(1, y), y, sign * line),
  ([x, y]: ArchPoint, line: number) => place(sign * line, y, x / offset(1, y)),
]);
