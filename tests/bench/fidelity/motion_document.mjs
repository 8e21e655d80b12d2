// Writes the tables of --motion into docs/results.md.

import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { format, resolveConfig } from 'prettier';
import { wrapProse } from '../prose.mjs';
import { root } from './load_engine.mjs';
import { table, unique } from './markdown.mjs';
import { MOTIONS, SECONDS, SOLVER, SUBSTEPS } from './motion.mjs';
import { meanOf } from './targets.mjs';

const [BEGIN, END] = ['<!-- motion: begin -->', '<!-- motion: end -->'];
const names = Object.keys(MOTIONS);
const isWhole = (one) => names.every((name) => one[name] !== null);

/** One line per method: means over the meshes on which nothing diverged. */
export function motionTable(motions) {
  const broken = new Set(motions.filter((one) => !isWhole(one)).map(({ mesh }) => mesh));
  const whole = motions.filter(({ mesh }) => !broken.has(mesh));
  const rows = unique(motions.map(({ method }) => method)).map((method) => {
    const own = whole.filter((one) => one.method === method);
    const means = names.map((name) => meanOf(own.map((one) => one[name])));
    const diverged = motions.filter((one) => one.method === method && !isWhole(one)).length;
    return [method, ...[meanOf(means), ...means].map((mean) => mean.toFixed(3)), diverged];
  });
  const count = unique(whole.map(({ mesh }) => mesh)).length;
  return table([`mean over ${count} meshes`, 'all three', ...names, 'diverged'], rows);
}

/** One line per mesh and motion, one column per method. */
function meshTable(motions) {
  const methods = unique(motions.map(({ method }) => method)).filter((method) => method !== SOLVER);
  const rows = unique(motions.map(({ mesh }) => mesh)).flatMap((mesh) =>
    names.map((name) => [
      `${mesh}, ${name}`,
      ...methods.map((method) => {
        const one = motions.find((motion) => motion.mesh === mesh && motion.method === method);
        return one?.[name]?.toFixed(3) ?? 'diverged';
      }),
    ]),
  );
  return table(['mesh, motion', ...methods], rows);
}

/** Replaces the text between the markers of docs/results.md. */
export async function writeMotions(motions) {
  const path = join(root, 'docs', 'results.md');
  const before = readFileSync(path, 'utf8');
  if (!before.includes(BEGIN) || !before.includes(END))
    throw new Error(`${path} has no place for the motions: add "${BEGIN}" and "${END}".`);
  const meshes = unique(motions.map(({ mesh }) => mesh.split(' ')[0])).join(',');
  const content = [
    BEGIN,
    `Written by \`node tests/bench/fidelity/evaluate.mjs --motion --meshes ${meshes} --write\`.`,
    `Mean distance of 1,000 points of the surface from their positions on the original, over all steps of ${SECONDS} s, in % of the diagonal, at 25 % of the faces. Shell, ${SUBSTEPS} substeps. "With pins": the simplifier was given the pins (ours by \`--pins\`, meshoptimizer by locking the outline of the pinned part); \`drape\` pins nothing. The first row is the error of the solver itself.`,
    motionTable(motions),
    'Each mesh and motion:',
    meshTable(motions),
    END,
  ];
  const after = `${before.split(BEGIN)[0]}${wrapProse(content.join('\n\n'))}${before.split(END)[1]}`;
  writeFileSync(path, await format(after, { ...(await resolveConfig(path)), filepath: path }));
  console.log('wrote the motions into docs/results.md');
}
