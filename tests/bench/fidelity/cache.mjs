// Stores results on disk under a hash of all their inputs, so that a second run computes only what has changed.

import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { writeMesh } from '../bench_meshes.mjs';
import { scratch } from './load_engine.mjs';
import { readMesh } from './python_peers.mjs';

const folder = join(scratch, 'cache');

/** The file of a case's result mesh; the record is next to it. */
const pathOf = (key, ending) => join(folder, `${key}.${ending}`);

/** The result of `compute() -> { record, mesh? }`, or the stored one for the same key; the mesh, if any, is read on demand. */
export function cached(key, compute) {
  const recordFile = pathOf(key, 'json');
  const meshOf = () => readMesh(pathOf(key, 'bin'));
  if (existsSync(recordFile)) return { record: JSON.parse(readFileSync(recordFile, 'utf8')), meshOf };
  const { record, mesh } = compute();
  mkdirSync(folder, { recursive: true });
  if (mesh) writeMesh(pathOf(key, 'bin'), mesh);
  writeFileSync(recordFile, JSON.stringify(record));
  return { record, meshOf };
}
