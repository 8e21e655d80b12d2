/** Joints and weights at surface points. */

import type { Accessor, Primitive } from '@gltf-transform/core';
import { emptyLike, unitOf } from './blend';
import type { Values, VertexSources } from './blend';

/** The attributes JOINTS_n and WEIGHTS_n for one n. */
export interface InfluenceSet<T> {
  joints: T;
  weights: T;
}

interface Influence {
  joint: number;
  weight: number;
}

/** The sets of a primitive up to the first number without joints; one without weights is left out. */
export function influenceSets(primitive: Primitive): InfluenceSet<Accessor>[] {
  const sets: InfluenceSet<Accessor>[] = [];
  for (let n = 0; ; ++n) {
    const joints = primitive.getAttribute(`JOINTS_${n}`);
    const weights = primitive.getAttribute(`WEIGHTS_${n}`);
    if (!joints) return sets;
    if (weights) sets.push({ joints, weights });
  }
}

/** The number of influences per vertex in one set. */
const PER_SET = 4;

/**
 * Merges the influences of the three corners, so that each joint occurs once. The largest ones that fit into the sets are
 * kept and scaled to sum 1 in the numbers of their component type. A copy of a single vertex keeps its influences.
 */
export function mergeInfluences(
  sets: InfluenceSet<Accessor>[],
  sources: VertexSources,
): InfluenceSet<Values>[] {
  const count = sources.vertices.length / 3;
  // Any influence can end up in any set, so all sets get one type.
  const joints = widestOf(sets.map((set) => set.joints.getArray()!));
  const weights = hasOneType(sets) ? sets[0].weights.getArray()! : new Float32Array();
  const merged = sets.map(() => ({
    joints: emptyLike(joints, PER_SET * count),
    weights: emptyLike(weights, PER_SET * count),
  }));
  for (let i = 0; i < count; ++i)
    if (sources.shares[3 * i] === 1) copyInfluences(sets, sources.vertices[3 * i], merged, i);
    else {
      const strongest = gatherInfluences(sets, sources, i).slice(0, PER_SET * sets.length);
      if (strongest.length > 0) writeInfluences(strongest, sets, merged, i);
      else copyInfluences(sets, sources.vertices[3 * i], merged, i);
    }
  return merged;
}

const widestOf = (arrays: Values[]): Values =>
  arrays.reduce((widest, one) => (one.BYTES_PER_ELEMENT > widest.BYTES_PER_ELEMENT ? one : widest));

const hasOneType = (sets: InfluenceSet<Accessor>[]): boolean =>
  sets.every(({ weights }) => weights.getComponentType() === sets[0].weights.getComponentType());

function copyInfluences(
  sets: InfluenceSet<Accessor>[],
  from: number,
  merged: InfluenceSet<Values>[],
  to: number,
): void {
  sets.forEach(({ joints, weights }, n) => {
    const scale = merged[n].weights instanceof Float32Array ? unitOf(weights) : 1;
    for (let c = 0; c < PER_SET; ++c) {
      merged[n].joints[PER_SET * to + c] = joints.getArray()![PER_SET * from + c];
      merged[n].weights[PER_SET * to + c] = scale * weights.getArray()![PER_SET * from + c];
    }
  });
}

/** The influences of vertex i with a weight above 0, descending by weight, then ascending by joint. */
function gatherInfluences(
  sets: InfluenceSet<Accessor>[],
  { vertices, shares }: VertexSources,
  i: number,
): Influence[] {
  const weightOfJoint = new Map<number, number>();
  for (let k = 0; k < 3; ++k)
    for (const { joints, weights } of sets)
      for (let c = 0; c < PER_SET; ++c) {
        const at = PER_SET * vertices[3 * i + k] + c;
        const weight = shares[3 * i + k] * unitOf(weights) * weights.getArray()![at];
        const joint = joints.getArray()![at];
        if (weight > 0) weightOfJoint.set(joint, (weightOfJoint.get(joint) ?? 0) + weight);
      }
  return [...weightOfJoint]
    .map(([joint, weight]) => ({ joint, weight }))
    .sort((a, b) => b.weight - a.weight || a.joint - b.joint);
}

function writeInfluences(
  strongest: Influence[],
  sets: InfluenceSet<Accessor>[],
  merged: InfluenceSet<Values>[],
  to: number,
): void {
  const sum = strongest.reduce((total, { weight }) => total + weight, 0);
  const one = merged[0].weights instanceof Float32Array ? 1 : Math.round(1 / unitOf(sets[0].weights));
  const numbers = strongest.map(({ weight }) =>
    one === 1 ? weight / sum : Math.round((one * weight) / sum),
  );
  // The largest weight absorbs the rounding error of the sum.
  if (one !== 1) numbers[0] += one - numbers.reduce((total, number) => total + number, 0);
  strongest.forEach(({ joint }, rank) => {
    const { joints, weights } = merged[Math.floor(rank / PER_SET)];
    const at = PER_SET * to + (rank % PER_SET);
    // glTF requires joint 0 where the weight is 0.
    joints[at] = numbers[rank] > 0 ? joint : 0;
    weights[at] = numbers[rank];
  });
}
