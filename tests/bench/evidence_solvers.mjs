// Errors of frequencies by method and by solver, with the original's numbers and tuned: writes a table of docs/evidence.md.
// Usage: npm run build && node tests/bench/evidence_solvers.mjs [--write] [--meshes a,b] [--methods 'a;b'] [--ratio .25]
// Peers and meshes that are absent are left out and listed; results are kept in build/bench, so that a second run is short. The two
// methods of the literature, whose results take minutes, take part where --methods names them.

import { parseArgs } from 'node:util';
import {
  EVIDENCE_MESHES,
  evidenceCases,
  geometricMean,
  reachesTarget,
  twoDigits,
} from './fidelity/evidence_cases.mjs';
import { SOLVERS, solverErrors } from './fidelity/solver_errors.mjs';
import { table, tellMissing, writeSection } from './section.mjs';

const SLOW = ['Lescoat 2020', 'Dunyach 2013'];

const { values: options } = parseArgs({
  options: {
    write: { type: 'boolean', default: false },
    meshes: { type: 'string', default: EVIDENCE_MESHES },
    methods: { type: 'string' },
    ratio: { type: 'string', default: '.25' },
  },
});
const ratio = Number(options.ratio);
const wanted = options.methods?.split(';');
const { loaded, meshes, methods, missing, cases } = await evidenceCases({
  names: options.meshes.split(','),
  ratios: [ratio],
  isWanted: (name) => (wanted ? wanted.includes(name) : !SLOW.includes(name)),
});

/** Untouched and tuned errors of one method in one solver, means over the meshes that have modes there. */
function cell(errors, solver) {
  if (errors === null) return '-';
  const found = errors.map((one) => one[solver]).filter((one) => Number.isFinite(one?.untouched));
  const [untouched, tuned] = ['untouched', 'tuned'].map((of) => geometricMean(found.map((one) => one[of])));
  return found.length > 0 ? `${twoDigits(untouched)} -> ${twoDigits(tuned)}` : '-';
}

/** What `solverErrors` finds on every mesh; null where a result has more faces than asked for by over 2 %. */
function errorsOf(method) {
  const own = cases.filter((one) => one.method === method.name);
  if (!own.every(reachesTarget)) return null;
  return own.map((one) => {
    const mesh = meshes.find(({ name }) => name === one.mesh);
    return solverErrors(loaded, { mesh, method, ratio, meshOf: one.meshOf });
  });
}

const rows = methods.map((method) => {
  const errors = errorsOf(method);
  return [method.name, ...SOLVERS.map((solver) => cell(errors, solver))];
});
const sections = [table(['method', ...SOLVERS], rows)];
console.log(sections.join('\n\n'));
tellMissing(missing);
if (options.write)
  await writeSection({
    name: 'evidence_solvers',
    title: 'By solver',
    document: 'evidence.md',
    remark: `Mean frequency errors of modes 1 to 10 at ${100 * ratio} % of the faces, in %, with the original's parameters -> with the two factors and masses that \`limber tune\` finds for the mesh of any tool. Geometric means over those of ${meshes.map(({ name }) => name).join(', ')} that have modes in the solver: a flat sheet of springs has none. A dash: a result has more faces than requested.`,
    missing,
    sections,
  });
process.exit(0); // the core's threads would keep Node alive
