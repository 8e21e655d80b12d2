/** Writes a simulated motion as a GLB: the bodies stand side by side, with a morph target and a keyframe per frame. */

import { Document } from '@gltf-transform/core';
import type { Animation, Buffer, Mesh, Node } from '@gltf-transform/core';
import type { TriangleMesh } from '../core/core';
import { createGltfIo } from './gltf_io';
import { VERSION } from '../core/version';

export interface RecordedBody {
  name: string;
  mesh: TriangleMesh;
  /** positions[(step * vertexCount + v) * 3 + c] after each step */
  positions: Float32Array;
  /** x translation of the body in the scene */
  offset: number;
}

/** Longer motions are subsampled evenly, because every morph target costs memory in a viewer. */
const MAX_FRAMES = 60;

/** `stepSeconds` is the time between two steps. The same input gives the same bytes. */
export async function recordingGlb(bodies: RecordedBody[], stepSeconds: number): Promise<Uint8Array> {
  const document = new Document();
  const buffer = document.createBuffer();
  const scene = document.createScene('simulation');
  document.getRoot().setDefaultScene(scene);
  const animation = document.createAnimation('simulation');
  for (const body of bodies) {
    const frames = framesOf(body);
    const mesh = meshOf(document, buffer, body, frames);
    const node = document.createNode(body.name).setMesh(mesh).setTranslation([body.offset, 0, 0]);
    scene.addChild(node);
    const times = [0, ...frames.map((step) => (step + 1) * stepSeconds)];
    animate(document, animation, node, { buffer, times });
  }
  document.getRoot().getAsset().generator = `Limber ${VERSION}`;
  return (await createGltfIo()).writeBinary(document);
}

/** The steps that are kept, evenly spaced, always with the last one. */
function framesOf({ mesh, positions }: RecordedBody): number[] {
  const steps = positions.length / mesh.positions.length;
  const count = Math.min(steps, MAX_FRAMES);
  return Array.from({ length: count }, (_, i) => Math.round(((i + 1) * steps) / count) - 1);
}

function meshOf(document: Document, buffer: Buffer, body: RecordedBody, frames: number[]): Mesh {
  const { positions, triangles } = body.mesh;
  const vectors = (array: Float32Array) =>
    document.createAccessor('', buffer).setType('VEC3').setArray(array);
  const indices = document.createAccessor('', buffer).setType('SCALAR').setArray(triangles.slice());
  const primitive = document
    .createPrimitive()
    .setAttribute('POSITION', vectors(positions.slice()))
    .setIndices(indices);
  for (const step of frames) {
    const first = step * positions.length;
    const moved = positions.map((rest, i) => body.positions[first + i] - rest);
    primitive.addTarget(document.createPrimitiveTarget().setAttribute('POSITION', vectors(moved)));
  }
  return document
    .createMesh(body.name)
    .addPrimitive(primitive)
    .setWeights(frames.map(() => 0));
}

/** At times[k], k > 0, only target k - 1 has weight 1; weights are linear in between. */
function animate(
  document: Document,
  animation: Animation,
  node: Node,
  { buffer, times }: { buffer: Buffer; times: number[] },
): void {
  const targets = times.length - 1;
  const weights = new Float32Array(times.length * targets);
  for (let k = 1; k < times.length; k++) weights[k * targets + k - 1] = 1;
  const numbers = (array: Float32Array) =>
    document.createAccessor('', buffer).setType('SCALAR').setArray(array);
  const sampler = document
    .createAnimationSampler()
    .setInput(numbers(Float32Array.from(times)))
    .setOutput(numbers(weights))
    .setInterpolation('LINEAR');
  const channel = document
    .createAnimationChannel()
    .setTargetNode(node)
    .setTargetPath('weights')
    .setSampler(sampler);
  animation.addSampler(sampler).addChannel(channel);
}
