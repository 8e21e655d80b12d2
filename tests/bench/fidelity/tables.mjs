// The tables of docs/results.md, in Markdown, from the cases of run_cases.mjs.

import { table, unique } from './markdown.mjs';
import { SUBJECT, TARGETS, meanOf, reachedCount } from './targets.mjs';

const verdict = (met) => (met === null ? 'not known' : met ? 'met' : '**MISSED**');

export function targetTable(cases) {
  const rows = TARGETS.map(([wanted, find]) => {
    const [found, met] = find(cases);
    return [wanted, found, verdict(met)];
  });
  return table([`Target of ${SUBJECT}, at 25 %`, 'found', ''], rows);
}

const COLUMNS = [
  ['f 1-10', 'frequencyErrorMean', 2],
  ['largest', 'frequencyErrorMax', 1],
  ['calibrated', 'frequencyErrorCalibrated', 2],
  ['half thickness', 'frequencyErrorThin', 2],
  ['twice', 'frequencyErrorThick', 2],
  ['f 11-20', 'frequencyErrorHigh', 2],
  ['MAC', 'macMean', 3],
  ['lowest MAC', 'macMin', 3],
  ['distance', 'meanDistance', 3],
  ['Hausdorff', 'hausdorff', 2],
  ['smallest angle', 'minAngle', 1],
  ['mean smallest', 'meanMinAngle', 1],
  ['time, s', 'seconds', 2],
];

/** One line per method: means over the meshes that every method has a solvable result for, and counts over all. */
export function meansTable(cases, ratio) {
  const chosen = cases.filter((one) => one.ratio === ratio);
  const failed = new Set(chosen.filter(({ failure }) => failure).map(({ mesh }) => mesh));
  const rows = unique(chosen.map(({ method }) => method)).map((method) => {
    const own = chosen.filter((one) => one.method === method);
    const common = own.filter(({ mesh }) => !failed.has(mesh));
    const means = COLUMNS.map(([, key, digits]) => meanOf(common.map((one) => one[key])).toFixed(digits));
    const errors = common.map((one) => one.frequencyErrorMean).sort((a, b) => a - b);
    const median = errors[Math.floor(errors.length / 2)]?.toFixed(2);
    const changed = own.filter((one) => !one.topologyKept).length;
    return [method, median, ...means, `${changed} of ${own.length}`];
  });
  return table(
    ['mean over meshes', 'median f 1-10', ...COLUMNS.map(([title]) => title), 'topology changed'],
    rows,
  );
}

/** One line per mesh, one column per method; the best of each line is bold. */
export function meshTable(cases, ratio, { key, digits, best }) {
  const chosen = cases.filter((one) => one.ratio === ratio);
  const methods = unique(chosen.map(({ method }) => method));
  const rows = unique(chosen.map(({ mesh }) => mesh)).map((mesh) => {
    const own = methods.map((method) => chosen.find((one) => one.mesh === mesh && one.method === method));
    const values = own.map((one) => (one.failure && !(key in one) ? null : one[key]));
    const winner = best(...values.filter((value) => value !== null)).toFixed(digits);
    const cells = values.map((value) => {
      const text = value?.toFixed(digits) ?? 'not solvable';
      return text === winner ? `**${text}**` : text;
    });
    return [mesh, ...cells];
  });
  return table(['mesh', ...methods], rows);
}

/** Results with a wrong topology or face count, or whose shell modes cannot be computed. */
export function remarks(cases) {
  const lines = cases.flatMap((one) => {
    const { mesh, method, ratio, topologyKept, failure } = one;
    return [
      ...(topologyKept ? [] : [[method, 'changed the topology', mesh, ratio]]),
      ...(reachedCount(one) ? [] : [[method, 'stopped above the requested count', mesh, ratio]]),
      ...(failure ? [[method, 'left a mesh on which no shell can be solved', mesh, ratio]] : []),
    ];
  });
  return unique(lines.map(([method, what]) => `${method} ${what}`)).map((title) => {
    const group = lines.filter(([method, what]) => `${method} ${what}` === title);
    return `- ${title}: ${group.map(([, , mesh, ratio]) => `${mesh} (${100 * ratio} %)`).join(', ')}.`;
  });
}

/** The table of the results of attributes.mjs. */
export function attributeTable(errors) {
  const rows = errors.map(({ mesh, method, ratio, median, mean, acrossSeams }) => [
    ...[mesh, `${100 * ratio} %`, method, median.toFixed(3), mean.toFixed(3), `${acrossSeams.toFixed(1)} %`],
  ]);
  return table(['mesh', 'faces', 'method', 'median error', 'mean error', 'beyond a seam'], rows);
}
