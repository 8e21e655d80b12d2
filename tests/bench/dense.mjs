// Compares the speed of our products of dense blocks with Eigen's, in WebAssembly and natively.
// Usage: npm run build && node tests/bench/dense.mjs [--write]     --write puts the table into docs/benchmarks.md.

import { execFileSync } from 'node:child_process';
import { join, resolve } from 'node:path';
import { parseArgs } from 'node:util';
import { findEmscripten, findHeaders, run } from '../../scripts/setup/environment.mjs';
import { table, writeSection } from './section.mjs';

const { values: options } = parseArgs({ options: { write: { type: 'boolean', default: false } } });
const root = resolve(import.meta.dirname, '..', '..');

function build(preset, ...settings) {
  const folder = join(root, 'build', `bench-${preset}`);
  const all = ['-DLIMBER_BENCH=ON', '-DLIMBER_TESTS=OFF', `-DLIMBER_HEADERS=${findHeaders()}`, ...settings];
  run('cmake', ['--preset', preset, '-B', folder, ...all], { quiet: true });
  run('ninja', ['-C', folder, 'dense_product'], { quiet: true });
  return join(folder, 'tests', 'bench', 'dense_product');
}

const toolchain = join(findEmscripten(), 'cmake', 'Modules', 'Platform', 'Emscripten.cmake');
const wasm = build('single', `-DCMAKE_TOOLCHAIN_FILE=${toolchain}`);
const native = build('release');
const measured = [
  JSON.parse(execFileSync(process.execPath, [`${wasm}.cjs`], { encoding: 'utf8' })),
  JSON.parse(execFileSync(native, { encoding: 'utf8' })),
];

const speeds = ({ ours, eigen }) => [ours.toFixed(1), eigen.toFixed(1), `x ${(ours / eigen).toFixed(2)}`];
const rows = measured[0].map((inWasm, k) => [
  `${inWasm.rows} x ${inWasm.depth} x ${inWasm.cols}`,
  ...speeds(inWasm),
  ...speeds(measured[1][k]),
]);
const header = ['rows x depth x columns', 'wasm', "Eigen's", 'ratio', 'native', "Eigen's", 'ratio'];
for (const row of [header, ...rows]) console.log(row.join('  '));
if (options.write)
  await writeSection({
    name: 'dense',
    title: 'Dense products',
    remark:
      'GFlop/s, doubles, one thread; our runs and Eigen’s alternated; each number is the best of seven.',
    missing: [],
    sections: [
      'The solver spends most of its time in this operation: the product of dense blocks is subtracted from another block. Eigen 3.4 has special kernels for x86 and Arm, but none for WebAssembly.',
      table(header, rows),
    ],
  });
