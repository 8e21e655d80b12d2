/** Tangents of results: recomputed by MikkTSpace where faces changed, if those of the file are by MikkTSpace. */

import type { Accessor, Document, Primitive } from '@gltf-transform/core';
import { withStoredType } from '../write/stored_values';

/**
 * MikkTSpace (Mikkelsen 2008) over triangles whose corners have values of their own: positions and normals [3 * corner + c], texture
 * coordinates [2 * corner + c]; returns tangents [4 * corner + c], the handedness last and of the opposite sign to glTF's.
 */
export type GenerateTangents = (
  positions: Float32Array,
  normals: Float32Array,
  coordinates: Float32Array,
) => Float32Array;

/** MikkTSpace, loaded only if a primitive of the document has tangents; otherwise null. */
export async function tangentGenerator(document: Document): Promise<GenerateTangents | null> {
  const meshes = document.getRoot().listMeshes();
  const hasTangents = meshes.some((mesh) =>
    mesh.listPrimitives().some((primitive) => primitive.getAttribute('TANGENT')),
  );
  if (!hasTangents) return null;
  const { generateTangents } = await import('three/examples/jsm/libs/mikktspace.module.js');
  return generateTangents as GenerateTangents;
}

/** Tangents count as MikkTSpace's if this share of corners is within the angle; quantization and other triangulations cost some corners. */
const MIN_SHARE = 0.9;
/** cos 5 degrees */
const SAME_COSINE = 0.9961946980917455;

/** Whether the tangents of a primitive are those of MikkTSpace over `indices`, by the texture coordinates of its normal map. */
export function followMikkTSpace(
  primitive: Primitive,
  indices: ArrayLike<number>,
  generate: GenerateTangents,
): boolean {
  const tangents = primitive.getAttribute('TANGENT');
  const made = tangents && generated(primitive, indices, generate);
  if (!made) return false;
  const own = gathered(tangents, indices, 4);
  let alike = 0;
  for (let at = 0; at < own.length; at += 4) {
    const cosine = own[at] * made[at] + own[at + 1] * made[at + 1] + own[at + 2] * made[at + 2];
    if (cosine >= SAME_COSINE && own[at + 3] === made[at + 3]) alike += 1;
  }
  return alike >= (MIN_SHARE * own.length) / 4;
}

/**
 * Replaces the tangents of a written primitive where one of its triangles around a vertex has changed: `isUnchanged` by triangle. They
 * are unit vectors across the normals, and keep the handedness that they came with. `old`: the accessor of the file, whose component
 * type they keep.
 */
export function remakeTangents(
  primitive: Primitive,
  isUnchanged: readonly boolean[],
  old: Accessor,
  generate: GenerateTangents,
): void {
  const indices = primitive.getIndices()!.getArray()!;
  const [carried, normals] = [primitive.getAttribute('TANGENT')!, primitive.getAttribute('NORMAL')];
  const made = normals && generated(primitive, indices, generate);
  if (!made) return;
  const written = gathered(carried, range(carried.getCount()), 4);
  const sums = new Float64Array(3 * carried.getCount());
  const isChanged = new Uint8Array(carried.getCount());
  indices.forEach((vertex: number, corner: number) => {
    if (!isUnchanged[Math.floor(corner / 3)]) isChanged[vertex] = 1;
    if (made[4 * corner + 3] !== written[4 * vertex + 3]) return;
    for (let c = 0; c < 3; ++c) sums[3 * vertex + c] += made[4 * corner + c];
  });
  isChanged.forEach((changed, vertex) => {
    if (!changed) return;
    const across = perpendicular(sums.subarray(3 * vertex, 3 * vertex + 3), normals.getElement(vertex, []));
    if (across) written.set(across, 4 * vertex);
  });
  primitive.setAttribute(
    'TANGENT',
    withStoredType(carried.clone().setNormalized(false).setArray(written), old),
  );
}

/** Per corner, with glTF's handedness; null where normals or texture coordinates are not there. */
function generated(
  primitive: Primitive,
  indices: ArrayLike<number>,
  generate: GenerateTangents,
): Float32Array | null {
  const set = primitive.getMaterial()?.getNormalTextureInfo()?.getTexCoord() ?? 0;
  const [positions, normals] = [primitive.getAttribute('POSITION')!, primitive.getAttribute('NORMAL')];
  const coordinates = primitive.getAttribute(`TEXCOORD_${set}`);
  if (!normals || !coordinates) return null;
  const made = generate(
    gathered(positions, indices, 3),
    gathered(normals, indices, 3),
    gathered(coordinates, indices, 2),
  );
  for (let at = 3; at < made.length; at += 4) made[at] = -made[at];
  return made;
}

function gathered(accessor: Accessor, indices: ArrayLike<number>, size: number): Float32Array<ArrayBuffer> {
  const values = new Float32Array(size * indices.length);
  const element: number[] = [];
  for (let i = 0; i < indices.length; ++i) values.set(accessor.getElement(indices[i], element), size * i);
  return values;
}

const range = (count: number): Uint32Array => Uint32Array.from({ length: count }, (_, i) => i);

/** The unit vector along `direction` across a normal; null where there is none. */
function perpendicular(direction: ArrayLike<number>, normal: ArrayLike<number>): number[] | null {
  const along = [0, 1, 2].reduce((sum, c) => sum + direction[c] * normal[c], 0);
  const across = [0, 1, 2].map((c) => direction[c] - along * normal[c]);
  const length = Math.sqrt(across.reduce((sum, value) => sum + value * value, 0));
  return length > 1e-6 ? across.map((value) => value / length) : null;
}
