// Errors at equal numbers of faces, and faces at equal errors, by method: writes the tables of docs/evidence.md.
// Usage: npm run build && node tests/bench/evidence.mjs [--write] [--meshes a,b] [--methods 'a;b'] [--ratios .9,.5]
// Peers and meshes that are absent are left out and listed; results are kept in build/bench, so that a second run is short.

import { parseArgs } from 'node:util';
import {
  EVIDENCE_MESHES,
  evidenceCases,
  geometricMean,
  reachesTarget,
  twoDigits,
} from './fidelity/evidence_cases.mjs';
import { speedUp } from './fidelity/speed_up.mjs';
import { table, tellMissing, writeSection } from './section.mjs';

const { values: options } = parseArgs({
  options: {
    write: { type: 'boolean', default: false },
    meshes: { type: 'string', default: EVIDENCE_MESHES },
    methods: { type: 'string' },
    ratios: { type: 'string', default: '.9,.5,.25,.1,.05' },
  },
});
const ratios = options.ratios.split(',').map(Number);
const wanted = options.methods?.split(';');
const { loaded, meshes, methods, missing, cases } = await evidenceCases({
  names: options.meshes.split(','),
  ratios,
  isWanted: (name) => !wanted || wanted.includes(name),
});

const MEASURES = [
  { title: 'Mean distance, % of the diagonal', of: (one) => one.meanDistance, levels: [0.05, 0.1, 0.2] },
  {
    title: 'Mean frequency error of modes 1 to 10 as shells, %',
    of: (one) => one.frequencyErrorMean,
    levels: [1, 2, 5],
  },
];

const shown = (value) => (value === null ? '-' : twoDigits(value));

/** The geometric mean over the meshes; null where a result has more faces than asked for by over 2 %, or none. */
function meanOf(method, ratio, of) {
  const own = cases.filter((one) => one.method === method.name && one.ratio === ratio);
  const isWhole = own.every((one) => reachesTarget(one) && Number.isFinite(of(one)));
  return isWhole && own.length === meshes.length ? geometricMean(own.map(of)) : null;
}

/** The default, at whose results the speed of simulations is measured: it follows from the number of faces. */
const TIMED = 'limber, surface fit';

/** By ratio, descending, how many times as fast as the original's a simulation of the result is: the geometric mean over the meshes. */
const speeds = [];
for (const ratio of ratios) {
  const timed = cases.filter((one) => one.method === TIMED && one.ratio === ratio);
  const found = [];
  for (const one of timed) {
    const original = meshes.find(({ name }) => name === one.mesh);
    found.push(await speedUp(loaded, original, one.meshOf()));
  }
  speeds.push({ ratio, speed: found.length > 0 ? geometricMean(found) : null });
}

/** At a share of the faces, by interpolation of logarithms; null where it was not measured. */
function speedAt(share) {
  const known = speeds.filter(({ speed }) => speed !== null);
  const i = known.findIndex(({ ratio }) => ratio <= share);
  if (i < 0) return null;
  const [a, b] = [i === 0 ? { ratio: 1, speed: 1 } : known[i - 1], known[i]];
  return a.speed * (b.speed / a.speed) ** (Math.log(share / a.ratio) / Math.log(b.ratio / a.ratio));
}

function shownShare(share) {
  const speed = speedAt(share);
  return `${shown(100 * share)} %${speed === null ? '' : ` (${shown(speed)} x)`}`;
}

/** The share of the faces at which an error is reached, by interpolation of logarithms; words where it is out of range. */
function shareAt(points, level) {
  const known = points.filter(({ error }) => error !== null).sort((a, b) => b.ratio - a.ratio);
  if (known.length === 0) return '-';
  if (known[0].error > level) return `> ${shownShare(known[0].ratio)}`;
  for (let i = 1; i < known.length; ++i) {
    const [a, b] = [known[i - 1], known[i]];
    if (b.error < level) continue;
    const t = Math.log(level / a.error) / Math.log(b.error / a.error);
    return shownShare(a.ratio * (b.ratio / a.ratio) ** t);
  }
  return `< ${shownShare(known.at(-1).ratio)}`;
}

const sections = MEASURES.flatMap(({ title, of, levels }) => {
  const rows = methods.map((method) => ({
    name: method.name,
    points: ratios.map((ratio) => ({ ratio, error: meanOf(method, ratio, of) })),
  }));
  return [
    `### ${title}`,
    table(
      ['method', ...ratios.map((ratio) => `at ${100 * ratio} % of the faces`)],
      rows.map(({ name, points }) => [name, ...points.map(({ error }) => shown(error))]),
    ),
    'The inverse: the percentage of the faces at which this error is reached, and the speed of a simulation at that size relative to the original.',
    table(
      ['method', ...levels.map((level) => `${level} %`)],
      rows.map(({ name, points }) => [name, ...levels.map((level) => shareAt(points, level))]),
    ),
  ];
});

const topology = methods.map(({ name }) => {
  const own = cases.filter(({ method }) => method === name);
  const lost = own.filter(({ topologyKept }) => !topologyKept).length;
  return [
    name,
    `${lost} of ${own.length}`,
    shown(own.reduce((sum, { seconds }) => sum + seconds, 0) / own.length),
  ];
});
sections.push(
  '### Topology and time',
  table(['method', 'results whose topology differs', 'mean time, s'], topology),
);

console.log(sections.join('\n\n'));
tellMissing(missing);
if (options.write)
  await writeSection({
    name: 'evidence',
    title: 'Equal faces, equal errors',
    document: 'evidence.md',
    remark: `Geometric means over ${meshes.map(({ name, faces }) => `${name} (${faces} faces)`).join(', ')}. A dash: a result has more faces than requested, or no value can be measured.`,
    missing,
    sections,
  });
process.exit(0); // the core's threads would keep Node alive
