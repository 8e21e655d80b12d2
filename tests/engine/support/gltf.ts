/** Builds glTF files in memory. */

import { Accessor, Document, Logger, WebIO } from '@gltf-transform/core';
import type { Mesh, Primitive } from '@gltf-transform/core';
import { ALL_EXTENSIONS, KHRTextureTransform } from '@gltf-transform/extensions';
import type { SourceFile } from '../../../web/engine/document/open';
import type { TriangleMesh } from '../../../web/engine/core/core';

export async function glbFile(document: Document, name = 'test.glb'): Promise<SourceFile> {
  const io = new WebIO().setLogger(new Logger(Logger.Verbosity.SILENT)).registerExtensions(ALL_EXTENSIONS);
  return { name, bytes: await io.writeBinary(document) };
}

export async function readGlb(bytes: Uint8Array): Promise<Document> {
  return new WebIO().registerExtensions(ALL_EXTENSIONS).readBinary(bytes);
}

/** A document with one scene and buffer. */
export function startDocument(): Document {
  const document = new Document();
  document.createBuffer();
  document.getRoot().setDefaultScene(document.createScene('scene'));
  return document;
}

export function floats(
  document: Document,
  type: Accessor['getType'] extends () => infer T ? T : never,
  values: ArrayLike<number>,
) {
  const buffer = document.getRoot().listBuffers()[0];
  return document.createAccessor('', buffer).setType(type).setArray(Float32Array.from(values));
}

export function indices(document: Document, values: ArrayLike<number>): Accessor {
  const buffer = document.getRoot().listBuffers()[0];
  let largest = 0;
  for (let i = 0; i < values.length; ++i) largest = Math.max(largest, values[i]);
  const array = largest < 65535 ? Uint16Array.from(values) : Uint32Array.from(values);
  return document.createAccessor('', buffer).setType('SCALAR').setArray(array);
}

export function primitiveOf(document: Document, { positions, triangles }: TriangleMesh): Primitive {
  return document
    .createPrimitive()
    .setAttribute('POSITION', floats(document, 'VEC3', positions))
    .setIndices(indices(document, triangles));
}

/** Adds a mesh with its node to the scene. */
export function addMesh(document: Document, name: string, primitives: Primitive[]): Mesh {
  const mesh = document.createMesh(name);
  for (const primitive of primitives) mesh.addPrimitive(primitive);
  document
    .getRoot()
    .getDefaultScene()!
    .addChild(document.createNode(`${name} node`).setMesh(mesh));
  return mesh;
}

const PIXEL = Uint8Array.from(
  atob('iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk+M9QDwADhgGAWjR9awAAAABJRU5ErkJggg=='),
  (letter) => letter.charCodeAt(0),
);

/** Adds a mesh with UVs, tangents, colours, a texture, a skin, a morph target, a custom attribute and an animation. */
export function addRichMesh(document: Document, name: string, mesh: TriangleMesh): Mesh {
  const vertexCount = mesh.positions.length / 3;
  const repeated = (values: number[]) => Array.from({ length: vertexCount }, () => values).flat();
  const texture = document.createTexture('picture').setImage(PIXEL).setMimeType('image/png');
  const material = document
    .createMaterial(`${name} material`)
    .setBaseColorTexture(texture)
    .setRoughnessFactor(0.5);
  const transform = document.createExtension(KHRTextureTransform).setRequired(true).createTransform();
  material.getBaseColorTextureInfo()!.setExtension('KHR_texture_transform', transform.setScale([2, 2]));
  const bytes = (values: number[]) => floats(document, 'VEC4', []).setArray(Uint8Array.from(values));
  const target = document
    .createPrimitiveTarget('fat')
    .setAttribute('POSITION', floats(document, 'VEC3', mesh.positions));
  const primitive = primitiveOf(document, mesh)
    .setAttribute('TEXCOORD_0', floats(document, 'VEC2', repeated([0, 0])))
    .setAttribute('TANGENT', floats(document, 'VEC4', repeated([1, 0, 0, 1])))
    .setAttribute('NORMAL', floats(document, 'VEC3', repeated([0, 0, 1])))
    .setAttribute('COLOR_0', floats(document, 'VEC3', repeated([1, 0, 0])))
    .setAttribute('JOINTS_0', bytes(repeated([0, 0, 0, 0])))
    .setAttribute('WEIGHTS_0', floats(document, 'VEC4', repeated([1, 0, 0, 0])))
    .setAttribute('_HEAT', floats(document, 'SCALAR', repeated([0])))
    .addTarget(target)
    .setMaterial(material);
  const rich = addMesh(document, name, [primitive]).setWeights([0.5]);
  addMotion(
    document,
    document
      .getRoot()
      .listNodes()
      .find((node) => node.getMesh() === rich)!,
  );
  return rich;
}

function addMotion(document: Document, node: ReturnType<Document['createNode']>): void {
  const joint = document.createNode('joint');
  document.getRoot().getDefaultScene()!.addChild(joint);
  const matrices = floats(document, 'MAT4', [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1]);
  node.setSkin(document.createSkin('skin').addJoint(joint).setInverseBindMatrices(matrices));
  moveNode(document, joint);
}

/** Adds an animation that moves the node. */
export function moveNode(document: Document, node: ReturnType<Document['createNode']>): void {
  const sampler = document
    .createAnimationSampler()
    .setInput(floats(document, 'SCALAR', [0, 1]))
    .setOutput(floats(document, 'VEC3', [0, 0, 0, 1, 1, 1]));
  const channel = document
    .createAnimationChannel()
    .setSampler(sampler)
    .setTargetNode(node)
    .setTargetPath('translation');
  document.createAnimation('walk').addSampler(sampler).addChannel(channel);
}
