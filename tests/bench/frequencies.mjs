// Mean error of the first ten frequencies of coarse meshes in solvers, with the original's numbers and with tuned ones.
// Usage: npm run build && node tests/bench/frequencies.mjs [--write] [--ratio .25] [--solvers shell,springs] [NAME...]
// NAME is the beginning of a file's name in ../shared/meshes ($LIMBER_SHARED/meshes). --write puts the tables into
// docs/evidence.md. What is measured of a mesh is kept in build/bench, so that a run that was stopped goes on there.

import { readdirSync } from 'node:fs';
import { join } from 'node:path';
import { parseArgs } from 'node:util';
import { largestComponent, readObj } from './bench_meshes.mjs';
import { cached } from './fidelity/cache.mjs';
import { hashOf, loadEngine, root } from './fidelity/load_engine.mjs';
import { SOLVERS, frequenciesIn } from './fidelity/solver_errors.mjs';
import { table, writeSection } from './section.mjs';

const BASES = {
  limber: { method: 'limber' },
  'fit off': { method: 'limber', fit: 'off' },
  qem: { method: 'qem', fit: 'off' },
};
const TUNES = ['global', 'constraint'];
const BODIES = [
  'spot_uv',
  'blub_fish.',
  'bob',
  'goathead',
  'torus',
  'nefertiti',
  'pyramid',
  'derived_rectangle',
];
const SHEETS = ['derived_cloth', 'bowl', 'ribbon', 'skirt', 'tablecloth', 'mountain'];

const { values: options, positionals } = parseArgs({
  options: {
    ratio: { type: 'string', default: '0.25' },
    solvers: { type: 'string', default: SOLVERS.join(',') },
    bases: { type: 'string', default: Object.keys(BASES).join(',') },
    tunes: { type: 'string', default: TUNES.join(',') },
    write: { type: 'boolean', default: false },
  },
  allowPositionals: true,
});
const [solvers, bases, tunes] = [options.solvers, options.bases, options.tunes].map((list) =>
  list.split(','),
);
const names = positionals.length > 0 ? positionals : [...BODIES, ...SHEETS];
const shared = join(process.env.LIMBER_SHARED ?? join(root, '..', 'shared'), 'meshes');
const loaded = await loadEngine();
const { engine, core } = loaded;

function prepare(name) {
  const file = readdirSync(shared).find((candidate) => candidate.startsWith(name));
  if (!file) throw new Error(`No file of ${shared} begins with ${name}.`);
  const source = readObj(join(shared, file));
  const welded = core.weld(source.positions, source.triangles, { tolerance: 0 }).mesh;
  const { positions, triangles } = largestComponent(welded);
  const body = { name, positions, indices: triangles, notes: [], mesh: 0, spans: [], scale: 1 };
  return engine.prepareBody(core, body, engine.defaultSettings());
}

/** What a row of the printed table has of `TunedFrequencies`. */
const COLUMNS = [
  { of: 'errorUntouched', title: 'untouched' },
  { of: 'errorTuned', title: 'tuned' },
  { of: 'errorUnseen', title: 'modes 21 to 30' },
  { of: 'errorOtherPins', title: 'other clamping' },
];

const number = (value, digits = 1) => (Number.isFinite(value) ? value.toFixed(digits) : '-');

/** The rows of a mesh, one for each base, solver and way of tuning. */
const rowsOf = (name) =>
  cached(hashOf('frequencies', loaded.version, name, options.ratio, ...solvers, ...bases, ...tunes), () => ({
    record: measure(name),
  })).record;

function measure(name) {
  const prepared = prepare(name);
  const targetFaces = Math.floor((Number(options.ratio) * prepared.mesh.triangles.length) / 3);
  return bases.flatMap((base) => {
    const settings = { ...engine.defaultSettings(BASES[base].method), maxDeviation: 0, ...BASES[base] };
    const { result } = engine.optimizeBody(core, prepared, settings, { targetFaces });
    const { distance, quality } = engine.measureResult(core, prepared, result);
    const shape = { mean: distance.mean, hausdorff: distance.hausdorff, angle: quality.meanMinAngle };
    const faces = result.mesh.triangles.length / 3;
    return solvers.flatMap((solver) =>
      tunes.map((tune) => {
        const frequencies = frequenciesIn(loaded, prepared, result.mesh, { solver, tune });
        return { name, base, solver, tune, faces, ...shape, frequencies };
      }),
    );
  });
}

/** The mean over the meshes that have such modes, and how many these are. */
function meanOf(rows, of) {
  const errors = rows.map(({ frequencies }) => frequencies?.[of]).filter(Number.isFinite);
  return errors.length > 0 ? errors.reduce((sum, error) => sum + error, 0) / errors.length : NaN;
}

/** Means by solver and result: untouched, tuned by two factors and by a factor per constraint. */
function meansTable(rows) {
  const lines = solvers.flatMap((solver) =>
    bases.map((base) => {
      const own = rows.filter((row) => row.solver === solver && row.base === base);
      const [two, all] = TUNES.map((tune) => own.filter((row) => row.tune === tune));
      const cells = [...COLUMNS.map(({ of }) => meanOf(two, of)), meanOf(all, 'errorTuned')];
      return [solver, base, ...cells.map((cell) => number(cell))];
    }),
  );
  return table(['solver', 'result', ...COLUMNS.map(({ title }) => title), 'a factor per constraint'], lines);
}

/** Two factors, mesh by mesh: untouched -> tuned. */
function meshTable(rows, base) {
  const lines = names.map((name) => {
    const cells = solvers.map((solver) => {
      const { frequencies } = rows.find(
        (row) => row.name === name && row.base === base && row.solver === solver && row.tune === 'global',
      );
      return `${number(frequencies?.errorUntouched)} -> ${number(frequencies?.errorTuned)}`;
    });
    return [name.replace(/[._]$/, ''), ...cells];
  });
  return table(['', ...solvers], lines);
}

async function write(rows) {
  const of = (kind) => rows.filter(({ name }) => kind.includes(name));
  const [bodies, sheets] = [BODIES, SHEETS].map((kind) => names.filter((name) => kind.includes(name)).length);
  await writeSection({
    name: 'frequencies',
    title: 'Frequencies in four solvers',
    document: 'evidence.md',
    remark: `Mean errors of ten frequencies (%) of results with ${100 * options.ratio} % of the faces, means over ${bodies} bodies and ${sheets} sheets, in our models of four kinds of solvers, untouched and tuned by two factors and the masses, and in the last column tuned by a factor per constraint. Tuning fits 20 modes of the free body and 8 of the body clamped at one end; modes 21 to 30 and those of the other clamping are not fitted. A dash: the body has no such modes there, as a flat sheet of springs.`,
    missing: [],
    sections: [
      '### Bodies, means',
      meansTable(of(BODIES)),
      '### Sheets, means',
      meansTable(of(SHEETS)),
      '### Two factors, `limber`, mesh by mesh',
      meshTable(rows, 'limber'),
    ],
  });
}

const rows = [];
for (const name of names)
  for (const row of rowsOf(name)) {
    rows.push(row);
    const { name: mesh, base, solver, tune, faces, mean, hausdorff, frequencies } = row;
    const shape = [faces, mean.toFixed(4), hausdorff.toFixed(3)];
    const errors = COLUMNS.map(({ of }) => number(frequencies?.[of], 2));
    console.log([mesh, base, solver, tune, ...shape, ...errors].join('\t'));
  }
if (options.write) await write(rows);
process.exit(0); // threads of the core would keep it waiting
