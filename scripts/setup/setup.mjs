// Installs everything that building needs: npm packages, then system packages. Fast if all are already installed.

import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import {
  fail,
  findChromium,
  findClangFormat,
  findEmscripten,
  findGoogleTest,
  findHeaders,
  folders,
  isOnPath,
  outputOf,
  root,
  run,
} from './environment.mjs';

/** The remedy if packages cannot be loaded. */
const ONLINE = 'the reason is above; it needs the network, so connect and run this again';

const isDebian = () => existsSync('/etc/debian_version') && isOnPath('apt-get');
const debianRelease = () => /VERSION_ID="(\d+)"/.exec(readFileSync('/etc/os-release', 'utf8'))?.[1];

// Requirements of a build: how to detect each, its Debian packages, and the remedy on other systems.
const buildNeeds = [
  {
    name: 'a C++ compiler (g++ >= 12)',
    found: () => isOnPath('g++') || isOnPath('c++'),
    packages: ['g++'],
    hint: 'install GCC or Clang',
  },
  {
    name: 'CMake >= 3.25',
    found: () => isOnPath('cmake'),
    packages: ['cmake'],
    hint: 'install it from cmake.org',
  },
  { name: 'Ninja', found: () => isOnPath('ninja'), packages: ['ninja-build'], hint: 'install ninja' },
  {
    name: "Python 3, in which Emscripten's tools are written",
    found: () => isOnPath('python3'),
    packages: ['python3'],
    hint: 'install Python 3',
  },
  {
    name: 'Eigen >= 3.4 and Spectra >= 1.0',
    found: () => findHeaders() !== null,
    packages: ['libeigen3-dev', 'libspectra-dev'],
    hint: 'install both and set LIMBER_HEADERS to the folder that holds eigen3/ and Spectra/',
  },
];
const testNeeds = [
  {
    name: "GoogleTest's sources",
    found: () => findGoogleTest() !== null,
    packages: ['googletest'],
    hint: 'set GOOGLETEST_SOURCE to a checkout of GoogleTest',
  },
  {
    name: 'Chromium',
    found: () => findChromium() !== null,
    packages: ['chromium'],
    hint: 'install Chromium or Chrome, or set CHROMIUM to its program',
  },
  {
    name: 'clang-format 19',
    found: () => Boolean(findClangFormat()),
    packages: ['clang-format-19'],
    hint: 'install clang-format 19',
  },
];

/** Sets up everything that building needs and, with `tests`, everything that testing needs. */
export function setUp({ tests = false } = {}) {
  installNodePackages();
  installSystemPackages([...buildNeeds, ...(tests ? testNeeds : [])]);
  return { emscripten: setUpEmscripten(), headers: findHeaders() };
}

function installNodePackages() {
  const lock = readFileSync(join(root, 'package-lock.json'));
  const wanted = createHash('sha256').update(lock).update(process.version).digest('hex');
  const stamp = join(root, 'node_modules', '.limber-lock');
  if (existsSync(stamp) && readFileSync(stamp, 'utf8') === wanted) return;
  console.log('Installing npm packages ...');
  run('npm', ['ci', '--no-audit', '--no-fund', '--loglevel=error'], { quiet: true, cure: ONLINE });
  writeFileSync(stamp, wanted);
}

function installSystemPackages(needs) {
  const missing = needs.filter((need) => !need.found());
  if (missing.length === 0) return;
  const packages = missing.flatMap((need) => need.packages);
  if (!isDebian())
    fail(`Missing: ${missing.map((need) => `${need.name} (${need.hint})`).join('; ')}. Then run this again.`);
  apt(packages);
  const still = missing.filter((need) => !need.found());
  if (still.length > 0)
    fail(`Still missing after installation: ${still.map((need) => need.name).join(', ')}.`);
}

/** Installs Debian packages as root or through sudo; if neither is possible, says in one sentence what to run. */
function apt(packages) {
  const isRoot = process.getuid?.() === 0;
  const hasSudo = !isRoot && isOnPath('sudo') && outputOf('sudo', '-n', 'true') !== null;
  if (!isRoot && !hasSudo)
    fail(`Missing system packages; run "sudo apt-get install ${packages.join(' ')}" and then this again.`);
  console.log(`Installing system packages: ${packages.join(' ')} ...`);
  const [command, prefix] = isRoot ? ['apt-get', []] : ['sudo', ['apt-get']];
  const env = { ...process.env, DEBIAN_FRONTEND: 'noninteractive' };
  // Automatic updates of the system can hold apt's lock for minutes: wait for it.
  const quietly = [...prefix, '-qq', '-o', 'DPkg::Lock::Timeout=600'];
  run(command, [...quietly, 'update'], { quiet: true, env, cure: ONLINE });
  run(command, [...quietly, '-y', '--no-install-recommends', 'install', ...packages], {
    quiet: true,
    env,
    cure: ONLINE,
  });
}

/** The folder of Emscripten >= 3.1.69: the installed one, Debian 13's package, or that package unpacked on Debian 12. */
function setUpEmscripten() {
  const found = findEmscripten();
  if (found) return found;
  const elsewhere = 'install Emscripten >= 3.1.69 (emscripten.org) and put emcc on the PATH';
  if (!isDebian()) fail(`Missing: Emscripten >= 3.1.69 (${elsewhere}). Then run this again.`);
  if (Number(debianRelease()) >= 13) apt(['emscripten']);
  else unpackEmscripten();
  return findEmscripten() ?? fail(`Emscripten >= 3.1.69 was not found after installation; ${elsewhere}.`);
}

function unpackEmscripten() {
  const llvm = ['clang-19', 'lld-19', 'llvm-19'];
  const programs = ['clang', 'wasm-ld', 'llvm-ar'].map((name) => `/usr/lib/llvm-19/bin/${name}`);
  if (!programs.every((program) => existsSync(program))) apt(llvm);
  console.log('Unpacking Emscripten into .toolchain/ ...');
  mkdirSync(join(root, '.toolchain'), { recursive: true });
  run('bash', [join(root, 'scripts', 'setup', 'toolchain.sh'), folders.toolchain], {
    quiet: true,
    cure: ONLINE,
  });
}
