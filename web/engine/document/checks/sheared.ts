/** Nodes with sheared matrices: the reader supports only translation, rotation and scale. */

import type { GLTF } from '@gltf-transform/core';
import { length3 } from '../../core/exact_math';
import { excerpt } from '../../core/words';
import { factorsOf } from './matrix_factors';

/** Cosines between columns up to this are taken for rounding, since some matrices are written with six digits. */
const ROUNDING = 1e-5;

/**
 * The JSON in which every sheared node gets a new parent, which rotates and scales; the node itself is left with a
 * rotation. So the index of the node still stands for the same space, for skins, extensions and its contents. Where animations or
 * levels of detail move the node or show it elsewhere, it loses its shear, which a note reports.
 */
export function withoutShear(json: GLTF.IGLTF): { json: GLTF.IGLTF; notes: string[] } {
  const old = json.nodes ?? [];
  const sheared = old.flatMap(({ matrix }, i) => (isSheared(matrix) ? [i] : []));
  if (sheared.length === 0) return { json, notes: [] };
  const standing = movedElsewhere(json);
  const nodes = [...old];
  const holders = new Map<number, number>();
  const lost: string[] = [];
  for (const i of sheared) {
    const { matrix, ...node } = old[i];
    const { outer, scale, inner, closest } = factorsOf(columnsOf(matrix!));
    const translation = matrix!.slice(12, 15);
    const isPlain = inner.slice(0, 3).every((value) => value === 0);
    if (isPlain) nodes[i] = { ...node, translation, rotation: outer, scale };
    else if (standing.has(i)) {
      nodes[i] = { ...node, translation, ...closest };
      lost.push(node.name ? `node "${excerpt(node.name)}"` : `node ${i}`);
    } else {
      const name = node.name ? { name: `${node.name}_shear` } : {};
      holders.set(i, nodes.length);
      nodes.push({ ...name, translation, rotation: outer, scale, children: [i] });
      nodes[i] = { ...node, rotation: inner };
    }
  }
  return { json: withHolders({ ...json, nodes }, old.length, holders), notes: describe(lost) };
}

const isMatrix = (matrix: unknown): matrix is number[] =>
  Array.isArray(matrix) && matrix.length === 16 && matrix.every(Number.isFinite);

type Column = [number, number, number];

const columnsOf = (m: number[]): Column[] => [0, 4, 8].map((at) => [m[at], m[at + 1], m[at + 2]]);

/** Whether two columns are not perpendicular, or one is 0, from which the reader cannot make a rotation. */
function isSheared(matrix: unknown): boolean {
  if (!isMatrix(matrix)) return false;
  const lengths = columnsOf(matrix).map(([x, y, z]) => length3(x, y, z));
  const [a, b, c] = columnsOf(matrix).map((column, k) => column.map((value) => value / lengths[k]));
  return [
    [a, b],
    [a, c],
    [b, c],
  ].some(([one, other]) => {
    const cosine = one[0] * other[0] + one[1] * other[1] + one[2] * other[2];
    return !(Math.abs(cosine) <= ROUNDING);
  });
}

/** A channel of an animation in unchecked JSON. */
type Channel = Partial<GLTF.IAnimationChannel>;

/** What KHR_animation_pointer can move of a node: "/nodes/3/translation". */
const POINTER = /^\/nodes\/(\d+)\/(translation|rotation|scale|matrix)$/;

/** The number of the node that a channel transforms; undefined: it transforms none. */
function movedBy(channel: Channel | null): number | undefined {
  const target = channel?.target;
  if (!target || target.path === 'weights') return undefined;
  const { pointer } = (target.extensions?.KHR_animation_pointer ?? {}) as { pointer?: unknown };
  const found = POINTER.exec(String(pointer));
  return found ? Number(found[1]) : target.node;
}

/** Indices of the nodes that an animation transforms, or that are levels of detail by an extension. */
function movedElsewhere({ animations = [], nodes = [] }: GLTF.IGLTF): Set<number | undefined> {
  const channels = animations.flatMap((animation) => animation.channels as (Channel | null)[] | undefined);
  const moved = channels.map((channel) => movedBy(channel ?? null));
  const levels = nodes.flatMap(({ extensions }, i) => {
    const ids = (extensions?.MSFT_lod as { ids?: unknown } | undefined)?.ids;
    return Array.isArray(ids) ? [i, ...(ids as number[])] : [];
  });
  return new Set([...moved, ...levels]);
}

/** The JSON in which scenes and the first `count` nodes refer to the new parents instead of their children. */
function withHolders(json: GLTF.IGLTF, count: number, holders: ReadonlyMap<number, number>): GLTF.IGLTF {
  const renumbered = (numbers: number[]) => numbers.map((number) => holders.get(number) ?? number);
  const nodes = json.nodes!.map((node, i) =>
    i < count && Array.isArray(node.children) ? { ...node, children: renumbered(node.children) } : node,
  );
  const scenes = json.scenes?.map((scene) =>
    Array.isArray(scene.nodes) ? { ...scene, nodes: renumbered(scene.nodes) } : scene,
  );
  return { ...json, nodes, ...(scenes ? { scenes } : {}) };
}

function describe([first, ...others]: string[]): string[] {
  if (first === undefined) return [];
  return others.length === 0
    ? [`${first} is sheared, which is lost: bake its transformation`]
    : [`${first} and ${others.length} more are sheared, which is lost: bake their transformations`];
}
