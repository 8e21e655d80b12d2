// Writes the measured parts of docs/simulation.md: pictures of motions and the paper's Table 2.
// Usage: npm run build && node tests/bench/simulation_document.mjs [--pictures] [--table]
// Without flags it writes both. Needs Chromium for the pictures, and the Eiffel tower in ../shared/meshes or
// $LIMBER_SHARED/meshes.

import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { parseArgs } from 'node:util';
import { format, resolveConfig } from 'prettier';
import { edgesOf } from './bench_meshes.mjs';
import { loadEngine, root } from './fidelity/load_engine.mjs';
import { table } from './fidelity/markdown.mjs';
import { loadMeshes } from './fidelity/meshes.mjs';
import { ourMethods } from './fidelity/methods.mjs';
import { drawPictures } from './fidelity/pictures.mjs';

const { values: options } = parseArgs({
  options: {
    pictures: { type: 'boolean', default: false },
    table: { type: 'boolean', default: false },
  },
});
const wantsAll = !options.pictures && !options.table;
const missing = [];
const loaded = await loadEngine();
const { engine, core } = loaded;
const meshes = loadMeshes(loaded, { names: ['bar', 'eiffel', 'cloth grid'], isWanted: () => true, missing });
const methods = new Map(ourMethods(loaded).map((method) => [method.name, method]));
const meshNamed = (name) => meshes.find((mesh) => mesh.name === name);
const reduced = (mesh, method, faces) => methods.get(method).run(mesh, faces).mesh;

function moved(mesh, other, settings, records) {
  const all = { ...engine.defaultSettings(), ...settings };
  const given = engine.simulationOptions(mesh.prepared, all, null);
  return core.compareMotion(mesh.prepared.mesh, other, { ...given, records, binding: null });
}

// ---- pictures ----

const STRIPS = [
  { mesh: 'bar', file: 'twist-bar', scenario: 'twist', view: [1, 0.4, 1.2], height: 260 },
  { mesh: 'eiffel', file: 'twist-eiffel', scenario: 'twist', view: [0.5, 0.2, 1], height: 360 },
  { mesh: 'cloth grid', file: 'drape-cloth', scenario: 'drape', view: [0.6, 0.5, 1], height: 170 },
];
const [RATIO, STRIP_SECONDS, STRIP_SUBSTEPS, FRAMES] = [0.25, 1.5, 100, 4];

/** Frames of the original above those of its result. */
function stripOf({ mesh: name, file, scenario, view, height }) {
  const mesh = meshNamed(name);
  if (!mesh) return [];
  const result = reduced(mesh, 'limber', RATIO * mesh.faces);
  const settings = { scenario, seconds: STRIP_SECONDS, substeps: STRIP_SUBSTEPS, damping: 1 };
  const motion = moved(mesh, result, settings, true);
  const bodies = [
    ['original', mesh.prepared.mesh, motion.original],
    ['optimized', result, motion.other],
  ];
  const panels = bodies.flatMap(([title, { positions, triangles }, run]) => {
    const steps = run.positions.length / positions.length;
    return Array.from({ length: FRAMES }, (_, i) => {
      const step = Math.round(((i + 1) * steps) / FRAMES) - 1;
      const frame = run.positions.subarray(step * positions.length, (step + 1) * positions.length);
      const note = `${triangles.length / 3} faces, ${((step + 1) / 60).toFixed(2)} s`;
      return { title, note, positions: [...frame], triangles: [...triangles] };
    });
  });
  return [{ file: `${file}.png`, picture: { panels, view, columns: FRAMES, width: 220, height, all: true } }];
}

// ---- Table 2 ----

/** Faces before and after, with milliseconds, as in the paper. */
const PAPER = [
  { mesh: 'bar', title: 'Rectangle', faces: 950, before: 13.6, after: 8.0 },
  { mesh: 'eiffel', title: 'Eiffel', faces: 3832, before: 48.0, after: 34.0 },
];
/** Fractions of the paper's face count at which limber is tried for the same frequency error. */
const SHARES = [1, 0.75, 0.5, 0.35, 0.25, 0.18, 0.12];
const MODE_COUNT = 10;
const [STEP_PARTS, TIMED_MILLISECONDS] = [10, 5000];

function errorOf(mesh, result) {
  const material = engine.materialOf(mesh.prepared, engine.defaultSettings());
  return core.compareFidelity(mesh.prepared.mesh, result, { modeCount: MODE_COUNT, ...material })
    .frequencyErrorMean;
}

/** Milliseconds of each body's shortest step of 2,000 substeps, from alternating tenths, so that the core is often free. */
function stepTimes(mesh, bodies) {
  const settings = { ...engine.defaultSettings(), material: 'springs', substeps: 2000 / STEP_PARTS };
  const given = engine.simulationOptions(mesh.prepared, settings, null);
  const numbers = bodies.map((body) => core.startSimulation(body, mesh.prepared.mesh, given));
  const least = bodies.map(() => Infinity);
  for (const end = performance.now() + TIMED_MILLISECONDS; performance.now() < end;)
    numbers.forEach((number, i) => {
      const start = performance.now();
      core.stepSimulations(Uint32Array.of(number));
      least[i] = Math.min(least[i], performance.now() - start);
    });
  for (const number of numbers) core.endSimulation(number);
  return least.map((milliseconds) => STEP_PARTS * milliseconds);
}

/** The smallest result of limber among those tried whose frequency error is at most `error`. */
function asGoodAs(mesh, error, faces) {
  let best = null;
  for (const share of SHARES) {
    const result = reduced(mesh, 'limber', Math.round(share * faces));
    if (errorOf(mesh, result) > error) break;
    best = result;
  }
  return best;
}

function rowsOf({ mesh: name, title, faces, before, after }) {
  const mesh = meshNamed(name);
  const printed = [title, 'paper, as printed', `${mesh?.faces ?? ''} -> ${faces}`, 'not given'];
  const rows = [[...printed, `${before} -> ${after.toFixed(1)} ms`, `x ${(before / after).toFixed(2)}`, '']];
  if (!mesh) return rows;
  const papers = reduced(mesh, 'paper', faces);
  const small = asGoodAs(mesh, errorOf(mesh, papers), faces);
  const results = [
    ['`--method paper`', papers],
    ['`--method limber`', reduced(mesh, 'limber', faces)],
    ...(small ? [['`limber`, no worse than `paper`', small]] : []),
  ];
  const original = mesh.prepared.mesh;
  const [own, ...times] = stepTimes(mesh, [original, ...results.map(([, result]) => result)]);
  const measured = results.map(([method, result], i) => [
    title,
    method,
    `${mesh.faces} -> ${result.triangles.length / 3}`,
    `${errorOf(mesh, result).toFixed(2)} %`,
    `${own.toFixed(1)} -> ${times[i].toFixed(1)} ms`,
    `x ${(own / times[i]).toFixed(2)}`,
    `x ${(edgesOf(original).length / edgesOf(result).length).toFixed(2)}`,
  ]);
  return [...rows, ...measured];
}

async function writeTable() {
  const path = join(root, 'docs', 'simulation.md');
  const [begin, end] = ['<!-- table 2: begin -->', '<!-- table 2: end -->'];
  const header = [
    'model',
    'method',
    'faces',
    'frequency error',
    'a step',
    'S (Eq. 12)',
    'edges, upper bound of S',
  ];
  const text = readFileSync(path, 'utf8');
  const content = [begin, table(header, PAPER.flatMap(rowsOf)), end].join('\n\n');
  const after = `${text.split(begin)[0]}${content}${text.split(end)[1]}`;
  writeFileSync(path, await format(after, { ...(await resolveConfig(path)), filepath: path }));
  console.log('wrote the table into docs/simulation.md');
}

if (options.pictures || wantsAll) {
  const folder = join(root, 'docs', 'images', 'simulation');
  mkdirSync(folder, { recursive: true });
  await drawPictures(STRIPS.flatMap(stripOf), folder, missing);
}
if (options.table || wantsAll) await writeTable();
if (missing.length) console.log(`MISSING HERE:\n${missing.map((what) => `- ${what}`).join('\n')}`);
process.exit(0);
