// How far the results of every method move apart from their originals: --motion of evaluate.mjs.

import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { format, resolveConfig } from 'prettier';
import { hashOf, root, scratch } from './load_engine.mjs';
import { table, unique } from './markdown.mjs';
import { meanOf } from './targets.mjs';

const SCENARIOS = ['sway', 'twist', 'drape'];
/** Seconds of each motion, and substeps: with fewer, what a fine mesh loses to them hides what a result does. */
const [SECONDS, SUBSTEPS] = [1, 200];
const [BEGIN, END] = ['<!-- motion: begin -->', '<!-- motion: end -->'];

/** { mesh, method, sway, twist, drape: { mean, noise } or null where it has flown apart } of every case. */
export function runMotions(loaded, cases, meshes) {
  const folder = join(scratch, 'motion');
  mkdirSync(folder, { recursive: true });
  return cases.map(({ mesh, method, ratio, faces, meshOf }, i) => {
    const { prepared, hash } = meshes.find(({ name }) => name === mesh);
    const result = meshOf();
    const key = hashOf(loaded.version, hash, result.positions, result.triangles, `${SECONDS} ${SUBSTEPS}`);
    const file = join(folder, `${key}.json`);
    if (!existsSync(file)) writeFileSync(file, JSON.stringify(moveAll(loaded, prepared, result)));
    const motions = JSON.parse(readFileSync(file, 'utf8'));
    const said = SCENARIOS.map((name) => `${name} ${motions[name]?.mean.toFixed(3) ?? 'flew apart'}`);
    console.log(`${i + 1}/${cases.length} ${mesh}, ${method}: ${faces} faces, ${said.join(', ')}`);
    return { mesh, method, ratio, ...motions };
  });
}

function moveAll({ engine, core }, prepared, result) {
  const { positions, triangles } = result;
  const body = { name: 'result', positions, indices: triangles, notes: [], mesh: 0, spans: [], scale: 1 };
  const other = engine.prepareBody(core, body, engine.defaultSettings());
  return Object.fromEntries(
    SCENARIOS.map((scenario) => {
      const settings = { ...engine.defaultSettings(), scenario, seconds: SECONDS, substeps: SUBSTEPS };
      const options = engine.simulationOptions(prepared, settings, null);
      try {
        const motion = core.compareMotion(prepared.mesh, other.mesh, {
          ...options,
          records: false,
          binding: null,
        });
        return [scenario, { mean: motion.deviationMean, noise: motion.noiseFloor }];
      } catch {
        return [scenario, null];
      }
    }),
  );
}

/** A line a method: means over the meshes on which nothing flew apart. */
export function motionTable(motions) {
  const isWhole = (one) => SCENARIOS.every((name) => one[name]);
  const broken = new Set(motions.filter((one) => !isWhole(one)).map(({ mesh }) => mesh));
  const rows = unique(motions.map(({ method }) => method)).map((method) => {
    const own = motions.filter((one) => one.method === method && !broken.has(one.mesh));
    const mean = (key, scenario) => meanOf(own.map((one) => one[scenario][key]));
    const overall = meanOf(SCENARIOS.map((scenario) => mean('mean', scenario)));
    const cells = SCENARIOS.map(
      (name) => `${mean('mean', name).toFixed(3)} (${mean('noise', name).toFixed(4)})`,
    );
    const flown = motions.filter((one) => one.method === method && !isWhole(one)).length;
    return [method, overall.toFixed(3), ...cells, flown];
  });
  return table(['mean over meshes', 'all three', ...SCENARIOS, 'flew apart'], rows);
}

/** A line a mesh, a column a method: the mean over the three motions. */
function meshTable(motions) {
  const methods = unique(motions.map(({ method }) => method));
  const rows = unique(motions.map(({ mesh }) => mesh)).map((mesh) => [
    mesh,
    ...methods.map((method) => {
      const one = motions.find((motion) => motion.mesh === mesh && motion.method === method);
      if (!one || SCENARIOS.some((name) => !one[name])) return 'flew apart';
      return meanOf(SCENARIOS.map((name) => one[name].mean)).toFixed(3);
    }),
  ]);
  return table(['mesh', ...methods], rows);
}

/** Replaces what stands between the markers of docs/simplification.md. */
export async function writeMotions(motions) {
  const path = join(root, 'docs', 'simplification.md');
  const before = readFileSync(path, 'utf8');
  if (!before.includes(BEGIN) || !before.includes(END))
    throw new Error(`${path} has no place for the motions: add "${BEGIN}" and "${END}".`);
  const content = [
    BEGIN,
    'Written by `node tests/bench/fidelity/evaluate.mjs --motion --write`.',
    `Mean distance of 1,000 points of the surface from where the original takes them, over all steps of ${SECONDS} s, in % of the diagonal, at 25 % of the faces; in brackets the noise floor, the same for the original with its constraints in another order. Shell, ${SUBSTEPS} substeps.`,
    motionTable(motions),
    'Each mesh, the mean of the three motions:',
    meshTable(motions),
    END,
  ];
  const after = `${before.split(BEGIN)[0]}${content.join('\n\n')}${before.split(END)[1]}`;
  writeFileSync(path, await format(after, { ...(await resolveConfig(path)), filepath: path }));
  console.log('wrote the motions into docs/simplification.md');
}
