/** Convergence plots as SVG: the worst error over the face count, both logarithmic, with one line per kind of mesh. */

import { worstError } from './cases/case';
import type { CaseResult, Run } from './cases/case';

const WIDTH = 640;
const HEIGHT = 360;
const FRAME = { left: 64, right: 150, top: 34, bottom: 48 };
const STYLES: Partial<Record<Run['kind'], { colour: string; dash: string }>> = {
  regular: { colour: '#0072b2', dash: '' },
  'union jack': { colour: '#b36b00', dash: '8 3' },
  irregular: { colour: '#007a5a', dash: '3 3' },
  graded: { colour: '#b0468b', dash: '10 3 3 3' },
};

interface Axis {
  low: number;
  high: number;
  /** maps a value to pixels */
  at(value: number): number;
  ticks: number[];
}

function logarithmicAxis(values: number[], start: number, end: number): Axis {
  const high = Math.max(...values) * 1.3;
  const low = Math.min(Math.min(...values) / 1.3, high / 10);
  const at = (value: number) => start + ((end - start) * Math.log(value / low)) / Math.log(high / low);
  const ticks: number[] = [];
  for (let power = Math.floor(Math.log10(low)); power <= Math.log10(high); power++)
    for (const step of [1, 2, 5]) {
      const value = step * 10 ** power;
      if (value >= low && value <= high) ticks.push(value);
    }
  return { low, high, at, ticks };
}

const fixed = (value: number) => value.toFixed(1);
const label = (value: number) =>
  value >= 1 ? value.toLocaleString('en') : String(Number(value.toPrecision(1)));

function line(from: [number, number], to: [number, number], style: string): string {
  return `<line x1="${fixed(from[0])}" y1="${fixed(from[1])}" x2="${fixed(to[0])}" y2="${fixed(to[1])}" ${style}/>`;
}

function text(x: number, y: number, content: string, style = ''): string {
  return `<text x="${fixed(x)}" y="${fixed(y)}" ${style}>${content}</text>`;
}

/** White background, so that the plot is readable on a dark page too. */
export function convergencePlot({ title, quantities, runs, isSecondOrder }: CaseResult): string {
  const points = runs.map((run) => ({ kind: run.kind, x: run.faces, y: worstError(run, quantities) }));
  const [left, right] = [FRAME.left, WIDTH - FRAME.right];
  const [top, bottom] = [FRAME.top, HEIGHT - FRAME.bottom];
  const x = logarithmicAxis(
    points.map((point) => point.x),
    left,
    right,
  );
  const y = logarithmicAxis(
    points.map((point) => point.y),
    bottom,
    top,
  );
  const grid = [
    ...x.ticks.map((value) => line([x.at(value), top], [x.at(value), bottom], 'stroke="#e2e2e2"')),
    ...y.ticks.map((value) => line([left, y.at(value)], [right, y.at(value)], 'stroke="#e2e2e2"')),
    ...x.ticks.map((value) => text(x.at(value), bottom + 16, label(value), 'text-anchor="middle"')),
    ...y.ticks.map((value) => text(left - 6, y.at(value) + 4, label(value), 'text-anchor="end"')),
    `<rect x="${left}" y="${top}" width="${right - left}" height="${bottom - top}" fill="none" stroke="#555"/>`,
    text((left + right) / 2, HEIGHT - 10, 'faces', 'text-anchor="middle"'),
    text(
      14,
      (top + bottom) / 2,
      'worst error, %',
      `text-anchor="middle" transform="rotate(-90 14 ${(top + bottom) / 2})"`,
    ),
    text(left, 20, title, 'font-size="14" font-weight="bold"'),
  ];
  const kinds = [...new Set(points.map((point) => point.kind))];
  const curves = kinds.flatMap((kind, k) => {
    const { colour, dash } = STYLES[kind]!;
    const own = points.filter((point) => point.kind === kind);
    const path = own.map((point) => `${fixed(x.at(point.x))},${fixed(y.at(point.y))}`).join(' ');
    const stroke = `stroke="${colour}" stroke-width="2" stroke-dasharray="${dash}"`;
    const legend = top + 12 + 22 * k;
    return [
      `<polyline points="${path}" fill="none" ${stroke}/>`,
      ...own.map(
        (point) =>
          `<circle cx="${fixed(x.at(point.x))}" cy="${fixed(y.at(point.y))}" r="3.5" fill="${colour}"/>`,
      ),
      line([right + 10, legend - 4], [right + 40, legend - 4], stroke),
      text(right + 46, legend, kind),
    ];
  });
  return [
    `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${WIDTH} ${HEIGHT}" width="${WIDTH}" height="${HEIGHT}" font-family="sans-serif" font-size="12" fill="#222">`,
    `<rect width="${WIDTH}" height="${HEIGHT}" fill="#fff"/>`,
    ...grid,
    ...(isSecondOrder ? secondOrder(x, y, points, top + 12 + 22 * kinds.length, right) : []),
    ...curves,
    '</svg>',
    '',
  ].join('\n');
}

/** A grey line for errors proportional to the squared cell size, i.e. 1 / faces; it starts below the coarsest mesh. */
function secondOrder(
  x: Axis,
  y: Axis,
  points: { x: number; y: number }[],
  legend: number,
  right: number,
): string[] {
  const [first] = points;
  const start = {
    x: x.low * 1.15,
    y: Math.min(...points.filter((p) => p.x === first.x).map((p) => p.y)) * 0.6,
  };
  const end = Math.min(x.high / 1.15, (start.x * start.y) / y.low);
  if (end <= start.x || start.y <= y.low) return [];
  const style = 'stroke="#888" stroke-dasharray="2 4"';
  return [
    line([x.at(start.x), y.at(start.y)], [x.at(end), y.at((start.x * start.y) / end)], style),
    line([right + 10, legend - 4], [right + 40, legend - 4], style),
    text(right + 46, legend, 'second order'),
  ];
}
