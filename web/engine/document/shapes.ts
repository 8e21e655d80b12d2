/** Writes modes for other programs: morph targets of a body, and animations that oscillate them. */

import type { Accessor, Animation, Buffer, Document, Mesh, Node } from '@gltf-transform/core';
import type { ModeSet, TriangleMesh } from '../core/core';
import { modesAvailable } from '../core/mode_set';

/** A deformation of a mesh: the displacement of each vertex at weight 1. */
export interface MorphTarget {
  name: string;
  /** displacements[3 * v + c], in units of the mesh */
  displacements: Float32Array;
}

/** Largest displacement of a shape, relative to the diagonal of the body's bounding box. */
const AMPLITUDE = 0.1;
const SWING_SECONDS = 2;
const KEYFRAMES = 33;

/**
 * One target per entry of `ordinals` (from 0) that exists. The target of ordinal k moves every part of the body in the
 * part's own (k + 1)-th mode, which keeps the number of targets independent of the number of parts.
 */
export function shapeTargets(
  mesh: TriangleMesh,
  modes: ModeSet,
  ordinals: number[],
  diagonal: number,
): MorphTarget[] {
  const size = mesh.positions.length;
  const available = modesAvailable(modes);
  return ordinals
    .filter((ordinal) => ordinal < available)
    .map((ordinal) => {
      const shape = modes.shapes.subarray(ordinal * size, (ordinal + 1) * size);
      return {
        name: shapeName(modes, ordinal),
        displacements: shape.map((value) => AMPLITUDE * diagonal * value),
      };
    });
}

function shapeName(modes: ModeSet, ordinal: number): string {
  const frequencies = modes.modes
    .filter((mode) => mode.ordinal === ordinal)
    .map((mode) => mode.omega / (2 * Math.PI));
  if (frequencies.length !== 1) return `mode ${ordinal + 1}`;
  return `mode ${ordinal + 1}, ${frequencies[0].toPrecision(3)} Hz`;
}

/** Adds one animation per target, a full sine in two seconds, for every node that shows one of `meshes`. */
export function addSwings(document: Document, buffer: Buffer, meshes: Set<Mesh>): void {
  const nodes = document
    .getRoot()
    .listNodes()
    .filter((node) => node.getMesh() && meshes.has(node.getMesh()!));
  const targetCounts = nodes.map((node) => node.getMesh()!.listPrimitives()[0].listTargets().length);
  const times = Float32Array.from({ length: KEYFRAMES }, (_, i) => (SWING_SECONDS * i) / (KEYFRAMES - 1));
  const input = document.createAccessor('', buffer).setType('SCALAR').setArray(times);
  for (let target = 0; target < Math.max(0, ...targetCounts); ++target) {
    const moving = nodes.filter((_, i) => target < targetCounts[i]);
    const name = moving[0].getMesh()!.listPrimitives()[0].listTargets()[target].getName();
    const animation = document.createAnimation(name);
    for (const node of moving) addSwing(document, animation, node, { input, buffer, target });
  }
}

interface Swing {
  input: Accessor;
  buffer: Buffer;
  target: number;
}

function addSwing(
  document: Document,
  animation: Animation,
  node: Node,
  { input, buffer, target }: Swing,
): void {
  const count = node.getMesh()!.listPrimitives()[0].listTargets().length;
  const weights = new Float32Array(KEYFRAMES * count);
  for (let i = 0; i < KEYFRAMES; ++i)
    weights[i * count + target] = Math.sin((2 * Math.PI * i) / (KEYFRAMES - 1));
  const output = document.createAccessor('', buffer).setType('SCALAR').setArray(weights);
  const sampler = document.createAnimationSampler().setInput(input).setOutput(output);
  const channel = document
    .createAnimationChannel()
    .setSampler(sampler)
    .setTargetNode(node)
    .setTargetPath('weights');
  animation.addSampler(sampler).addChannel(channel);
}
