// meshoptimizer's simplifiers on the welded mesh, to an exact face count at any error.

import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { MeshoptSimplifier } from 'meshoptimizer';
import { root } from './load_engine.mjs';

/** An error limit, relative to the size, that no result reaches. */
const ANY_ERROR = 1e9;
/** meshopt_SimplifyVertex_Lock and _Priority of its C header; its JavaScript forwards the bytes of `vertex_lock`. */
const [LOCK, PRIORITY] = [1, 4];
/** Vertices whose strain rank is above this get the priority. */
const STRAINED = 0.75;

/** The peer with the smallest frequency errors, which the targets refer to. */
export const BEST_PEER = 'meshoptimizer update';

const without = new Float32Array(0);
const indexCount = (faces) => 3 * Math.floor(faces);

function simplify({ prepared }, faces) {
  const { positions, triangles } = prepared.mesh;
  const [indices] = MeshoptSimplifier.simplify(triangles, positions, 3, indexCount(faces), ANY_ERROR);
  return compact(positions, indices);
}

function update({ prepared }, faces, priorities) {
  const positions = prepared.mesh.positions.slice();
  const indices = prepared.mesh.triangles.slice();
  const [count] = MeshoptSimplifier.simplifyWithUpdate(
    ...[indices, positions, 3, without, 0, [], priorities, indexCount(faces), ANY_ERROR, ['Regularize']],
  );
  return compact(positions, indices.slice(0, count));
}

/** The mesh of `indices` without unused vertices. */
function compact(positions, indices) {
  const triangles = indices.slice();
  const [remap, count] = MeshoptSimplifier.compactMesh(triangles);
  const kept = new Float32Array(3 * count);
  remap.forEach((to, v) => {
    if (to < count) kept.set(positions.subarray(3 * v, 3 * v + 3), 3 * to);
  });
  return { positions: kept, triangles };
}

/** Per vertex: PRIORITY if our guidance ranks a triangle around it high over the first six modes. */
function strainPriorities({ engine, core }, { prepared }) {
  const settings = engine.defaultSettings('qem');
  const rank = engine.strainRank(core, prepared, settings);
  const priorities = new Uint8Array(prepared.mesh.positions.length / 3);
  prepared.mesh.triangles.forEach((vertex, corner) => {
    if (rank[Math.floor(corner / 3)] > STRAINED) priorities[vertex] = PRIORITY;
  });
  return priorities;
}

/** Per vertex: LOCK on the outline of the pinned vertices; null if none are pinned. */
function outlineLocks({ prepared }, pinned) {
  if (!pinned?.length) return null;
  const { positions, triangles } = prepared.mesh;
  const isPinned = new Set(pinned);
  const locks = new Uint8Array(positions.length / 3);
  for (let t = 0; t < triangles.length; t += 3) {
    const corners = triangles.subarray(t, t + 3);
    if (corners.every((v) => isPinned.has(v))) continue;
    for (const v of corners) if (isPinned.has(v)) locks[v] = LOCK;
  }
  return locks;
}

function timed(simplifier) {
  return (mesh, faces, pinned) => {
    const started = performance.now();
    const result = simplifier(mesh, faces, pinned);
    return { mesh: result, seconds: (performance.now() - started) / 1000 };
  };
}

export async function meshoptimizerPeers(loaded) {
  await MeshoptSimplifier.ready;
  const packageFile = join(root, 'node_modules', 'meshoptimizer', 'package.json');
  const version = `meshoptimizer ${JSON.parse(readFileSync(packageFile, 'utf8')).version}`;
  const strained = (mesh, faces) => update(mesh, faces, strainPriorities(loaded, mesh));
  return [
    { name: 'meshoptimizer', version: `${version}, simplify`, run: timed(simplify) },
    {
      name: BEST_PEER,
      version: `${version}, simplifyWithUpdate, Regularize`,
      holdsPins: true,
      run: timed((mesh, faces, pinned) => update(mesh, faces, outlineLocks(mesh, pinned))),
    },
    {
      name: `${BEST_PEER} + strain`,
      version: `${version}, simplifyWithUpdate, Regularize, priority above rank ${STRAINED}`,
      run: timed(strained),
    },
  ];
}
