/** Where, how large and how often the meshes of a document are in its scenes. */

import type { Accessor, Document, Mesh, Node } from '@gltf-transform/core';
import { product } from '../core/affine';
import { length3 } from '../core/exact_math';

/** The extension for many instances of one node's mesh. */
export const INSTANCING = 'EXT_mesh_gpu_instancing';

/**
 * The scale of a mesh in the scene with all of its instances: the root of the sum of their squared scales, since the visible effect of an
 * error is its square, and is seen in each of them. A scale is the root mean square of the three axes. 1 where no node shows the mesh.
 */
export function instanceScale(document: Document, mesh: Mesh): number {
  const nodes = nodesOf(document, mesh);
  const squares = nodes.map((node) => squaredScale(node) * instances(node));
  const sum = squares.reduce((all, square) => all + square, 0);
  return nodes.length > 0 && Number.isFinite(sum) ? Math.sqrt(sum) : 1;
}

const nodesOf = (document: Document, mesh: Mesh): Node[] =>
  document
    .getRoot()
    .listNodes()
    .filter((node) => node.getMesh() === mesh);

/** Scales that differ by less than this share are the same. */
const SAME_SCALE = 0.001;

/** The smallest and the largest scale at which the scenes show a body, instances included; null where none differs from that of the body. */
export function otherScales(
  document: Document,
  body: { mesh: number; scale: number },
): { least: number; most: number } | null {
  const range = scaleRange(document, document.getRoot().listMeshes()[body.mesh]);
  const isSame = (scale: number): boolean => Math.abs(scale / body.scale - 1) <= SAME_SCALE;
  return range === null || (isSame(range.least) && isSame(range.most)) ? null : range;
}

/** null where nothing shows the mesh; a scale of 0 hides it. */
function scaleRange(document: Document, mesh: Mesh): { least: number; most: number } | null {
  let [least, most] = [Infinity, 0];
  for (const node of nodesOf(document, mesh)) {
    const ofNode = squaredScale(node);
    forEachInstance(node, (ofInstance) => {
      const square = ofNode * ofInstance;
      if (square > 0) [least, most] = [Math.min(least, square), Math.max(most, square)];
    });
  }
  return least <= most && Number.isFinite(most) ? { least: Math.sqrt(least), most: Math.sqrt(most) } : null;
}

/** The squared scale of a node's mesh: of a skinned mesh by its joints, because its own node is ignored. */
function squaredScale(node: Node): number {
  const skin = node.getSkin();
  const [joint] = skin?.listJoints() ?? [];
  if (!skin || !joint) return squareOf(node.getWorldMatrix());
  const bind = skin.getInverseBindMatrices()?.getElement(0, []);
  return squareOf(joint.getWorldMatrix()) * (bind ? squareOf(bind) : 1);
}

function squareOf(matrix: ArrayLike<number>): number {
  const axes = [0, 4, 8].map((at) => length3(matrix[at], matrix[at + 1], matrix[at + 2]));
  return axes.reduce((sum, axis) => sum + axis * axis, 0) / 3;
}

/** The sum of the squared scales of the node's instances; 1 where it is not instanced. */
function instances(node: Node): number {
  let sum = 0;
  forEachInstance(node, (square, count) => (sum += count * square));
  return sum;
}

/** Calls `use` with the squared scales of the node's instances, and how many have each; once with 1 where it is not instanced. */
function forEachInstance(node: Node, use: (square: number, count: number) => void): void {
  const extension = instancesOf(node);
  const count = countOf(extension);
  const scales = extension?.getAttribute('SCALE');
  if (count === null || !scales) return use(1, count ?? 1);
  for (let i = 0; i < scales.getCount(); ++i) {
    const [x, y, z]: number[] = scales.getElement(i, [] as number[]);
    use((x * x + y * y + z * z) / 3, 1);
  }
}

/** The attributes of EXT_mesh_gpu_instancing on a node. */
interface Instances {
  listSemantics(): string[];
  getAttribute(semantic: string): Accessor | null;
}

const instancesOf = (node: Node): Instances | null => node.getExtension(INSTANCING) as Instances | null;

/** The number of instances; null where the node is not instanced. */
function countOf(extension: Instances | null): number | null {
  const [first] = extension?.listSemantics() ?? [];
  return extension && first !== undefined ? extension.getAttribute(first)!.getCount() : null;
}

/**
 * The matrix in the scene of each instance of a node, column by column; its own where it has none, or a skin, which places all of them.
 */
export function worldMatricesOf(node: Node): number[][] {
  const [extension, world] = [instancesOf(node), [...node.getWorldMatrix()]];
  const count = countOf(extension);
  if (count === null || node.getSkin()) return [world];
  const values = (semantic: string, i: number, otherwise: number[]): number[] =>
    extension!.getAttribute(semantic)?.getElement(i, []) ?? otherwise;
  return Array.from({ length: count }, (_, i) => {
    const [moved, scaled] = [values('TRANSLATION', i, [0, 0, 0]), values('SCALE', i, [1, 1, 1])];
    return product(world, composed(moved, values('ROTATION', i, [0, 0, 0, 1]), scaled));
  });
}

/** The matrix that scales, then turns by a quaternion of any length, then moves. */
function composed(moved: number[], [a, b, c, d]: number[], scaled: number[]): number[] {
  const length = Math.sqrt(a * a + b * b + c * c + d * d) || 1;
  const [x, y, z, w] = [a, b, c, d].map((value) => value / length);
  const turned = [
    [1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w)],
    [2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w)],
    [2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y)],
  ];
  return [...turned.flatMap((axis, k) => [...axis.map((value) => scaled[k] * value), 0]), ...moved, 1];
}

/** The first node that shows each mesh. */
export function firstNodes(document: Document): Map<Mesh, Node> {
  const nodes = new Map<Mesh, Node>();
  for (const node of document.getRoot().listNodes()) {
    const mesh = node.getMesh();
    if (mesh && !nodes.has(mesh)) nodes.set(mesh, node);
  }
  return nodes;
}

/** Per mesh of the document `meshMatrixOf` of the first node that shows it. The identity where none does. */
export function meshMatrices(document: Document): number[][] {
  const nodes = firstNodes(document);
  return document
    .getRoot()
    .listMeshes()
    .map((mesh) => {
      const node = nodes.get(mesh);
      return node ? meshMatrixOf(node) : [...IDENTITY];
    });
}

/**
 * The matrix from the space of a node's mesh to that of the scene, column by column. A skinned mesh stands where its first joint
 * puts it.
 */
export function meshMatrixOf(node: Node): number[] {
  const skin = node.getSkin();
  const [joint] = skin?.listJoints() ?? [];
  if (!skin || !joint) return [...node.getWorldMatrix()];
  const bind = skin.getInverseBindMatrices()?.getElement(0, [] as number[]) ?? IDENTITY;
  return product(joint.getWorldMatrix(), bind);
}

const IDENTITY: readonly number[] = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
