// What collapses and each fit keep of sheets: area, length of the outline, corners, bounding box; and distance and
// triangles, beside `--method qem` of the same run. Every result has a quarter of the faces (or --ratio).
// Usage: npm run build && node tests/bench/outline.mjs [--ratio .25] [--variants off,surface] [NAME...]
// A NAME is that of a generated sheet or the beginning of a file's in ../shared/meshes ($LIMBER_SHARED/meshes).

import { readdirSync } from 'node:fs';
import { join } from 'node:path';
import { parseArgs } from 'node:util';
import { largestComponent, readObj } from './bench_meshes.mjs';
import { loadEngine, root } from './fidelity/load_engine.mjs';
import { flatCloth, letterSheet } from './outline_sheets.mjs';
import { compareOutlines, outlineOf } from './outline_measures.mjs';

const { values: options, positionals } = parseArgs({
  options: {
    ratio: { type: 'string', default: '0.25' },
    variants: { type: 'string', default: '' },
    json: { type: 'boolean', default: false },
  },
  allowPositionals: true,
});
const shared = join(process.env.LIMBER_SHARED ?? join(root, '..', 'shared'), 'meshes');
const GENERATED = { 'flat-cloth': () => flatCloth(40), 'letter-sheet': () => letterSheet(6) };
const DEFAULT = [
  ...['flat-cloth', 'letter-sheet', 'hanging-cloth', 'derived_cloth_grid_3200', 'tablecloth'],
  ...['mountain_open_sheet', 'bowl', 'ribbon', 'skirt_4k', 'font_tao'],
];

const loaded = await loadEngine();
const { engine, core } = loaded;
const variants = options.variants ? options.variants.split(',') : engine.OPTIONS.fit.choices;

function sourceOf(name) {
  if (name in GENERATED) return GENERATED[name]();
  if (name === 'hanging-cloth') return engine.samples.find(({ id }) => id === 'cloth').make();
  const file = readdirSync(shared).find((candidate) => candidate.startsWith(name));
  if (!file) throw new Error(`No mesh is called ${name}: name a generated sheet or a file of ${shared}.`);
  return readObj(join(shared, file));
}

function prepare(name) {
  const source = sourceOf(name);
  const welded = core.weld(source.positions, source.triangles, { tolerance: 0 }).mesh;
  const { positions, triangles } = largestComponent(welded);
  const body = { name, positions, indices: triangles, notes: [], mesh: 0, spans: [], scale: 1 };
  return engine.prepareBody(core, body, engine.defaultSettings());
}

/** One result: outline, distance and triangles. */
function measure(prepared, changes) {
  const settings = { ...engine.defaultSettings(changes.method), maxDeviation: 0, ...changes };
  const targetFaces = Math.floor((Number(options.ratio) * prepared.mesh.triangles.length) / 3);
  const { result, seconds } = engine.optimizeBody(core, prepared, settings, { targetFaces });
  const { distance, quality } = engine.measureResult(core, prepared, result);
  return {
    faces: result.mesh.triangles.length / 3,
    seconds,
    ...compareOutlines(outlineOf(prepared.mesh), outlineOf(result.mesh)),
    mean: distance.mean,
    hausdorff: distance.hausdorff,
    angle: quality.meanMinAngle,
  };
}

const fixed = (value, digits) => (value === null ? '-' : value.toFixed(digits)).padStart(9);
const HEAD = [
  'faces',
  'area %',
  'outline %',
  'corners',
  'moved',
  'most',
  'box',
  'mean',
  '/ qem',
  'far',
  '/ qem',
  'angle',
  's',
];
const rows = [];
console.log(`${'mesh'.padEnd(26)}${'variant'.padEnd(9)}${HEAD.map((word) => word.padStart(9)).join('')}`);
for (const name of positionals.length ? positionals : DEFAULT) {
  const prepared = prepare(name);
  const qem = measure(prepared, { method: 'qem' });
  for (const variant of ['qem', ...variants]) {
    const found = variant === 'qem' ? qem : measure(prepared, { method: 'limber', fit: variant });
    const cells = [
      fixed(found.faces, 0),
      fixed(found.area, 3),
      fixed(found.length, 3),
      fixed(found.corners, 0),
      ...[found.cornerMean, found.cornerMost, found.box].map((value) => fixed(value, 3)),
      fixed(found.mean, 4),
      fixed(found.mean / qem.mean, 2),
      fixed(found.hausdorff, 3),
      fixed(found.hausdorff / qem.hausdorff, 2),
      fixed(found.angle, 1),
      fixed(found.seconds, 2),
    ];
    console.log(`${name.padEnd(26)}${variant.padEnd(9)}${cells.join('')}`);
    rows.push({ name, variant, ...found, ratio: found.mean / qem.mean, reached: qem.faces === found.faces });
  }
}
for (const variant of variants) {
  const same = rows.filter((row) => row.variant === variant && row.reached);
  const mean = same.reduce((sum, { ratio }) => sum + ratio, 0) / same.length;
  console.log(`${variant}: mean distance ${mean.toFixed(3)} x qem over ${same.length} meshes of equal count`);
}
if (options.json) console.log(JSON.stringify(rows));
