// Time of the whole history and of meshAt, in wasm on one thread, against meshoptimizer's simplify to 25 %.
// Usage: npm run build && node tests/bench/simplify.mjs [--write] [--rounds 5] [--largest 1000000]
// --write puts the tables into docs/benchmarks.md. Ours and the peer alternate in one process; numbers are minima.
// Real meshes are read from ../shared/meshes or $LIMBER_SHARED/meshes; absent ones are left out and listed.

import { existsSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { MeshoptSimplifier } from 'meshoptimizer';
import { bumpySphere, cloth, largestComponent, readObj, torus } from './bench_meshes.mjs';
import { loadBundledCore, timed } from './modes_tools.mjs';
import { table, tellMissing, writeSection } from './section.mjs';

const { values: options } = parseArgs({
  options: {
    write: { type: 'boolean', default: false },
    rounds: { type: 'string', default: '5' },
    largest: { type: 'string', default: '1000000' },
  },
});
const root = resolve(import.meta.dirname, '..', '..');
const shared = join(process.env.LIMBER_SHARED ?? join(root, '..', 'shared'), 'meshes');
const rounds = Number(options.rounds);
const generators = { torus, cloth, 'bumpy sphere': bumpySphere };
const missing = [];
const kept = 0.25;
const million = 900_000;
const weights = {
  qem: { method: 'qem', strainWeight: 0, curvatureWeight: 0, qualityWeight: 0, sizeWeight: 0 },
  limber: { method: 'limber', strainWeight: 1, curvatureWeight: 0, qualityWeight: 0.1, sizeWeight: 0.01 },
};

await MeshoptSimplifier.ready;
const core = await loadBundledCore(1);

function* meshes() {
  for (const name of ['skirt_4k', 'spot_uv', 'bob_genus1', 'hammer_60k', 'scorpion_100k']) {
    const path = join(shared, `${name}.obj`);
    if (existsSync(path)) yield { name, ...largestComponent(readObj(path)) };
    else missing.push(`${name}.obj of ../shared/meshes`);
  }
  for (const faces of [10_000, 40_000, 200_000, 1_000_000])
    for (const [name, generate] of Object.entries(generators))
      if (faces <= Number(options.largest)) yield { name, ...generate(faces) };
}

/** A field that varies over the body, used instead of a strain rank. */
function strainOf({ positions, triangles }) {
  return Float32Array.from({ length: triangles.length / 3 }, (_, t) => {
    const [x, y] = positions.subarray(3 * triangles[3 * t], 3 * triangles[3 * t] + 2);
    return 0.5 + 0.4 * Math.sin(3 * x + y);
  });
}

/** The same with mesh and history kept in the core, as for a tick of the page's slider. */
function tick(mesh, history, target) {
  const [kept, keptHistory] = [core.keepMesh(mesh), core.keepHistory(history)];
  const measured = timed(() => core.meshAt(kept, keptHistory, target));
  core.releaseHistory(keptHistory);
  core.releaseMesh(kept);
  return measured;
}

function race(mesh) {
  const faces = mesh.triangles.length / 3;
  const target = Math.floor(kept * faces);
  const strain = strainOf(mesh);
  const none = new Float32Array();
  const best = { peer: Infinity, qem: Infinity, limber: Infinity, meshAt: Infinity, tick: Infinity };
  const note = (name, [milliseconds, result]) => {
    best[name] = Math.min(best[name], milliseconds);
    return result;
  };
  for (let round = 0; round < (faces > million ? Math.min(rounds, 2) : rounds); round++) {
    note(
      'peer',
      timed(() => MeshoptSimplifier.simplify(mesh.triangles, mesh.positions, 3, 3 * target, 1)),
    );
    for (const method of ['qem', 'limber']) {
      const history = note(
        method,
        timed(() => core.simplify(mesh, strain, none, weights[method])),
      );
      note(
        'meshAt',
        timed(() => core.meshAt(mesh, history, target)),
      );
      note('tick', tick(mesh, history, target));
    }
  }
  return { ...best, faces, heapBytes: core.peakHeapBytes() };
}

const milliseconds = (value) => `${value.toFixed(value < 10 ? 1 : 0)} ms`;
const against = (ours, theirs, limit) =>
  `${(ours / theirs).toFixed(2)} ${ours <= limit * theirs ? '(met)' : '(**missed**)'}`;

const rows = [];
const large = [];
for (const mesh of meshes()) {
  const { peer, qem, limber, meshAt, tick: ticked, faces, heapBytes } = race(mesh);
  const ratios = [against(qem, peer, 2), against(limber, peer, 4)];
  const times = [peer, qem, limber].map(milliseconds);
  const inTime = ticked <= (faces > million ? 25 : 16) ? '' : ' (**missed**)';
  rows.push([
    mesh.name,
    faces,
    ...times,
    ...ratios,
    milliseconds(meshAt),
    `${milliseconds(ticked)}${inTime}`,
  ]);
  console.log(rows.at(-1).join('  '));
  if (faces <= million) continue;
  const met = Math.max(qem, limber) <= 5000 && heapBytes <= 1.5 * 2 ** 30 ? 'met' : '**MISSED**';
  large.push([mesh.name, faces, ...times.slice(1), `${(heapBytes / 2 ** 20).toFixed(0)} MiB`, met]);
}

const sections = [
  '### The whole history compared with a simplification to 25 %',
  "Ours goes down to the floor and records every collapse, so that any count can be shown; the peer, meshoptimizer's `simplify`, stops at a quarter of the faces. Both run in wasm on one thread; all copies into and out of its memory are included. A slider tick is `meshAt` with mesh and history kept in the core.",
  table(
    [
      'mesh',
      'faces',
      'peer',
      'qem',
      'limber',
      'qem / peer <= 2',
      'limber / peer <= 4',
      'meshAt',
      'slider tick',
    ],
    rows,
  ),
];
if (large.length > 0)
  sections.push(
    '### A million faces',
    table(['mesh', 'faces', 'qem', 'limber', 'wasm memory', '<= 5 s and 1.5 GiB'], large),
  );
tellMissing(missing);
if (options.write)
  await writeSection({
    name: 'simplify',
    title: 'Simplification',
    remark: `Our runs and the peer's alternated, ${rounds} rounds (two for a million faces); each number is the minimum.`,
    missing,
    sections,
  });
