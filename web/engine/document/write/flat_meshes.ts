/** The triangles of a document's scenes in one space, for formats without a scene. */

import type { Accessor, Document, Material, Node, Primitive } from '@gltf-transform/core';
import { length3 } from '../../core/exact_math';
import { influenceSets } from '../influences';
import { product } from '../../core/affine';
import { worldMatricesOf } from '../placements';
import { posed } from './default_pose';
import { uvSetOf } from './uv_set';

/** The triangles of one instance of a primitive, in the space of the scene. Vertices are numbered as in the primitive. */
export interface FlatPrimitive {
  /** positions[3 * v + c] */
  positions: Float32Array;
  /** normals[3 * v + c], of length 1; null: it has none */
  normals: Float32Array | null;
  /** uvs[2 * v + c] of the set that its material shows, from the upper left corner of the picture; null: it has none */
  uvs: Float32Array | null;
  /** colours[3 * v + c], linear in [0, 1]; null: it has none */
  colours: Float32Array | null;
  /** opacities[v] of the colours; null: they have none */
  opacities: Float32Array | null;
  /** triangles[3 * t + corner], wound so that fronts stay fronts */
  triangles: Uint32Array;
  material: Material | null;
}

/** All primitives of triangles that one node shows, or one of its instances. */
export interface FlatMesh {
  name: string;
  primitives: FlatPrimitive[];
}

/** glTF's primitive modes. */
const TRIANGLES = 4;
const TRIANGLE_STRIP = 5;

type Matrix = ArrayLike<number>;

/** The nodes of the default scene, otherwise of the first scene, otherwise all nodes. */
export function shownNodes(document: Document): Node[] {
  const root = document.getRoot();
  const scene = root.getDefaultScene() ?? root.listScenes()[0];
  const nodes: Node[] = [];
  if (scene) scene.traverse((node) => nodes.push(node));
  return scene ? nodes : root.listNodes();
}

/** The most triangles that a file without instances may have: 1.3 GB of PLY. */
const MAX_TRIANGLES = 1e8;
const TOO_MANY = 'The scene repeats its meshes too often for OBJ and PLY: write .glb or .gltf.';

/**
 * What the shown nodes and their instances have of triangles; skins in their pose at rest, morph targets at their default weights. Throws an Error with one sentence where
 * these are too many to be written one by one.
 */
export function flatMeshes(document: Document): FlatMesh[] {
  let room = MAX_TRIANGLES;
  return shownNodes(document).flatMap((node) => {
    const mesh = node.getMesh();
    const shown = mesh?.listPrimitives().filter(hasTriangles) ?? [];
    if (!mesh || shown.length === 0) return [];
    const name = mesh.getName() || node.getName() || 'mesh';
    return worldMatricesOf(node).map((world) => {
      const primitives = shown.map((primitive) => flatten(primitive, node, world));
      for (const { triangles } of primitives) room -= triangles.length / 3;
      if (room < 0) throw new Error(TOO_MANY);
      return { name, primitives };
    });
  });
}

const hasTriangles = (primitive: Primitive): boolean =>
  (primitive.getMode() as number) >= TRIANGLES && (primitive.getAttribute('POSITION')?.getCount() ?? 0) > 0;

/** `world`: the matrix of the node, or of one of its instances. */
function flatten(primitive: Primitive, node: Node, world: Matrix): FlatPrimitive {
  const own = posed(primitive, node, 'POSITION')!;
  const matrixAt = matricesOf(primitive, node, world);
  const positions = transformed(own, matrixAt, 1);
  const normal = posed(primitive, node, 'NORMAL');
  const normals = normal && transformed(normal, (v) => cofactors(matrixAt(v)), 0);
  if (normals) makeUnit(normals);
  const uvs = primitive.getAttribute(uvSetOf(primitive));
  const colours = primitive.getAttribute('COLOR_0');
  const isMirrored = determinant(matrixAt(0)) < 0;
  return {
    positions,
    normals,
    uvs: uvs && valuesOf(uvs, 2),
    colours: colours && valuesOf(colours, 3),
    opacities: colours && colours.getElementSize() > 3 ? valuesOf(colours, 1, 3) : null,
    triangles: trianglesOf(primitive, own.length / 3, isMirrored),
    material: primitive.getMaterial(),
  };
}

/** Per vertex the matrix that places it: of its joints where it has some, otherwise of the node. */
function matricesOf(primitive: Primitive, node: Node, world: Matrix): (v: number) => Matrix {
  const skin = node.getSkin();
  const sets = influenceSets(primitive);
  if (!skin || sets.length === 0) return () => world;
  const bind = skin.getInverseBindMatrices();
  const matrices = skin
    .listJoints()
    .map((joint, j) =>
      bind ? product(joint.getWorldMatrix(), bind.getElement(j, [])) : joint.getWorldMatrix(),
    );
  return (v) => {
    const influences = sets.flatMap(({ joints, weights }) => {
      const shares = weights.getElement(v, [] as number[]);
      return joints.getElement(v, [] as number[]).map((joint, k) => ({ joint, share: shares[k] }));
    });
    const sum = influences.reduce((all, { share }) => all + share, 0);
    if (!(sum > 0)) return matrices[0] ?? world;
    const mixed = new Array<number>(16).fill(0);
    for (const { joint, share } of influences) {
      const matrix = matrices[joint];
      if (matrix && share > 0) for (let i = 0; i < 16; ++i) mixed[i] += (share / sum) * matrix[i];
    }
    return mixed;
  };
}

/** `w`: 1 for points, 0 for directions. */
function transformed(values: Float32Array, matrixAt: (v: number) => Matrix, w: number): Float32Array {
  const result = new Float32Array(values.length);
  for (let v = 0; v < values.length / 3; ++v) {
    const [x, y, z] = [values[3 * v], values[3 * v + 1], values[3 * v + 2]];
    const m = matrixAt(v);
    for (let c = 0; c < 3; ++c) result[3 * v + c] = m[c] * x + m[4 + c] * y + m[8 + c] * z + w * m[12 + c];
  }
  return result;
}

/** The matrix that transforms normals, up to their length: that of the cofactors, which also handles reflections. */
function cofactors(m: Matrix): number[] {
  const result = new Array<number>(16).fill(0);
  const sign = determinant(m) < 0 ? -1 : 1;
  for (let column = 0; column < 3; ++column)
    for (let row = 0; row < 3; ++row) {
      const [c1, c2] = [(column + 1) % 3, (column + 2) % 3];
      const [r1, r2] = [(row + 1) % 3, (row + 2) % 3];
      result[4 * column + row] = sign * (m[4 * c1 + r1] * m[4 * c2 + r2] - m[4 * c1 + r2] * m[4 * c2 + r1]);
    }
  return result;
}

const determinant = (m: Matrix): number =>
  m[0] * (m[5] * m[10] - m[6] * m[9]) -
  m[4] * (m[1] * m[10] - m[2] * m[9]) +
  m[8] * (m[1] * m[6] - m[2] * m[5]);

function makeUnit(vectors: Float32Array): void {
  for (let at = 0; at < vectors.length; at += 3) {
    const length = length3(vectors[at], vectors[at + 1], vectors[at + 2]);
    if (length > 0) for (let c = 0; c < 3; ++c) vectors[at + c] /= length;
  }
}

/** `size` components of each element, from component `first` on. */
function valuesOf(accessor: Accessor, size: number, first = 0): Float32Array {
  const [values, element] = [new Float32Array(size * accessor.getCount()), [] as number[]];
  for (let v = 0; v < accessor.getCount(); ++v) {
    accessor.getElement(v, element);
    for (let c = 0; c < size; ++c) values[size * v + c] = element[first + c];
  }
  return values;
}

/** Three vertices for each triangle of a list, strip or fan; the last two are swapped where the matrix is a reflection. */
function trianglesOf(primitive: Primitive, count: number, isMirrored: boolean): Uint32Array {
  const indices = primitive.getIndices()?.getArray() ?? Uint32Array.from({ length: count }, (_, i) => i);
  const mode = primitive.getMode() as number;
  const length = mode === TRIANGLES ? Math.floor(indices.length / 3) : Math.max(0, indices.length - 2);
  const triangles = new Uint32Array(3 * length);
  for (let t = 0; t < length; ++t) {
    const isOdd = mode === TRIANGLE_STRIP && t % 2 === 1;
    const first = mode === TRIANGLES ? 3 * t : t;
    const at =
      mode === TRIANGLES || mode === TRIANGLE_STRIP ? [first, first + 1, first + 2] : [0, t + 1, t + 2];
    const [a, b, c] = at.map((i) => indices[i]);
    triangles.set(isOdd !== isMirrored ? [a, c, b] : [a, b, c], 3 * t);
  }
  return triangles;
}
