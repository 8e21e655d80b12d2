// The targets of the evaluation and whether they are met, from the cases of run_cases.mjs.

import { BEST_PEER } from './meshoptimizer_peers.mjs';

/** The method that has to meet the targets. */
export const SUBJECT = 'limber';
const RATIO = 0.25;
/** Distances below this, in % of the diagonal, count as 0. */
const UNSEEN = 1e-4;

const NOT_KNOWN = ['no mesh to tell', null];

export const meanOf = (values) => values.reduce((sum, value) => sum + value, 0) / values.length;

/** Whether a result has the target face count to 1 %; others are not compared in size-dependent numbers. */
export const reachedCount = ({ faces, targetFaces }) => faces <= 1.01 * targetFaces;

/** Pairs of both methods' cases on the same mesh, if both reached the count and could be measured. */
function pairsOf(cases, first, second) {
  const of = (method) =>
    cases.filter((one) => one.ratio === RATIO && one.method === method && !one.failure && reachedCount(one));
  return of(first).flatMap((a) =>
    of(second)
      .filter((b) => b.mesh === a.mesh)
      .map((b) => [a, b]),
  );
}

/** The mean over the meshes of `first` divided by that of `second`. */
function ratioOfMeans(cases, [first, second], key, limit) {
  const pairs = pairsOf(cases, first, second);
  if (pairs.length === 0) return NOT_KNOWN;
  const [a, b] = [0, 1].map((side) => meanOf(pairs.map((pair) => pair[side][key])));
  const text = `${a.toFixed(3)} / ${b.toFixed(3)} = ${(a / b).toFixed(3)}`;
  return [`${text} (${pairs.length} meshes)`, a / b <= limit];
}

/** The median ratio of `first` to `second` over meshes where either is visible; lists the meshes above the limit. */
function medianRatio(cases, [first, second], key, limit) {
  const pairs = pairsOf(cases, first, second).filter(([a, b]) => Math.max(a[key], b[key]) > UNSEEN);
  if (pairs.length === 0) return NOT_KNOWN;
  const ratios = pairs.map(([a, b]) => ({ mesh: a.mesh, ratio: a[key] / b[key] }));
  ratios.sort((a, b) => a.ratio - b.ratio);
  const median = ratios[Math.floor(ratios.length / 2)].ratio;
  const above = ratios.filter(({ ratio }) => ratio > limit);
  const names = above.map(({ mesh, ratio }) => `${mesh} ${ratio.toFixed(2)}`).join(', ');
  const found = `median of the ratios ${median.toFixed(3)} (${pairs.length} meshes)`;
  return [above.length > 0 ? `${found}; above on ${names}` : found, median <= limit];
}

function neverWorse(cases) {
  const pairs = pairsOf(cases, SUBJECT, BEST_PEER);
  if (pairs.length === 0) return NOT_KNOWN;
  const worse = pairs.filter(([a, b]) => a.frequencyErrorMean > b.frequencyErrorMean);
  const names = worse.map(([a]) => a.mesh).join(', ');
  return [worse.length > 0 ? `worse on ${names}` : `on none of ${pairs.length}`, worse.length === 0];
}

/** The minimum of `key` over the subject's meshes of these kinds that reached the count; lists those below the limit. */
function atLeast(cases, key, limit, kinds) {
  const all = cases.filter(
    ({ method, ratio, kind, failure }) =>
      method === SUBJECT && ratio === RATIO && kinds.includes(kind) && !failure,
  );
  const own = all.filter(reachedCount);
  if (own.length === 0) return NOT_KNOWN;
  const named = (some) => some.map((one) => `${one.mesh} ${one[key].toFixed(3)}`).join(', ');
  const below = own.filter((one) => one[key] < limit);
  const lowest = Math.min(...own.map((one) => one[key])).toFixed(3);
  const found = below.length > 0 ? `below on ${named(below)}` : `lowest ${lowest}`;
  const others = all.filter((one) => !reachedCount(one));
  const aside = others.length > 0 ? ` (count not reached: ${named(others)})` : '';
  return [found + aside, below.length === 0];
}

function topologyKept(cases) {
  const own = cases.filter(({ method }) => method === SUBJECT);
  if (own.length === 0) return NOT_KNOWN;
  const changed = own.filter((one) => !one.topologyKept);
  const names = changed.map(({ mesh, ratio }) => `${mesh} at ${100 * ratio} %`).join(', ');
  const found = changed.length > 0 ? `changed on ${names}` : `in none of ${own.length} cases`;
  return [found, changed.length === 0];
}

const ANY_KIND = ['organic', 'cloth', 'hard'];
const againstPeer = (title, key, share) => [
  `${title}: at most 1/${share} of ${BEST_PEER}`,
  (cases) => ratioOfMeans(cases, [SUBJECT, BEST_PEER], key, 1 / share),
];

/** [target in words, cases -> [value in words, whether the target is met (null: unknown)]] */
export const TARGETS = [
  againstPeer('Frequency error, modes 1-10', 'frequencyErrorMean', 6),
  againstPeer('The same after the best single factor', 'frequencyErrorCalibrated', 4),
  againstPeer('At half the thickness', 'frequencyErrorThin', 5),
  againstPeer('At twice the thickness', 'frequencyErrorThick', 5),
  againstPeer('Modes 11-20', 'frequencyErrorHigh', 3),
  [`Modes 1-10: never worse than ${BEST_PEER} on any mesh`, neverWorse],
  ['Lowest subspace MAC: at least 0.98 on every mesh', (cases) => atLeast(cases, 'macMin', 0.98, ANY_KIND)],
  [
    'Mean distance of the surface: at most 1.3 of our qem',
    (cases) => ratioOfMeans(cases, [SUBJECT, 'qem'], 'meanDistance', 1.3),
  ],
  [
    "Mean distance of our qem: at most 1.05 of pymeshlab's",
    (cases) => medianRatio(cases, ['qem', 'pymeshlab'], 'meanDistance', 1.05),
  ],
  [
    'Smallest angle: at least 8 degrees on every mesh whose input has as much',
    (cases) => {
      const allowing = cases.filter(({ inputMinAngle }) => inputMinAngle >= 8);
      return atLeast(allowing, 'minAngle', 8, ANY_KIND);
    },
  ],
  [
    'Mean smallest angle: at least 38 degrees on every organic mesh',
    (cases) => atLeast(cases, 'meanMinAngle', 38, ['organic']),
  ],
  [
    'Mean smallest angle: at least 40 degrees on every cloth',
    (cases) => atLeast(cases, 'meanMinAngle', 40, ['cloth']),
  ],
  ['Topology: never changed, at any count', topologyKept],
];
