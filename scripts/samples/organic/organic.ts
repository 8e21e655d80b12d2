import { mix, standing, type Shape } from '../shape';
import { meltedLimbs, type Limb } from './field';
import { remesh } from './remesh';
import { marchTetrahedra } from './marching-tetrahedra';

const height = 1.5;
/** Total rotation of a limb about the axis from foot to crown, radians. */
const twist = 2.4;
/** The slope of the crown towards +X, and the distance of its middle from the axis of the foot. */
const crownTilt = 0.32;
const crownShift = 0.1;

/** The rotation about Y that turns its best side to the front, +Z. */
const bestSide = 2.27;

/** A knot of a winding limb: `turn` is the limb's angle at the foot; `rise` is 0 at the foot and 1 at the crown. */
function windingKnot(turn: number, rise: number, belly: number, radius: number): number[] {
  const angle = turn + twist * rise;
  const distance = mix(0.12, 0.25, rise) + belly * Math.sin(Math.PI * rise);
  const x = distance * Math.cos(angle);
  const y = height * rise + rise ** 3 * crownTilt * x;
  return [x + crownShift * Math.sin((Math.PI / 2) * rise), y, distance * Math.sin(angle), radius];
}

/** A limb that winds from the foot to the crown and is slender in the middle; `belly` is how far it bulges. */
function windingLimb(turn: number, belly: number, thickness: number): Limb {
  const knots = Array.from({ length: 13 }, (_, i) => {
    const rise = i / 12;
    const radius = thickness * (mix(0.15, 0.07, rise) - 0.035 * Math.sin(Math.PI * rise));
    return windingKnot(turn, rise, belly, radius);
  });
  return { knots, isClosed: false };
}

/** A slender bridge between two winding limbs. */
function bridge(from: number[], to: number[], sag: number): Limb {
  const knots = Array.from({ length: 9 }, (_, i) => {
    const along = i / 8;
    const slack = Math.sin(Math.PI * along);
    const [x, y, z, radius] = from.map((value, k) => mix(value, to[k], along));
    return [x * (1 + 0.35 * slack), y - sag * slack, z * (1 + 0.35 * slack), radius * (1 - 0.25 * slack)];
  });
  return { knots, isClosed: false };
}

/** The crown: a tilted ring of uneven thickness. */
function crown(): Limb {
  const knots = Array.from({ length: 16 }, (_, i) => {
    const angle = (i * Math.PI) / 8;
    const [x, z] = [0.29 * Math.cos(angle), 0.26 * Math.sin(angle)];
    return [x + crownShift, height + crownTilt * x, z, 0.09 + 0.025 * Math.cos(angle - 0.6)];
  });
  return { knots, isClosed: true };
}

/** A broad foot. */
const foot: Limb = {
  knots: [
    [-0.06, -0.02, 0.02, 0.2],
    [0.02, -0.03, 0, 0.23],
    [0.1, -0.02, -0.03, 0.19],
  ],
  isClosed: false,
};

/** A smooth closed sculpture with holes, about 8,000 nearly equilateral triangles, free of sharp features. */
export function makeOrganic(): Shape {
  const limbs = [
    foot,
    windingLimb(0.2, 0.26, 1.1),
    windingLimb(2.3, 0.34, 0.9),
    windingLimb(4.3, 0.2, 1),
    bridge(windingKnot(0.2, 0.62, 0.26, 0.08), windingKnot(2.3, 0.42, 0.34, 0.08), 0.04),
    bridge(windingKnot(4.3, 0.4, 0.2, 0.075), windingKnot(6.48, 0.7, 0.26, 0.075), -0.05),
    crown(),
  ];
  const field = meltedLimbs(limbs, 0.06);
  const net = marchTetrahedra(field, { low: [-1, -0.4, -1], high: [1, 2.1, 1] }, 0.05);
  const { points, triangles } = remesh(net, field, { edge: 0.0375, rounds: 6 });
  return standing(turned(points, bestSide), triangles);
}

/** Points rotated about the Y axis. */
function turned(points: readonly number[], angle: number): number[] {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  return points.map((value, i) => {
    if (i % 3 === 0) return c * value + s * points[i + 2];
    return i % 3 === 1 ? value : c * value - s * points[i - 2];
  });
}
