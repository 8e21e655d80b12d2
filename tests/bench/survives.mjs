// What survives when a glTF file is reduced to half of its faces: by limber, gltfpack and glTF-Transform. Needs `npm run build`.
//
//   node tests/bench/survives.mjs [--write] [NAME...]     NAME: parts of file names; --write: docs/pictures.md
//
// Files are a made one with a bit of everything, the samples, and the folder meshes/gltf of ../shared or LIMBER_SHARED. PEERS: a folder
// with node_modules/gltfpack and node_modules/@gltf-transform/cli.

import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { basename, dirname, join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { bundleModule } from '../../scripts/setup/bundle.mjs';
import { jsonOf, withEverything, writeGlb } from './survives/gltf_file.mjs';
import { inventoryOf, lossesOf } from './survives/inventory.mjs';
import { table, writeSection } from './section.mjs';

const root = resolve(import.meta.dirname, '..', '..');
const scratch = join(root, 'build', 'bench', 'survives');
const words = process.argv.slice(2);
const asked = words.filter((word) => !word.startsWith('--'));
const peers = process.env.PEERS ?? root;
const limber = join(root, 'dist', 'cli', 'limber.mjs');
const gltfpack = join(peers, 'node_modules', 'gltfpack', 'cli.js');
const gltfTransform = join(peers, 'node_modules', '@gltf-transform', 'cli', 'bin', 'cli.js');
const shared = join(process.env.LIMBER_SHARED ?? join(root, '..', 'shared'), 'meshes', 'gltf');

/** Every tool with the options that keep most: gltfpack's are those for names, materials, extras and unquantized numbers. */
const TOOLS = {
  limber: {
    command: limber,
    steps: (path, out) => [['optimize', path, out, '--ratio', '.5', '--force', '--quiet']],
  },
  gltfpack: {
    command: gltfpack,
    steps: (path, out) => [['-i', path, '-o', out, '-si', '0.5', '-noq', '-kn', '-km', '-ke', '-kv']],
  },
  'glTF-Transform': {
    command: gltfTransform,
    steps: (path, out) => [
      ['weld', path, out],
      ['simplify', out, out, '--ratio', '0.5', '--error', '1'],
    ],
  },
};

async function listFiles() {
  await bundleModule('tests/bench/scenes_entry.ts', join(scratch, 'engine'));
  const engine = await import(pathToFileURL(join(scratch, 'engine', 'scenes_entry.js')).href);
  const everything = join(scratch, 'everything.glb');
  const plain = join(scratch, 'plain.glb');
  writeFileSync(plain, (await engine.glbFile(engine.roomScene())).bytes);
  writeGlb(everything, withEverything(jsonOf(plain)));
  rmSync(plain);
  const folders = [scratch, join(root, 'public', 'samples'), shared].filter(existsSync);
  if (!folders.includes(shared))
    console.log(`${shared} is not there: only the made file and the samples are measured.`);
  return folders
    .flatMap((folder) => readdirSync(folder, { recursive: true }).map((name) => join(folder, String(name))))
    .filter((path) => /\.(glb|gltf)$/.test(path) && !/[/\\](bad|out)[/\\]/.test(path))
    .filter((path) => asked.length === 0 || asked.some((part) => basename(path).includes(part)));
}

/** Runs a tool. Returns the last line of its error, or nothing. */
function run({ command, steps }, path, out) {
  try {
    for (const step of steps(path, out))
      execFileSync(process.execPath, [command, ...step], { stdio: 'pipe', timeout: 110_000 });
    return '';
  } catch (error) {
    if (command === limber && error.status === 2) return ''; // written, with more faces than were asked for
    return String(error.stderr ?? error.message)
      .trim()
      .split('\n')
      .pop()
      .replaceAll(path, basename(path))
      .replace(/^.*: (file requires)/, '$1')
      .slice(0, 100);
  }
}

const installed = Object.entries(TOOLS).filter(([name, { command }]) => {
  if (!existsSync(command)) console.log(`${name} is not at ${command}: it is left out.`);
  return existsSync(command);
});

async function measure(path) {
  const before = await inventoryOf(path);
  const own = [];
  for (const [tool, how] of installed) {
    const out = join(scratch, 'out', `${basename(path).replace(/\.\w+$/, '')}-${tool}.glb`);
    mkdirSync(dirname(out), { recursive: true });
    rmSync(out, { force: true });
    const error = run(how, path, out);
    const after = existsSync(out) && error === '' ? await inventoryOf(out) : null;
    own.push({ tool, error, after, losses: after ? lossesOf(before, after) : null });
  }
  return { name: basename(path), before, own };
}

const said = ({ error, losses, after }) => {
  if (!after) return `not written: ${error}`;
  return losses.length > 0 ? losses.join('; ') : 'nothing';
};

mkdirSync(scratch, { recursive: true });
const measured = [];
for (const path of await listFiles()) {
  const row = await measure(path);
  measured.push(row);
  for (const one of row.own) console.log([row.name, one.tool, one.after?.faces ?? '-', said(one)].join('\t'));
}

const totals = installed.map(([tool]) => {
  const own = measured.map((row) => row.own.find((one) => one.tool === tool));
  const written = own.filter(({ after }) => after);
  return [
    tool,
    `${written.length} of ${own.length}`,
    written.filter(({ losses }) => losses.length === 0).length,
    written.filter(({ after }, i) => after.errors > measured[own.indexOf(written[i])].before.errors).length,
  ];
});
const summary = table(
  ['tool', 'files written', 'nothing lost', 'more validator errors than the input'],
  totals,
);
const losing = measured.filter(({ own }) => own.some(({ losses }) => losses === null || losses.length > 0));
const rows = table(
  ['file', ...installed.map(([tool]) => `${tool} loses`)],
  losing.map(({ name, own }) => [name, ...own.map(said)]),
);
console.log(`\n${summary}`);
if (words.includes('--write'))
  await writeSection({
    name: 'survives',
    title: 'What survives',
    document: 'pictures.md',
    remark:
      'Files at half of their faces. These are counted in the JSON of input and output: scenes, named nodes, meshes, materials, textures, skins and joints, animations and their channels, morph targets, cameras, lights, variants, objects with extras, vertex attributes, extensions (except compression).',
    missing: [],
    sections: [summary, `The ${losing.length} files of which at least one tool loses something:`, rows],
  });
