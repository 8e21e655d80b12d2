// The implicit surface of the organic shape: limbs along curves, blended smoothly.

/** A limb is a smooth curve through knots [x, y, z, radius], metres; a closed one returns to its first knot. */
export interface Limb {
  knots: readonly (readonly number[])[];
  isClosed: boolean;
}

export interface FieldSample {
  /** Approximate signed distance, metres, negative inside. */
  value: number;
  gradient: [number, number, number];
}

export type Field = (x: number, y: number, z: number) => FieldSample;

const piecesPerKnot = 3;

/** Blends limbs over about `blend` metres: -k log sum exp(-d / k), smooth and independent of their order. */
export function meltedLimbs(limbs: readonly Limb[], blend: number): Field {
  const parts = limbs.map(sampledLimb);
  return (x, y, z) => {
    const samples = parts.map((cones) => distanceToCones(cones, x, y, z));
    const nearest = Math.min(...samples.map((sample) => sample.value));
    const gradient: [number, number, number] = [0, 0, 0];
    let sum = 0;
    for (const sample of samples) {
      const weight = Math.exp((nearest - sample.value) / blend);
      sum += weight;
      for (let axis = 0; axis < 3; axis++) gradient[axis] += weight * sample.gradient[axis];
    }
    return {
      value: nearest - blend * Math.log(sum),
      gradient: [gradient[0] / sum, gradient[1] / sum, gradient[2] / sum],
    };
  };
}

/** The limb's cones: cones[9 * i + (start x, y, z, radius; step x, y, z, radius; 1 / squared length)]. */
function sampledLimb({ knots, isClosed }: Limb): Float64Array {
  const count = knots.length;
  const knot = (i: number) => knots[isClosed ? (i + count) % count : Math.min(count - 1, Math.max(0, i))];
  const pieces = (isClosed ? count : count - 1) * piecesPerKnot;
  const points = Array.from({ length: pieces + 1 }, (_, i) => {
    const span = Math.min(pieces / piecesPerKnot - 1, Math.floor(i / piecesPerKnot));
    const around = [knot(span - 1), knot(span), knot(span + 1), knot(span + 2)];
    const along = i / piecesPerKnot - span;
    const coordinate = (k: number) =>
      catmullRom(
        around.map((values) => values[k]),
        along,
      );
    return [0, 1, 2, 3].map(coordinate);
  });
  const cones = new Float64Array(9 * pieces);
  for (let i = 0; i < pieces; i++) {
    const step = points[i + 1].map((value, k) => value - points[i][k]);
    cones.set([...points[i], ...step, 1 / (step[0] ** 2 + step[1] ** 2 + step[2] ** 2)], 9 * i);
  }
  return cones;
}

/** The cubic from b at 0 to c at 1 whose slopes there are those of the chords a-c and b-d (Catmull-Rom). */
function catmullRom([a, b, c, d]: readonly number[], t: number): number {
  return b + 0.5 * t * (c - a + t * (2 * a - 5 * b + 4 * c - d + t * (3 * (b - c) + d - a)));
}

/** Distance to the nearest round cone of a limb. */
function distanceToCones(cones: Float64Array, x: number, y: number, z: number): FieldSample {
  let value = Infinity;
  let nearest = 0;
  let fraction = 0;
  for (let i = 0; i < cones.length; i += 9) {
    const ax = x - cones[i];
    const ay = y - cones[i + 1];
    const az = z - cones[i + 2];
    const along = (ax * cones[i + 4] + ay * cones[i + 5] + az * cones[i + 6]) * cones[i + 8];
    const t = along < 0 ? 0 : along > 1 ? 1 : along;
    const px = ax - t * cones[i + 4];
    const py = ay - t * cones[i + 5];
    const pz = az - t * cones[i + 6];
    const distance = Math.sqrt(px * px + py * py + pz * pz) - cones[i + 3] - t * cones[i + 7];
    if (distance >= value) continue;
    value = distance;
    nearest = i;
    fraction = t;
  }
  const isBetweenEnds = fraction > 0 && fraction < 1;
  const widening = isBetweenEnds ? cones[nearest + 7] * cones[nearest + 8] : 0;
  const step = (axis: number) => cones[nearest + 4 + axis];
  const away = [x, y, z].map(
    (coordinate, axis) => coordinate - cones[nearest + axis] - fraction * step(axis),
  );
  const distance = Math.hypot(away[0], away[1], away[2]);
  const slope = (axis: number) => away[axis] / distance - widening * step(axis);
  return { value, gradient: [slope(0), slope(1), slope(2)] };
}
