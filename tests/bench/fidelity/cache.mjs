// Results on disk, under the hash of all that they depend on: a second run computes only what has changed.

import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { torus, writeMesh } from '../bench_meshes.mjs';
import { hashOf, scratch } from './load_engine.mjs';
import { measure } from './measure.mjs';
import { readMesh } from './python_peers.mjs';

const folder = join(scratch, 'cache');

/** Changes where `measure` gives other numbers: those of a coarse torus beside a fine one, to six digits. */
export function fingerprintOf({ engine, core }) {
  const [fine, coarse] = [torus(1500), torus(500)];
  const { positions, triangles } = fine;
  const body = { name: 'torus', positions, indices: triangles, notes: [], mesh: 0, spans: [], scale: 1 };
  const prepared = engine.prepareBody(core, body, engine.defaultSettings());
  const numbers = measure({ engine, core }, prepared, coarse);
  const rounded = (value) => (typeof value === 'number' ? Number(value.toPrecision(6)) : value);
  return hashOf(JSON.stringify(Object.entries(numbers).map(([key, value]) => [key, rounded(value)])));
}

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
