// Finds the tools of this machine; only this file refers to folders outside the repository.

import { execFileSync, spawnSync } from 'node:child_process';
import { existsSync } from 'node:fs';
import { delimiter, join, resolve } from 'node:path';

export const root = resolve(import.meta.dirname, '..', '..');

export const folders = {
  toolchain: join(root, '.toolchain', 'emscripten'),
  build: join(root, 'build'),
};

/** The output of a command, or null if it cannot be run or fails. */
export function outputOf(command, ...args) {
  try {
    return execFileSync(command, args, { encoding: 'utf8', stdio: ['ignore', 'pipe', 'ignore'] }).trim();
  } catch {
    return null;
  }
}

/** Runs a command with output to the terminal; if it fails, ends this program with one sentence that includes the remedy (`cure`). */
export function run(command, args, { cwd = root, env = process.env, quiet = false, cure = '' } = {}) {
  const result = spawnSync(command, args, { cwd, env, stdio: quiet ? 'pipe' : 'inherit', encoding: 'utf8' });
  if (result.status === 0) return;
  if (quiet) process.stderr.write(`${result.stdout ?? ''}${result.stderr ?? ''}`);
  fail(
    `"${command} ${args.join(' ')}" failed${result.error ? `: ${result.error.message}` : ''}${cure && `: ${cure}`}.`,
  );
}

export function fail(sentence) {
  console.error(sentence);
  process.exit(1);
}

export function isOnPath(command) {
  return (process.env.PATH ?? '').split(delimiter).some((folder) => existsSync(join(folder, command)));
}

/** Whether version `found` ("3.1.69") is at least `wanted`. */
export function isAtLeast(found, wanted) {
  const a = found.split('.').map(Number);
  const b = wanted.split('.').map(Number);
  for (let i = 0; i < b.length; i++) if ((a[i] ?? 0) !== b[i]) return (a[i] ?? 0) > b[i];
  return true;
}

/** The folder of a recent enough Emscripten, the machine's own or the one unpacked here; null if there is none. */
export function findEmscripten() {
  const candidates = [
    process.env.EMSCRIPTEN_ROOT,
    process.env.EMSDK && join(process.env.EMSDK, 'upstream', 'emscripten'),
  ];
  for (const folder of (process.env.PATH ?? '').split(delimiter)) candidates.push(folder);
  candidates.push('/usr/share/emscripten', join(folders.toolchain, 'usr', 'share', 'emscripten'));
  for (const folder of candidates) {
    if (!folder || !existsSync(join(folder, 'emcc'))) continue;
    const version = /(\d+\.\d+\.\d+)/.exec(outputOf(join(folder, 'emcc'), '--version') ?? '')?.[1];
    if (!version || !isAtLeast(version, '3.1.69')) continue;
    const home = emscriptenHome(folder);
    if (home) return home;
  }
  return null;
}

/** The folder with both emcc and its CMake toolchain file (emcc on the PATH may be a link or a wrapper). */
function emscriptenHome(folder) {
  const toolchain = join('cmake', 'Modules', 'Platform', 'Emscripten.cmake');
  const reported = outputOf(join(folder, 'em-config'), 'EMSCRIPTEN_ROOT');
  return (
    [folder, reported, '/usr/share/emscripten'].find((home) => home && existsSync(join(home, toolchain))) ??
    null
  );
}

/** The folder that contains eigen3/ and Spectra/, or null. */
export function findHeaders() {
  const candidates = [
    process.env.LIMBER_HEADERS,
    '/usr/include',
    '/usr/local/include',
    '/opt/homebrew/include',
  ];
  return (
    candidates.find(
      (folder) =>
        folder &&
        existsSync(join(folder, 'eigen3', 'Eigen', 'Core')) &&
        existsSync(join(folder, 'Spectra', 'SymEigsSolver.h')),
    ) ?? null
  );
}

/** The folder of GoogleTest's sources, or null. */
export function findGoogleTest() {
  const candidates = [process.env.GOOGLETEST_SOURCE, '/usr/src/googletest'];
  return candidates.find((folder) => folder && existsSync(join(folder, 'CMakeLists.txt'))) ?? null;
}

/** A Chromium or Chrome for the tests of the page, or null. */
export function findChromium() {
  const names = ['chromium', 'chromium-browser', 'google-chrome', 'google-chrome-stable'];
  if (process.env.CHROMIUM && existsSync(process.env.CHROMIUM)) return process.env.CHROMIUM;
  for (const folder of (process.env.PATH ?? '').split(delimiter))
    for (const name of names) if (existsSync(join(folder, name))) return join(folder, name);
  return null;
}

export function findClangFormat() {
  return ['clang-format-19', 'clang-format'].find((name) => {
    const version = /version (\d+)/.exec(outputOf(name, '--version') ?? '')?.[1];
    return version === '19';
  });
}

/** A Clang with libFuzzer's runtime, or null. */
export function findFuzzingCompiler() {
  const isUsable = (name) => {
    const folder = isOnPath(name) ? outputOf(name, '--print-runtime-dir') : null;
    const old = outputOf(name, '--print-file-name=libclang_rt.fuzzer-x86_64.a');
    return (folder && existsSync(join(folder, 'libclang_rt.fuzzer.a'))) || (old && existsSync(old));
  };
  return ['clang++-19', 'clang++'].find((name) => isUsable(name)) ?? null;
}
