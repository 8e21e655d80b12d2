// A lattice tower in the spirit of Eiffel's: four curved legs, arches, three platforms, a shaft and a spire.

import { mix, standing, type Point, type Shape } from '../shape';
import { addArches, columnLines } from './arch';
import { CellComplex } from './cells';
import { addBraces, addPlainRings, addRings, gussetOf, postCuts, type Storey, type Wall } from './lattice';
import { addSlab, conformingOutlines, gridOf, mirrored, turned, type Rectangle } from './platform';
import { heights, offset, place, strutWidth } from './profile';

/** Width of the braces relative to that of posts and rings. */
const barRatio = 0.8;

/** The closed skin of the tower, about 3 m high. */
export function makeTower(): Shape {
  const complex = new CellComplex();
  const legOpening = (y: number) => offset(3, y) - offset(2, y);
  const foot = storey([heights.plinth, heights.first.bottom], [0.52], legOpening, { post: 2, arm: 1 });
  const waist = storey([heights.first.top, heights.second.bottom], [0.54], legOpening, { post: 1, arm: 1 });
  const shaftOpening = (y: number) => 2 * offset(3, y);
  const shaft = storey([heights.second.top, heights.third.bottom], [0.28, 0.51, 0.7, 0.86], shaftOpening, {
    post: 2,
    arm: 2,
  });
  addPlinths(complex);
  addLegs(complex, foot);
  addArches(complex, { spring: postCuts(foot).slice(4, 7), crownInner: 0.435, crownOuter: 0.472 });
  addPlatform(complex, heights.first, openPlan(columnLines));
  addLegs(complex, waist);
  addPlatform(complex, heights.second, openPlan([-1, 1]));
  addShaft(complex, shaft);
  addPlatform(complex, heights.third, gridOf([-5, -4, -3, 3, 4, 5], [-5, -4, -3, 3, 4, 5]));
  addSpire(complex);
  const { points, triangles } = complex.skin();
  return standing(points, triangles);
}

/** A storey between two heights: rings at both and at `fractions` between; posts are `opening` apart. */
function storey(
  [bottom, top]: number[],
  fractions: number[],
  opening: (y: number) => number,
  pieces: Storey['pieces'],
): Storey {
  const last = top - strutWidth(top);
  const bottoms = [0, ...fractions, 1].map((fraction) => mix(bottom, last, fraction));
  const rings = bottoms.map((y, i) => ({ bottom: y, top: i + 1 < bottoms.length ? y + strutWidth(y) : top }));
  const gussets = rings.slice(1).map((ring, i) => {
    const [low, high] = [rings[i].top, ring.bottom];
    const middle = (low + high) / 2;
    return gussetOf(barRatio * strutWidth(middle), opening(middle), high - low);
  });
  return { rings, gussets, pieces };
}

/** Four legs: square tubes of four posts with braced outer walls; their inner walls have only rings. */
function addLegs(complex: CellComplex, floor: Storey): void {
  for (const [qx, qz] of [
    [1, 1],
    [-1, 1],
    [-1, -1],
    [1, -1],
  ]) {
    const acrossZ = (inner: number, outer: number): Wall => ({
      place: ([u, y], side) => place(qx * (side ? outer : inner), y, qz * u),
      from: 2,
      to: 3,
    });
    const acrossX = (inner: number, outer: number): Wall => ({
      place: ([u, y], side) => place(qx * u, y, qz * (side ? outer : inner)),
      from: 2,
      to: 3,
    });
    for (const wall of [acrossX(3, 4), acrossZ(3, 4)]) {
      addRings(complex, wall, floor);
      addBraces(complex, wall, floor);
    }
    for (const wall of [acrossX(1, 2), acrossZ(1, 2)]) addPlainRings(complex, wall, floor);
    for (const x of [1, 3])
      for (const z of [1, 3]) addPost(complex, floor, [qx * x, qx * (x + 1), qz * z, qz * (z + 1)]);
  }
}

function addPost(complex: CellComplex, floor: Storey, [x0, x1, z0, z1]: Rectangle): void {
  const cuts = postCuts(floor);
  const loopAt = (y: number) => [place(x0, y, z0), place(x1, y, z0), place(x1, y, z1), place(x0, y, z1)];
  for (let i = 1; i < cuts.length; i++) complex.addPrism(loopAt(cuts[i - 1]), loopAt(cuts[i]));
}

/** One tube of four posts and four braced walls, from the second platform to the third. */
function addShaft(complex: CellComplex, floor: Storey): void {
  const base = floor.rings[0].bottom;
  // Walls are straight from -3 to 3; the lowest ring has the corners of the platform's cells below it.
  const across = (u: number, y: number) => (u / 3) * offset(3, y);
  const corners = [-2, -1, 1, 2].map((line) => (3 * offset(line, base)) / offset(3, base));
  for (const sign of [1, -1]) {
    const depth = (side: 0 | 1, y: number) => sign * offset(3 + side, y);
    const walls: Wall[] = [
      { place: ([u, y], side) => [across(u, y), y, depth(side, y)], from: -3, to: 3 },
      { place: ([u, y], side) => [depth(side, y), y, across(u, y)], from: -3, to: 3 },
    ];
    for (const wall of walls) {
      addRings(complex, wall, floor, corners);
      addBraces(complex, wall, floor);
    }
    for (const other of [1, -1]) addPost(complex, floor, [sign * 3, sign * 4, other * 3, other * 4]);
  }
}

/** A block with vertical sides under each leg. */
function addPlinths(complex: CellComplex): void {
  const [inner, outer] = [0.95, 4.5];
  const under: Rectangle[] = gridOf([1, 2, 3, 4], [1, 2, 3, 4]);
  const border: Rectangle[] = [
    [inner, outer, inner, 1],
    [inner, outer, 4, outer],
    [inner, 1, 1, 4],
    [4, outer, 1, 4],
  ];
  for (const outline of conformingOutlines([...under, ...border].flatMap(mirrored))) {
    const top = outline.map(([x, z]) => place(x, heights.plinth, z));
    const bottom = top.map(([x, , z]): Point => [x, 0, z]);
    complex.addPrism(bottom, top);
  }
}

/** The cells of a platform with an open middle; `lines` divide its strips between the legs. */
function openPlan(lines: readonly number[]): Rectangle[] {
  const corner = gridOf([1, 2, 3, 4, 5], [1, 2, 3, 4, 5]).flatMap(mirrored);
  const strips = gridOf(lines, [1, 3, 4, 5]).flatMap(turned);
  return [...corner, ...strips];
}

/** A platform of two slabs; the upper one extends to line 5. */
function addPlatform(
  complex: CellComplex,
  { bottom, lip, top }: { bottom: number; lip: number; top: number },
  plan: Rectangle[],
): void {
  const outlines = conformingOutlines(plan);
  const isUnderLegs = (rectangle: Rectangle) => rectangle.every((line) => Math.abs(line) <= 4);
  addSlab(
    complex,
    outlines.filter((_, i) => isUnderLegs(plan[i])),
    bottom,
    lip,
  );
  addSlab(complex, outlines, lip, top);
}

/** The cabin on the third platform, its roof and the mast, as square loops on top of each other. */
function addSpire(complex: CellComplex): void {
  const base = heights.third.top;
  const cabin = offset(3, base);
  const loops = [
    [cabin, base],
    [cabin * 0.96, base + 0.07],
    [0.013, base + 0.13],
    ...[0.2, 0.27, 0.34, 0.4, 0.45, 0.5].map((rise) => [
      mix(0.013, 0.004, (rise - 0.13) / 0.37),
      base + rise,
    ]),
  ];
  const square = ([half, y]: number[]): Point[] => [
    [-half, y, -half],
    [half, y, -half],
    [half, y, half],
    [-half, y, half],
  ];
  for (let i = 1; i < loops.length; i++) complex.addPrism(square(loops[i - 1]), square(loops[i]));
}
