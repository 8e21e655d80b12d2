// Results on disk, under the hash of all that they depend on: a second run computes only what has changed.

import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { writeMesh } from '../bench_meshes.mjs';
import { scratch } from './load_engine.mjs';
import { readMesh } from './python_peers.mjs';

const folder = join(scratch, 'cache');

/** Where the result mesh of a case lies; the record lies beside it. */
const pathOf = (key, ending) => join(folder, `${key}.${ending}`);

/** What `compute() -> { record, mesh }` gives, or has given for the same key; the mesh is read again when it is asked for. */
export function cached(key, compute) {
  const recordFile = pathOf(key, 'json');
  const meshOf = () => readMesh(pathOf(key, 'bin'));
  if (existsSync(recordFile)) return { record: JSON.parse(readFileSync(recordFile, 'utf8')), meshOf };
  const { record, mesh } = compute();
  mkdirSync(folder, { recursive: true });
  writeMesh(pathOf(key, 'bin'), mesh);
  writeFileSync(recordFile, JSON.stringify(record));
  return { record, meshOf };
}
