// Tools of tests/bench/modes.mjs: our native program, the Python peer and the bundled engine.

import { execFile, spawnSync } from 'node:child_process';
import { existsSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { promisify } from 'node:util';
import { bundleModule } from '../../scripts/setup/bundle.mjs';
import { findHeaders, run } from '../../scripts/setup/environment.mjs';

const execute = promisify(execFile);
const root = resolve(import.meta.dirname, '..', '..');
const folder = join(root, 'build', 'bench');
const here = (name) => join(import.meta.dirname, name);

/** Runs a program that prints JSON, and parses its output. */
async function jsonOf(program, args, environment = {}) {
  const options = { env: { ...process.env, ...environment }, maxBuffer: 1 << 26 };
  const { stdout } = await execute(program, args, options);
  return JSON.parse(stdout);
}

/** The engine's loader as one file, for Node and the browser. */
export const bundleEngine = () => bundleModule('web/engine/core/load_core.ts', join(folder, 'engine'));

/** The core in this process, from the built wasm. */
export async function loadBundledCore(threads) {
  await bundleEngine();
  const { loadCore } = await import(pathToFileURL(join(folder, 'engine', 'load_core.js')).href);
  return loadCore({ threads, wasmFolder: pathToFileURL(join(root, 'public', 'wasm', '/')).href });
}

/** Returns the milliseconds of a call, and its result. */
export function timed(run) {
  const start = performance.now();
  const result = run();
  return [performance.now() - start, result];
}

/** Builds the optimised native program: (mesh, options) -> its output. */
export function buildNative() {
  const options = ['-DLIMBER_BENCH=ON', '-DLIMBER_TESTS=OFF', `-DLIMBER_HEADERS=${findHeaders()}`];
  run('cmake', ['--preset', 'release', '-B', folder, ...options], { quiet: true });
  run('ninja', ['-C', folder, 'shell_modes'], { quiet: true });
  const program = join(folder, 'tests', 'bench', 'shell_modes');
  return (mesh, ...args) => jsonOf(program, [mesh, ...args]);
}

/** A fresh Node process for every measurement. */
export const runInNode = (mesh, threads, options) =>
  jsonOf(process.execPath, [here('modes_node.mjs'), mesh, String(threads), JSON.stringify(options)]);

const hasPackages = (python) =>
  spawnSync(python, ['-c', 'import numpy, scipy, sksparse.cholmod'], { stdio: 'ignore' }).status === 0;

/** A Python that has the peer's packages: $LIMBER_BENCH_PYTHON, python3, or one of our own in build/bench; or null. */
function findPython() {
  const own = join(folder, 'python', 'bin', 'python');
  const found = [process.env.LIMBER_BENCH_PYTHON, own, 'python3'].find(
    (python) => python && hasPackages(python),
  );
  if (found) return found;
  if (!existsSync(own) && spawnSync('python3', ['-m', 'venv', join(folder, 'python')]).status !== 0)
    return null;
  // scikit-sparse 0.5 needs SuiteSparse 7.
  for (const version of ['scikit-sparse', 'scikit-sparse<0.5']) {
    spawnSync(own, ['-m', 'pip', 'install', '--quiet', 'numpy', 'scipy', version], { stdio: 'ignore' });
    if (hasPackages(own)) return own;
  }
  return null;
}

/** (matrix, threads of its BLAS, options) -> the peer's output; null if Python or a package is missing. */
export function findPeer() {
  const python = findPython();
  if (!python) return null;
  return (matrix, threads, ...args) =>
    jsonOf(python, [here('modes_peer.py'), matrix, ...args], {
      OPENBLAS_NUM_THREADS: String(threads),
      OMP_NUM_THREADS: String(threads),
    });
}
