// Compares the speed of the simulation with a plain native loop and two peers, as tables with ratios.
// Usage: npm run build && node tests/bench/simulate.mjs [--write] [--seconds 3]
// --write puts the tables into docs/benchmarks.md. Needs g++; for the peers it tries to install jolt-physics (npm) and
// pyPBD (pip) into build/bench/peers. Missing ones are left out and listed. The Eiffel tower is read from
// ../shared/meshes or $LIMBER_SHARED/meshes.

import { execFile, execFileSync, spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { cpus, tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { parseArgs } from 'node:util';
import { format, resolveConfig } from 'prettier';
import { bar, edgesOf, readObj } from './bench_meshes.mjs';
import { bundleEngine } from './modes_tools.mjs';
import { wrapProse } from './prose.mjs';

const { values: options } = parseArgs({
  options: { write: { type: 'boolean', default: false }, seconds: { type: 'string', default: '3' } },
});
const root = resolve(import.meta.dirname, '..', '..');
const shared = join(process.env.LIMBER_SHARED ?? join(root, '..', 'shared'), 'meshes');
const peers = join(root, 'build', 'bench', 'peers');
const scratch = mkdtempSync(join(tmpdir(), 'limber-bench-'));
const seconds = Number(options.seconds);
const missing = [];

const row = (cells) => `| ${cells.join(' | ')} |`;
const table = (header, rows) => [row(header), row(header.map(() => '---')), ...rows.map(row)].join('\n');
const millions = (rate) => (rate === undefined ? 'missing' : (rate / 1e6).toFixed(1));
const milliseconds = (value) => (value === undefined ? 'missing' : `${(1000 * value).toFixed(2)} ms`);
const ratio = (a, b) => (a === undefined || b === undefined ? 'missing' : `x ${(a / b).toFixed(2)}`);
const verdict = (holds) => (holds ? 'met' : '**MISSED**');
const judge = (value, ok) => (Number.isFinite(value) ? verdict(ok(value)) : 'not known');

// ---- the plain loop ----

function plainLoop(...flags) {
  const program = join(scratch, `plain${flags.join('')}`);
  const source = join(import.meta.dirname, 'native', 'plain_springs.cpp');
  execFileSync('g++', ['-std=c++20', '-O3', '-march=native', ...flags, source, '-o', program]);
  return (...args) =>
    JSON.parse(execFileSync(program, ['--seconds', String(seconds), ...args], { encoding: 'utf8' }));
}

// ---- peers ----

function installPeers() {
  mkdirSync(peers, { recursive: true });
  const jolt = join(peers, 'node_modules', 'jolt-physics', 'dist', 'jolt-physics.wasm.js');
  if (!existsSync(jolt))
    spawnSync('npm', ['install', '--prefix', peers, '--no-audit', '--no-fund', 'jolt-physics@1.1'], {
      stdio: 'ignore',
    });
  const python = join(peers, 'py', 'bin', 'python');
  const hasPbd = () => spawnSync(python, ['-c', 'import pypbd'], { stdio: 'ignore' }).status === 0;
  if (!hasPbd()) {
    spawnSync('python3', ['-m', 'venv', join(peers, 'py')], { stdio: 'ignore' });
    spawnSync(python, ['-m', 'pip', 'install', '--quiet', 'pypbd'], { stdio: 'ignore' });
  }
  if (!existsSync(jolt)) missing.push('jolt-physics');
  if (!hasPbd()) missing.push('pyPBD');
  return { jolt: existsSync(jolt) ? jolt : null, python: hasPbd() ? python : null };
}

function peerTimes(mesh, substeps) {
  const { jolt, python } = installPeers();
  const vertices = mesh.positions.length / 3;
  const pinned = [...Array(vertices).keys()].filter((v) => mesh.positions[3 * v + 2] < 0.1);
  const body = {
    positions: [...mesh.positions],
    triangles: [...mesh.triangles],
    edges: edgesOf(mesh),
    pinned,
    substeps,
    compliance: 1 / (1e6 * 0.02),
    inverseMass: vertices / 280,
  };
  const file = join(scratch, 'body.json');
  writeFileSync(file, JSON.stringify(body));
  const run = (program, args) =>
    JSON.parse(
      execFileSync(program, args, { encoding: 'utf8', env: { ...process.env, OMP_NUM_THREADS: '1' } })
        .trim()
        .split('\n')
        .at(-1),
    ).secondsPerStep;
  const here = (name) => join(import.meta.dirname, name);
  return {
    jolt: jolt ? run(process.execPath, [here('simulate_jolt.mjs'), jolt, file, String(seconds)]) : undefined,
    pbd: python ? run(python, [here('simulate_pbd.py'), file, String(seconds)]) : undefined,
  };
}

// ---- ours ----

await bundleEngine();
const engine = join(root, 'build', 'bench', 'engine', 'load_core.js');
const { loadCore } = await import(pathToFileURL(engine).href);
const wasmFolder = pathToFileURL(join(root, 'public', 'wasm', '/')).href;
const [oneThread, twoThreads] = [
  await loadCore({ threads: 1, wasmFolder }),
  await loadCore({ threads: 2, wasmFolder }),
];

const diagonalOf = ({ positions }) =>
  Math.hypot(
    ...[0, 1, 2].map((c) => {
      const values = positions.filter((_, i) => i % 3 === c);
      return values.reduce((a, b) => Math.max(a, b)) - values.reduce((a, b) => Math.min(a, b));
    }),
  );

const optionsFor = (mesh, material, substeps) => ({
  material,
  scenario: 'twist',
  seconds: 2,
  substeps,
  damping: 0.5,
  selfCollision: false,
  friction: 0.5,
  pinned: null,
  thickness: 0.02 * diagonalOf(mesh),
  young: 1e6,
  poisson: 0.3,
  density: 1000,
  unit: 1,
});

/** Seconds of the shortest step of all bodies, with one call per step. */
function timeOf(core, bodies, settings) {
  const numbers = Uint32Array.from(bodies.map((body) => core.startSimulation(body, bodies[0], settings)));
  let least = Infinity;
  const end = performance.now() + 1000 * seconds;
  while (performance.now() < end) {
    const start = performance.now();
    core.stepSimulations(numbers);
    least = Math.min(least, performance.now() - start);
  }
  for (const number of numbers) core.endSimulation(number);
  return least / 1000;
}

function springs() {
  const mesh = bar(8);
  const edges = edgesOf(mesh).length;
  const rateOf = (secondsPerStep) => (2000 * edges) / secondsPerStep;
  const ours = timeOf(oneThread, [mesh], optionsFor(mesh, 'springs', 2000));
  const plain = plainLoop()();
  const coloured = plainLoop('-ffast-math')('--colour');
  const { jolt, pbd } = peerTimes(mesh, 2000);
  const line = (name, secondsPerStep, target) => {
    const share = secondsPerStep / ours;
    return [
      name,
      milliseconds(secondsPerStep),
      millions(rateOf(secondsPerStep)),
      ratio(secondsPerStep, ours),
      target(share),
    ];
  };
  return [
    `### Springs: the bar with ${edges} edges, 2,000 substeps a step, one thread`,
    'Ours is accurate at that many substeps (a falling body follows the parabola); the plain loops keep float positions, which do not move at all there. All work of a step is included.',
    table(
      ['what', 'one step', 'million edges a second', 'ours is faster by', 'target'],
      [
        line('ours, wasm in Node', ours, () => ''),
        line(
          'plain loop, g++ -O3 -march=native, in the order of the faces',
          plain.secondsPerStep,
          (s) => `${judge(s, (x) => x >= 3)} (x 3)`,
        ),
        line(
          'the same, by colours, -ffast-math',
          coloured.secondsPerStep,
          (s) => `${judge(s, (x) => x >= 0.8)} (x 0.8)`,
        ),
        line('jolt-physics, wasm', jolt, (s) => `${judge(s, (x) => x >= 3.5)} (x 3.5)`),
        line('pyPBD, native', pbd, (s) => `${judge(s, (x) => x >= 3.5)} (x 3.5)`),
      ],
    ),
  ];
}

/** Throughput of two processes relative to one: 2 if both cores are free. */
async function freeCores() {
  const source = 'let n = 0; const end = Date.now() + 700; while (Date.now() < end) n++; console.log(n)';
  const counted = () =>
    new Promise((done) => execFile(process.execPath, ['-e', source], (_, stdout) => done(Number(stdout))));
  const alone = await counted();
  const both = await Promise.all([counted(), counted()]);
  return (both[0] + both[1]) / alone;
}

async function threads() {
  const mesh = bar(32);
  const rows = ['springs', 'shell'].map((material) => {
    const settings = optionsFor(mesh, material, 20);
    const [one, two] = [timeOf(oneThread, [mesh], settings), timeOf(twoThreads, [mesh], settings)];
    return [
      material,
      milliseconds(one),
      milliseconds(two),
      ratio(one, two),
      judge(one / two, (x) => x >= 1.4),
    ];
  });
  return [
    `### Two threads on one body: the bar with ${edgesOf(mesh).length} edges, 20 substeps`,
    `Two independent programs at the same time did ${(await freeCores()).toFixed(2)} times the work of one; it would be 2 if nothing else used the cores.`,
    table(['material', 'one thread', 'two threads', 'faster by', '>= 1.4'], rows),
  ];
}

/** The mesh reduced to half of its faces by quadrics. */
function half(mesh) {
  const settings = { method: 'qem', strainWeight: 0, curvatureWeight: 0, qualityWeight: 0 };
  const history = oneThread.simplify(mesh, new Float32Array(), new Float32Array(), settings);
  return oneThread.meshAt(mesh, history, mesh.triangles.length / 6).mesh;
}

function eiffel() {
  const path = join(shared, 'derived_eiffel_6156.obj');
  if (!existsSync(path)) {
    missing.push('derived_eiffel_6156.obj of ../shared/meshes');
    return [];
  }
  const mesh = readObj(path);
  const coarse = half(mesh);
  const rows = ['springs', 'shell'].map((material) => {
    const settings = optionsFor(mesh, material, 50);
    const alone = timeOf(oneThread, [mesh], settings);
    const both = timeOf(twoThreads, [mesh, coarse], settings);
    return [
      material,
      milliseconds(alone),
      milliseconds(both),
      (1 / both).toFixed(0),
      verdict(both <= 1 / 60),
    ];
  });
  return [
    `### The Eiffel tower (${mesh.triangles.length / 3} faces) and its half side by side, 50 substeps, two threads`,
    table(['material', 'the tower alone, one thread', 'both', 'steps a second', '>= 60'], rows),
  ];
}

const sections = [];
for (const part of [springs, threads, eiffel]) {
  sections.push((await part()).join('\n\n'));
  console.log(`\n${sections.at(-1)}`);
}
if (missing.length) console.log(`\nMISSING HERE:\n${missing.map((what) => `- ${what}`).join('\n')}`);
if (options.write) await write();
rmSync(scratch, { recursive: true });
process.exit(0);

/** Replaces the text between the markers of docs/benchmarks.md, which is created if absent. */
async function write() {
  const path = join(root, 'docs', 'benchmarks.md');
  const [begin, end] = ['<!-- simulate: begin -->', '<!-- simulate: end -->'];
  const introduction = [
    `Written by \`node tests/bench/simulate.mjs --write\` on ${cpus().length} x ${cpus()[0].model.trim()}, Node ${process.versions.node}.`,
    'Each number is the minimum over the steps of a few seconds.',
    ...(missing.length ? [`Missing: ${missing.join('; ')}.`] : []),
  ].join(' ');
  const content = wrapProse([begin, '## Simulation', introduction, ...sections, end].join('\n\n'));
  const found = existsSync(path) ? readFileSync(path, 'utf8') : '# Benchmarks\n';
  const before = found.includes(begin) ? found : `${found}\n${begin}\n${end}\n`;
  const after = `${before.split(begin)[0]}${content}${before.split(end)[1]}`;
  mkdirSync(join(root, 'docs'), { recursive: true });
  writeFileSync(path, await format(after, { ...(await resolveConfig(path)), filepath: path }));
  console.log('wrote docs/benchmarks.md');
}
