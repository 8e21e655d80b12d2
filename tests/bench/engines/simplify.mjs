// Simplifies an OBJ mesh with meshoptimizer: simplify.mjs SOURCE.obj RESULT.obj FACES plain|regularize

import { writeFileSync } from 'node:fs';
import { MeshoptSimplifier } from 'meshoptimizer';
import { readObj } from '../bench_meshes.mjs';

/** An error limit, relative to the size, that no result reaches. */
const ANY_ERROR = 1e9;
const [source, target, faces, kind] = process.argv.slice(2);
const { positions, triangles } = readObj(source);
const wanted = 3 * Number(faces);
await MeshoptSimplifier.ready;

function regularized() {
  const indices = triangles.slice();
  const [count] = MeshoptSimplifier.simplifyWithUpdate(
    ...[indices, positions, 3, new Float32Array(0), 0, [], null, wanted, ANY_ERROR, ['Regularize']],
  );
  return indices.slice(0, count);
}

const indices =
  kind === 'regularize'
    ? regularized()
    : MeshoptSimplifier.simplify(triangles, positions, 3, wanted, ANY_ERROR)[0];
const lines = [];
for (let v = 0; v < positions.length; v += 3) lines.push(`v ${positions.slice(v, v + 3).join(' ')}`);
for (let t = 0; t < indices.length; t += 3)
  lines.push(`f ${[...indices.slice(t, t + 3)].map((v) => v + 1).join(' ')}`);
writeFileSync(target, `${lines.join('\n')}\n`);
