/** The simplifiers of meshoptimizer on the welded mesh, to a face count at any error, to compare with. */

import { faceCount, vertexCount } from '../../core/mesh';
import type { TriangleMesh } from '../../core/core';

/** An error limit, relative to the size, that no result reaches. */
const ANY_ERROR = 1e9;

type Simplifier = (typeof import('meshoptimizer/simplifier'))['MeshoptSimplifier'];

/** `simplify` keeps a subset of the vertices; `update` moves those that stay, with the flag Regularize. */
export type MeshoptimizerCall = 'simplify' | 'update';

/** Loads the library, so that its time does not count; the returned function gives at most `faces` faces where it can. */
export async function meshoptimizerCall(
  call: MeshoptimizerCall,
): Promise<(mesh: TriangleMesh, faces: number) => TriangleMesh> {
  const { MeshoptSimplifier } = await import('meshoptimizer/simplifier');
  await MeshoptSimplifier.ready;
  const run = call === 'simplify' ? simplified : updated;
  return (mesh, faces) => run(MeshoptSimplifier, mesh, Math.min(faces, faceCount(mesh)));
}

function simplified(library: Simplifier, { positions, triangles }: TriangleMesh, faces: number) {
  const [indices] = library.simplify(triangles, positions, 3, 3 * faces, ANY_ERROR);
  return compacted(library, positions, indices.slice());
}

function updated(library: Simplifier, mesh: TriangleMesh, faces: number): TriangleMesh {
  const [indices, positions] = [mesh.triangles.slice(), mesh.positions.slice()];
  const none = new Float32Array();
  const [count] = library.simplifyWithUpdate(indices, positions, 3, none, 0, [], null, 3 * faces, ANY_ERROR, [
    'Regularize',
  ]);
  return compacted(library, positions, indices.slice(0, count));
}

/** The mesh of `triangles`, which are renumbered, without unused vertices. */
function compacted(library: Simplifier, positions: Float32Array, triangles: Uint32Array): TriangleMesh {
  const [remap, count] = library.compactMesh(triangles);
  const kept = new Float32Array(3 * count);
  for (let v = 0; v < vertexCount({ positions }); v++)
    if (remap[v] < count) kept.set(positions.subarray(3 * v, 3 * v + 3), 3 * remap[v]);
  return { positions: kept, triangles };
}
