/** The deviation of the Test step over time as a standalone drawing: an SVG file with axes and labels. */

import type { TwinSample } from '../../../engine/motion/twin';
import { fixed } from '../../controls/numbers';
import { roundUp } from '../simulate/simulate_scale';

const [WIDTH, HEIGHT] = [720, 320];
const PLOT = { left: 64, top: 40, right: 700, bottom: 268 };
const LINES = 4;
/** Of the finest scale, in %. */
const LEAST = 0.01;

const COLOURS = { text: '#17212b', line: '#c9d2da', deviation: '#2563c9', noise: '#8a5300' };

/** `title`: the moving body and scenario, in one line. */
export function deviationSvg(samples: readonly TwinSample[], title: string): string {
  const end = samples.at(-1)?.time ?? 1;
  const most = samples.reduce((high, { mean, noise }) => Math.max(high, mean, noise ?? 0), LEAST);
  const high = roundUp(most);
  const x = (time: number): string => fixed(PLOT.left + ((PLOT.right - PLOT.left) * time) / end, 2);
  const y = (value: number): string => fixed(PLOT.bottom - ((PLOT.bottom - PLOT.top) * value) / high, 2);
  const noise = samples.filter((sample) => sample.noise !== null);
  const curve = (points: string[], colour: string, dash: string): string =>
    points.length === 0
      ? ''
      : `<polyline fill="none" stroke="${colour}" stroke-width="2" ${dash} points="${points.join(' ')}"/>`;
  const shares = Array.from({ length: LINES + 1 }, (_, i) => i / LINES);
  return [
    `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${WIDTH} ${HEIGHT}" width="${WIDTH}" height="${HEIGHT}" font-family="sans-serif" font-size="12" fill="${COLOURS.text}">`,
    `<title>${escaped(title)}</title>`,
    `<text x="${PLOT.left}" y="22" font-size="14" font-weight="600">${escaped(title)}</text>`,
    ...shares.map((share) => {
      const height = y(share * high);
      return `<line x1="${PLOT.left}" x2="${PLOT.right}" y1="${height}" y2="${height}" stroke="${COLOURS.line}"/><text x="${PLOT.left - 8}" y="${Number(height) + 4}" text-anchor="end">${label(share * high)}</text>`;
    }),
    ...shares.map(
      (share) =>
        `<text x="${x(share * end)}" y="${PLOT.bottom + 20}" text-anchor="middle">${label(share * end)}</text>`,
    ),
    `<text x="${(PLOT.left + PLOT.right) / 2}" y="${PLOT.bottom + 42}" text-anchor="middle">Time, s</text>`,
    `<text transform="translate(16 ${(PLOT.top + PLOT.bottom) / 2}) rotate(-90)" text-anchor="middle">Deviation, % of the diagonal</text>`,
    curve(
      noise.map((sample) => `${x(sample.time)},${y(sample.noise ?? 0)}`),
      COLOURS.noise,
      'stroke-dasharray="4 3"',
    ),
    curve(
      samples.map((sample) => `${x(sample.time)},${y(sample.mean)}`),
      COLOURS.deviation,
      '',
    ),
    noise.length > 0
      ? `<text x="${PLOT.right}" y="22" text-anchor="end" fill="${COLOURS.noise}">dashed: noise floor</text>`
      : '',
    '</svg>',
    '',
  ]
    .filter((line, i, all) => line !== '' || i === all.length - 1)
    .join('\n');
}

const label = (value: number): string => String(Number(value.toPrecision(3)));

const escaped = (text: string): string =>
  text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('>', '&gt;');
