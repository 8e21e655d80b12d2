// Measures how the time of each stage and the memory grow with the number of faces, from file to file at half of the faces.
// Usage: npm run build && node tests/bench/scaling.mjs [--largest 4000000] [--rounds 2] [--write]
//
// --write puts the tables into docs/benchmarks.md. Exponents are slopes of straight lines through the logarithms (least squares)
// from FITTED_FROM faces on; a smaller mesh is mostly start-up.

import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { parseArgs } from 'node:util';
import { bundleModule } from '../../scripts/setup/bundle.mjs';
import { table, writeSection } from './section.mjs';

const FITTED_FROM = 15_000;
const SIZES = [1_000, 4_000, 16_000, 64_000, 250_000, 1_000_000, 4_000_000];
const STAGES = ['load', 'weld', 'modes', 'fields', 'simplify', 'fit', 'measure', 'export'];
/** seconds and bytes that the tool promises, by faces */
const TARGETS = new Map([
  [1_000_000, { seconds: 12, bytes: 2 ** 30 }],
  [4_000_000, { seconds: 90, bytes: 4 * 2 ** 30 }],
]);

const { values: options } = parseArgs({
  options: {
    largest: { type: 'string', default: String(SIZES.at(-1)) },
    rounds: { type: 'string', default: '2' },
    write: { type: 'boolean', default: false },
  },
});
const root = resolve(import.meta.dirname, '..', '..');
const scratch = join(root, 'build', 'bench', 'scaling');
mkdirSync(scratch, { recursive: true });
await bundleModule('tests/bench/seconds_entry.ts', join(scratch, 'engine'));
const { ballFile } = await import(pathToFileURL(join(scratch, 'engine', 'seconds_entry.js')).href);

async function inputOf(faces) {
  const path = join(scratch, `ball-${faces}.glb`);
  if (!existsSync(path)) writeFileSync(path, await ballFile(faces));
  return path;
}

/** One run: the report of the command line, and the seconds on the clock. */
function run(input, method) {
  const [output, report] = [join(scratch, 'out.glb'), join(scratch, 'report.json')];
  const words = ['optimize', input, output, '--ratio', '.5', '--method', method, '--report', report];
  const start = performance.now();
  const done = spawnSync(
    process.execPath,
    [join(root, 'dist', 'cli', 'limber.mjs'), ...words, '--threads', '2', '--force', '--quiet'],
    { encoding: 'utf8' },
  );
  if (done.status !== 0 && done.status !== 2) throw new Error(`${input}: ${done.stderr}`);
  return { seconds: (performance.now() - start) / 1000, report: JSON.parse(readFileSync(report, 'utf8')) };
}

/** The least of each stage and of the clock over the rounds. */
function measure(input, method) {
  const runs = Array.from({ length: Number(options.rounds) }, () => run(input, method));
  const { report } = runs[0];
  const least = (of) => Math.min(...runs.map(of));
  return {
    faces: report.input.faces,
    bytes: report.peakHeapBytes,
    total: least(({ seconds }) => seconds),
    stages: STAGES.map((name) => least(({ report: { timings } }) => timings[name] ?? 0)),
  };
}

/** The slope of log(value) over log(faces), and how far the line is off at most, as a factor. */
function exponent(points) {
  const kept = points.filter(({ faces, value }) => faces >= FITTED_FROM && value > 0);
  if (kept.length < 3) return '';
  const [xs, ys] = [kept.map(({ faces }) => Math.log(faces)), kept.map(({ value }) => Math.log(value))];
  const mean = (values) => values.reduce((sum, value) => sum + value, 0) / values.length;
  const [x0, y0] = [mean(xs), mean(ys)];
  const slope =
    xs.reduce((sum, x, i) => sum + (x - x0) * (ys[i] - y0), 0) /
    xs.reduce((sum, x) => sum + (x - x0) ** 2, 0);
  const off = Math.max(...xs.map((x, i) => Math.abs(ys[i] - y0 - slope * (x - x0))));
  return `${slope.toFixed(2)} (x ${Math.exp(off).toFixed(2)})`;
}

const megabytes = (bytes) => `${Math.round(bytes / 2 ** 20)} MB`;

function verdict({ faces, total, bytes }) {
  const [, target] = [...TARGETS].find(([size]) => Math.abs(faces / size - 1) < 0.05) ?? [];
  if (!target) return '';
  const word = (isMet) => (isMet ? 'met' : '**missed**');
  return `${target.seconds} s ${word(total <= target.seconds)}, ${megabytes(target.bytes)} ${word(bytes < target.bytes)}`;
}

const header = ['faces', ...STAGES, 'whole, s', 'memory of the core', 'target'];
async function section(method) {
  const all = [];
  for (const size of SIZES.filter((size) => size <= Number(options.largest))) {
    const found = measure(await inputOf(size), method);
    all.push(found);
    const cells = [found.faces, ...found.stages.map((seconds) => seconds.toFixed(2)), found.total.toFixed(2)];
    console.log([method, ...cells, megabytes(found.bytes)].join('\t'));
  }
  const rows = all.map((found) => [
    found.faces,
    ...found.stages.map((seconds) => seconds.toFixed(2)),
    found.total.toFixed(2),
    megabytes(found.bytes),
    method === 'limber' ? verdict(found) : '',
  ]);
  const slope = (value) => exponent(all.map((found) => ({ faces: found.faces, value: value(found) })));
  const slopes = [
    'exponent',
    ...STAGES.map((_, i) => slope(({ stages }) => stages[i])),
    slope(({ total }) => total),
    slope(({ bytes }) => bytes),
    '',
  ];
  return `### ${method}\n\n${table(header, [...rows, slopes])}`;
}

const sections = [];
for (const method of ['limber', 'qem']) sections.push(await section(method));
console.log(sections.join('\n\n'));
if (options.write)
  await writeSection({
    name: 'scaling',
    title: 'From a thousand to four million faces',
    remark: `A bumpy ball as GLB, from file to file at half of its faces, on two threads; seconds of each stage and of wall-clock time, the minimum of ${options.rounds} runs.`,
    missing: [],
    sections: [
      'The exponent is the slope of a straight line through the logarithms from 15,000 faces on; in brackets the largest factor between a time and the line.',
      ...sections,
    ],
  });
