// Time of the modal fit in wasm and its effect on the frequencies, next to the time of computing twelve modes of the same
// mesh, which the page does anyway. Usage: npm run build && node tests/bench/fit.mjs [--write] [--threads 2] [--rounds 2]
// --write puts the table into docs/benchmarks.md. Real meshes are read from ../shared/meshes or $LIMBER_SHARED/meshes;
// absent ones are left out and listed.

import { existsSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { bumpySphere, cloth, largestComponent, readObj, torus } from './bench_meshes.mjs';
import { loadBundledCore, timed } from './modes_tools.mjs';
import { table, tellMissing, writeSection } from './section.mjs';

const { values: options } = parseArgs({
  options: {
    write: { type: 'boolean', default: false },
    threads: { type: 'string', default: '2' },
    rounds: { type: 'string', default: '2' },
  },
});
const root = resolve(import.meta.dirname, '..', '..');
const shared = join(process.env.LIMBER_SHARED ?? join(root, '..', 'shared'), 'meshes');
const rounds = Number(options.rounds);
const kept = 0.25;
const limits = [
  { faces: 12_000, seconds: 1.5 },
  { faces: 110_000, seconds: 30 },
  { faces: 220_000, seconds: 120 }, // more than 20,000 vertices remain: fitted in fewer rounds
];
const material = { young: 1e6, poisson: 0.3, density: 1000, unit: 1 };
const missing = [];

const core = await loadBundledCore(Number(options.threads));

function* meshes() {
  for (const name of ['derived_eiffel_6156', 'spot_uv', 'bob_genus1', 'nefertiti_lowres', 'scorpion_100k']) {
    const path = join(shared, `${name}.obj`);
    if (existsSync(path)) yield { name, ...largestComponent(readObj(path)) };
    else missing.push(`${name}.obj of ../shared/meshes`);
  }
  for (const [name, generate] of Object.entries({ torus, cloth, 'bumpy sphere': bumpySphere }))
    for (const faces of [10_000, 100_000, 200_000]) yield { name, ...generate(faces) };
}

function diagonalOf(positions) {
  let squares = 0;
  for (let axis = 0; axis < 3; axis++) {
    const numbers = positions.filter((_, i) => i % 3 === axis);
    const [low, high] = numbers.reduce(
      ([l, h], x) => [Math.min(l, x), Math.max(h, x)],
      [Infinity, -Infinity],
    );
    squares += (high - low) ** 2;
  }
  return Math.sqrt(squares);
}

const shell = (thickness) => ({
  ...material,
  thickness,
  model: 'shell',
  direction: -1,
  pinned: new Uint32Array(),
  exact: false,
  modeCount: 12,
});

function measure(mesh) {
  const thickness = 0.02 * diagonalOf(mesh.positions);
  const best = { modes: Infinity, fit: Infinity }; // milliseconds
  let fitted, start;
  for (let round = 0; round < rounds; round++) {
    const [modesTime, modes] = timed(() => core.findModes(mesh, shell(thickness)));
    const guidance = { layers: [0, 1, 2, 3, 4, 5], weights: [], p: 2, threshold: 0 };
    const { rank } = core.strainGuidance(mesh, modes, guidance);
    const weights = {
      method: 'limber',
      strainWeight: 1,
      curvatureWeight: 0,
      qualityWeight: 0.1,
      sizeWeight: 0.01,
    };
    const history = core.simplify(mesh, rank, new Float32Array(), weights);
    start = core.meshAt(mesh, history, Math.floor((kept * mesh.triangles.length) / 3));
    const charts = { wedges: new Uint32Array(), groups: new Uint32Array() };
    const locked = new Uint8Array();
    const [fitTime, result] = timed(() =>
      core.fitModes(mesh, start, {
        thickness,
        poisson: material.poisson,
        charts,
        locked,
        pinned: new Uint32Array(),
      }),
    );
    fitted = result;
    best.modes = Math.min(best.modes, modesTime);
    best.fit = Math.min(best.fit, fitTime);
  }
  return { ...best, before: fitted.errorBefore[0], after: fitted.errorAfter[0] };
}

const rows = [];
for (const mesh of meshes()) {
  const faces = mesh.triangles.length / 3;
  const { modes, fit, before, after } = measure(mesh);
  const limit = limits.find((entry) => faces <= entry.faces).seconds;
  const isFitted = before !== undefined; // otherwise the fit would need more memory than available
  const inTime = fit <= 1000 * limit ? `<= ${limit} s: met` : `<= ${limit} s: **missed**`;
  const verdict = isFitted ? inTime : 'not fitted: memory';
  const errors = [before, after].map((error) => (isFitted ? `${error.toFixed(2)} %` : ''));
  const times = [modes, fit].map((time) => `${(time / 1000).toFixed(2)} s`);
  rows.push([mesh.name, faces, ...times, (fit / modes).toFixed(1), verdict, ...errors]);
  console.log(rows.at(-1).join('  '));
}
tellMissing(missing);
if (options.write)
  await writeSection({
    name: 'fit',
    title: 'Modal fit',
    remark: `${options.threads} threads; each time is the minimum of ${rounds}.`,
    missing,
    sections: [
      'The fit of a result with a quarter of the faces. Errors are frequency errors, root mean square over the fitted modes and thicknesses, after the collapses and after the fit.',
      table(['mesh', 'faces', '12 modes', 'fit', 'fit / modes', 'target', 'error before', 'after'], rows),
    ],
  });
process.exit(0);
