// Plots of the evaluation as SVG, with a white background so that they are readable on a dark page too.

import { SUBJECT, meanOf } from './targets.mjs';

const WIDTH = 880;
const FRAME = { left: 110, right: 230, top: 40, bottom: 46 };
const ROW = 24;
/** Our methods are blue, the peers have warm colours and greys; each has its own shape for colour-blind readers. */
const STYLES = {
  [SUBJECT]: ['#0072b2', 'circle'],
  'limber, surface fit': ['#1f9bd1', 'circle'],
  'limber without fit': ['#56b4e9', 'circle'],
  qem: ['#007a5a', 'square'],
  paper: ['#6a51a3', 'square'],
  meshoptimizer: ['#e69f00', 'diamond'],
  'meshoptimizer update': ['#d55e00', 'diamond'],
  'meshoptimizer update + strain': ['#b0468b', 'diamond'],
  pymeshlab: ['#666666', 'triangle'],
  'fast-simplification': ['#a6761d', 'triangle'],
};

const fixed = (value) => value.toFixed(1);
const unique = (values) => [...new Set(values)];
const text = (x, y, content, style = '') =>
  `<text x="${fixed(x)}" y="${fixed(y)}" ${style}>${content}</text>`;
const line = (x1, y1, x2, y2, style) =>
  `<line x1="${fixed(x1)}" y1="${fixed(y1)}" x2="${fixed(x2)}" y2="${fixed(y2)}" ${style}/>`;

const OUTLINES = {
  circle: (r) =>
    Array.from({ length: 16 }, (_, i) => [r * Math.cos((Math.PI * i) / 8), r * Math.sin((Math.PI * i) / 8)]),
  square: (r) =>
    [
      [-r, -r],
      [r, -r],
      [r, r],
      [-r, r],
    ].map((point) => point.map((value) => 0.88 * value)),
  diamond: (r) => [
    [0, -1.25 * r],
    [1.25 * r, 0],
    [0, 1.25 * r],
    [-1.25 * r, 0],
  ],
  triangle: (r) => [
    [0, -1.2 * r],
    [1.1 * r, 0.9 * r],
    [-1.1 * r, 0.9 * r],
  ],
};

function mark(x, y, method) {
  const [colour, shape] = STYLES[method];
  const points = OUTLINES[shape](method === SUBJECT ? 5.5 : 4.5);
  const path = points.map(([dx, dy]) => `${fixed(x + dx)},${fixed(y + dy)}`).join(' ');
  return `<polygon points="${path}" fill="${colour}" fill-opacity="0.85" stroke="#fff" stroke-width="0.7"/>`;
}

/** Maps values to [start, end], logarithmically; ticks at 1, 2 and 5 times powers of ten. */
function logarithmicAxis(values, start, end) {
  const [low, high] = [Math.min(...values) / 1.2, Math.max(...values) * 1.2];
  const at = (value) => start + ((end - start) * Math.log(value / low)) / Math.log(high / low);
  const powers = Array.from({ length: 16 }, (_, i) => 10 ** (i - 8));
  const ticks = powers.flatMap((power) => [power, 2 * power, 5 * power]);
  return { at, ticks: ticks.filter((value) => value >= low && value <= high) };
}

const tickLabel = (value) => (value >= 1 ? value.toFixed(0) : String(Number(value.toPrecision(1))));

function page(height, content) {
  const size = `viewBox="0 0 ${WIDTH} ${height}" width="${WIDTH}" height="${height}"`;
  return [
    `<svg xmlns="http://www.w3.org/2000/svg" ${size} font-family="sans-serif" font-size="12" fill="#222">`,
    `<rect width="${WIDTH}" height="${height}" fill="#fff"/>`,
    ...content,
    '</svg>',
    '',
  ].join('\n');
}

const legend = (methods) =>
  methods.flatMap((method, k) => {
    const y = FRAME.top + 14 + 20 * k;
    const x = WIDTH - FRAME.right + 16;
    return [mark(x, y - 4, method), text(x + 12, y, method)];
  });

const TITLE = 'font-size="14" font-weight="bold"';

/** One row per mesh, with the mean frequency errors of its first ten modes as marks on a logarithmic axis. */
export function meshPlot(cases, ratio) {
  const shown = cases.filter((one) => one.ratio === ratio && !one.failure && one.frequencyErrorMean > 0);
  const meshes = unique(shown.map(({ mesh }) => mesh));
  const [left, right, top] = [FRAME.left, WIDTH - FRAME.right, FRAME.top];
  const bottom = top + ROW * meshes.length;
  const x = logarithmicAxis(
    shown.map((one) => one.frequencyErrorMean),
    left,
    right,
  );
  const rowOf = (mesh) => top + ROW * (meshes.indexOf(mesh) + 0.5);
  return page(bottom + FRAME.bottom, [
    text(left, 22, `Mean frequency error of modes 1-10 at ${100 * ratio} % of the faces, %`, TITLE),
    ...meshes.map((mesh) => line(left, rowOf(mesh), right, rowOf(mesh), 'stroke="#eee"')),
    ...meshes.map((mesh) => text(left - 8, rowOf(mesh) + 4, mesh, 'text-anchor="end"')),
    ...x.ticks.map((value) => line(x.at(value), top, x.at(value), bottom, 'stroke="#e2e2e2"')),
    ...x.ticks.map((value) => text(x.at(value), bottom + 18, tickLabel(value), 'text-anchor="middle"')),
    ...shown.map((one) => mark(x.at(one.frequencyErrorMean), rowOf(one.mesh), one.method)),
    ...legend(unique(shown.map(({ method }) => method))),
  ]);
}

/** The frequency error, averaged over the meshes, over the faces, with one line per method. */
export function facesPlot(cases) {
  const failed = new Set(cases.filter(({ failure }) => failure).map(({ mesh }) => mesh));
  const common = cases.filter(({ mesh }) => !failed.has(mesh));
  const methods = unique(common.map(({ method }) => method));
  const ratios = unique(common.map(({ ratio }) => ratio)).sort((a, b) => a - b);
  const meanAt = (method, ratio) =>
    meanOf(
      common
        .filter((one) => one.method === method && one.ratio === ratio)
        .map((one) => one.frequencyErrorMean),
    );
  const curves = methods.map((method) => ({
    method,
    points: ratios.map((ratio) => [ratio, meanAt(method, ratio)]),
  }));
  const [left, right, top, bottom] = [FRAME.left, WIDTH - FRAME.right, FRAME.top, 380];
  const x = logarithmicAxis(ratios, left, right);
  const errors = curves.flatMap(({ points }) => points.map(([, error]) => error));
  const y = logarithmicAxis(errors, bottom, top);
  return page(bottom + FRAME.bottom, [
    text(left, 22, 'Mean frequency error of modes 1-10 over all meshes, %', TITLE),
    ...y.ticks.map((value) => line(left, y.at(value), right, y.at(value), 'stroke="#e2e2e2"')),
    ...y.ticks.map((value) => text(left - 8, y.at(value) + 4, tickLabel(value), 'text-anchor="end"')),
    ...ratios.map((ratio) => text(x.at(ratio), bottom + 18, `${100 * ratio} %`, 'text-anchor="middle"')),
    text((left + right) / 2, bottom + 38, 'faces left', 'text-anchor="middle"'),
    ...curves.flatMap(({ method, points }) => {
      const placed = points.map(([ratio, error]) => [x.at(ratio), y.at(error)]);
      const path = placed.map((point) => point.map(fixed).join(',')).join(' ');
      const stroke = `fill="none" stroke="${STYLES[method][0]}" stroke-width="2"`;
      return [`<polyline points="${path}" ${stroke}/>`, ...placed.map(([px, py]) => mark(px, py, method))];
    }),
    ...legend(methods),
  ]);
}
