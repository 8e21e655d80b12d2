/** Where animations of a file take the vertices of its skinned meshes. */

import type { Animation, AnimationSampler, Document, Node, Primitive, Skin } from '@gltf-transform/core';
import { influenceSets } from '../document/influences';
import type { Body } from '../document/model';

type Matrix = number[];
/** Positions of a body's vertices, positions[3 v + c], in the space of the scene. */
export type PosedPositions = Float64Array;

/** Poses of one animation, at evenly spaced times. */
const POSES_PER_ANIMATION = 8;
/** Poses in all; with many animations each gives fewer. */
const MAX_POSES = 64;

/** The body in poses of all animations that move its skeleton; none where it has no skin. Deterministic. */
export function posesInAnimations(document: Document, body: Body): PosedPositions[] {
  const root = document.getRoot();
  const mesh = root.listMeshes()[body.mesh];
  const node = root.listNodes().find((candidate) => candidate.getMesh() === mesh && candidate.getSkin());
  const animations = root.listAnimations();
  if (!node || animations.length === 0) return [];
  const skin = node.getSkin()!;
  const each = Math.max(1, Math.min(POSES_PER_ANIMATION, Math.floor(MAX_POSES / animations.length)));
  return animations
    .slice(0, MAX_POSES)
    .flatMap((animation) =>
      timesOf(animation, each).map((time) =>
        skinned(mesh.listPrimitives(), body, jointMatrices(skin, animation, time)),
      ),
    );
}

function timesOf(animation: Animation, count: number): number[] {
  const ends = animation.listSamplers().map((sampler) => sampler.getInput()?.getMax([])[0] ?? 0);
  const last = Math.max(0, ...ends);
  return Array.from({ length: count }, (_, i) => (last * i) / count);
}

/** Per joint: from the space of the mesh in its bind pose to that of the scene. */
function jointMatrices(skin: Skin, animation: Animation, time: number): Matrix[] {
  const local = new Map<Node, { translation: number[]; rotation: number[]; scale: number[] }>();
  for (const channel of animation.listChannels()) {
    const [node, path, sampler] = [channel.getTargetNode(), channel.getTargetPath(), channel.getSampler()];
    if (!node || !sampler || (path !== 'translation' && path !== 'rotation' && path !== 'scale')) continue;
    const value = sampledAt(sampler, time, path === 'rotation' ? 4 : 3);
    if (value) local.set(node, { ...(local.get(node) ?? restOf(node)), [path]: value });
  }
  const worlds = new Map<Node, Matrix>();
  const worldOf = (node: Node): Matrix => {
    const known = worlds.get(node);
    if (known) return known;
    const moved = local.get(node);
    const own = moved ? compose(moved) : node.getMatrix();
    const parent = node.getParentNode();
    const world = parent ? multiply(worldOf(parent), own) : [...own];
    worlds.set(node, world);
    return world;
  };
  const bind = skin.getInverseBindMatrices();
  return skin
    .listJoints()
    .map((joint, i) => (bind ? multiply(worldOf(joint), bind.getElement(i, [])) : worldOf(joint)));
}

const restOf = (node: Node) => ({
  translation: [...node.getTranslation()],
  rotation: [...node.getRotation()],
  scale: [...node.getScale()],
});

/** Between keys linearly, rotations normalised; of splines the values at their keys are taken as if they were linear. */
function sampledAt(sampler: AnimationSampler, time: number, size: number): number[] | null {
  const [input, output] = [sampler.getInput(), sampler.getOutput()];
  if (!input || !output || input.getCount() === 0) return null;
  const [stride, first] = sampler.getInterpolation() === 'CUBICSPLINE' ? [3, 1] : [1, 0];
  const valueAt = (key: number): number[] => output.getElement(stride * key + first, []);
  let next = 0;
  while (next < input.getCount() && input.getScalar(next) <= time) ++next;
  if (next === 0) return valueAt(0);
  if (next === input.getCount() || sampler.getInterpolation() === 'STEP') return valueAt(next - 1);
  const [from, to] = [input.getScalar(next - 1), input.getScalar(next)];
  const share = to > from ? (time - from) / (to - from) : 0;
  const [a, b] = [valueAt(next - 1), valueAt(next)];
  const isTurned = size === 4 && a.reduce((total, value, c) => total + value * b[c], 0) < 0;
  const mixed = a.map((value, c) => value * (1 - share) + (isTurned ? -b[c] : b[c]) * share);
  if (size !== 4) return mixed;
  const length = Math.sqrt(mixed.reduce((total, value) => total + value * value, 0));
  return length > 0 ? mixed.map((value) => value / length) : a;
}

interface NodeTransform {
  translation: number[];
  rotation: number[];
  scale: number[];
}

/** Column-major, as glTF has it. */
function compose({
  translation: [tx, ty, tz],
  rotation: [x, y, z, w],
  scale: [sx, sy, sz],
}: NodeTransform): Matrix {
  return [
    ...[1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w), 0].map((value) => value * sx),
    ...[2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w), 0].map((value) => value * sy),
    ...[2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y), 0].map((value) => value * sz),
    ...[tx, ty, tz, 1],
  ];
}

function multiply(a: ArrayLike<number>, b: ArrayLike<number>): Matrix {
  return Array.from({ length: 16 }, (_, i) => {
    const [row, column] = [i % 4, i - (i % 4)];
    return [0, 1, 2, 3].reduce((total, k) => total + a[4 * k + row] * b[column + k], 0);
  });
}

function skinned(primitives: Primitive[], body: Body, matrices: Matrix[]): PosedPositions {
  const posed = new Float64Array(body.positions.length);
  for (const { primitive: number, firstVertex } of body.spans) {
    const primitive = primitives[number];
    const count = primitive.getAttribute('POSITION')!.getCount();
    for (const { joints, weights } of influenceSets(primitive)) {
      for (let v = 0; v < count; ++v) {
        const [which, shares] = [joints.getElement(v, []), weights.getElement(v, [])];
        const to = 3 * (firstVertex + v);
        const point = body.positions.subarray(to, to + 3);
        which.forEach((joint, c) => {
          if (shares[c] > 0 && joint < matrices.length)
            addMoved(posed, to, matrices[joint], { point, share: shares[c] });
        });
      }
    }
  }
  return posed;
}

/** Adds the weighted image of a point under a matrix to posed[to, to + 3). */
function addMoved(
  posed: Float64Array,
  to: number,
  m: Matrix,
  { point: [x, y, z], share }: WeightedPoint,
): void {
  for (let c = 0; c < 3; ++c) posed[to + c] += share * (m[c] * x + m[4 + c] * y + m[8 + c] * z + m[12 + c]);
}

interface WeightedPoint {
  point: Float32Array;
  share: number;
}
