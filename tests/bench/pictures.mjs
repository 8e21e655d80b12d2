// Compares pictures of simplified files with those of gltfpack and glTF-Transform at their face counts. Needs `npm run build`.
//
//   node tests/bench/pictures.mjs [--ratio R] [--write] [NAME...]     NAME: parts of file names; --write: docs/pictures.md
//
// Files are the made scenes of tests/engine/support/scenes.ts, the samples, and where LIMBER_SHARED names it, the folder meshes/gltf
// there. PEERS: a folder with node_modules/gltfpack and node_modules/@gltf-transform/cli. Pictures of each file stand in
// build/bench/pictures: rows are the input, gltfpack, Limber; then glTF-Transform and Limber where that count is another one.

import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, readdirSync, readFileSync, statSync, writeFileSync } from 'node:fs';
import { basename, join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { bundleModule } from '../../scripts/setup/bundle.mjs';
import { drawn, psnr, viewsOf, writeSheet } from './pictures/draw.mjs';
import { openFile, shownTriangles, texturesOf } from './pictures/shown.mjs';
import { overlap, silhouettes } from './silhouette.mjs';

const root = resolve(import.meta.dirname, '..', '..');
const scratch = join(root, 'build', 'bench', 'pictures');
const words = process.argv.slice(2);
const valueOf = (flag, otherwise) => (words.includes(flag) ? words[words.indexOf(flag) + 1] : otherwise);
const ratio = Number(valueOf('--ratio', '0.5'));
const asked = words.filter((word, i) => !word.startsWith('--') && words[i - 1] !== '--ratio');
const peers = process.env.PEERS ?? root;
const limber = join(root, 'dist', 'cli', 'limber.mjs');
const gltfpack = join(peers, 'node_modules', 'gltfpack', 'cli.js');
const gltfTransform = join(peers, 'node_modules', '@gltf-transform', 'cli', 'bin', 'cli.js');

mkdirSync(scratch, { recursive: true });
await bundleModule('tests/bench/scenes_entry.ts', join(scratch, 'engine'));
const engine = await import(pathToFileURL(join(scratch, 'engine', 'scenes_entry.js')).href);

async function listFiles() {
  const made = {
    table: engine.tableScene(),
    palm: engine.palmScene(),
    boxes: engine.boxScene(),
    rooms: engine.roomScene(),
  };
  const files = [];
  for (const [name, document] of Object.entries(made)) {
    const path = join(scratch, `${name}.glb`);
    writeFileSync(path, (await engine.glbFile(document)).bytes);
    files.push(path);
  }
  const folders = [join(root, 'public', 'samples')];
  if (process.env.LIMBER_SHARED) folders.push(join(process.env.LIMBER_SHARED, 'meshes', 'gltf'));
  else console.log('LIMBER_SHARED is not set: only made scenes and samples are measured.');
  for (const folder of folders.filter(existsSync))
    files.push(
      ...readdirSync(folder, { recursive: true })
        .map(String)
        .filter((name) => /\.(glb|gltf)$/.test(name) && !name.startsWith('bad'))
        .map((name) => join(folder, name)),
    );
  return files.filter((path) => asked.length === 0 || asked.some((part) => basename(path).includes(part)));
}

/** Runs a tool; returns the last line of its error, or nothing. */
function run(command, ...given) {
  try {
    execFileSync(process.execPath, [command, ...given], { stdio: 'pipe', timeout: 110_000 });
    return '';
  } catch (error) {
    return String(error.stderr ?? error.message)
      .trim()
      .split('\n')
      .pop();
  }
}

/** What the two peers make of a file; computed once. */
function peerResults(path, name) {
  const made = [];
  const pack = join(scratch, `${name}-${ratio}-gltfpack.glb`);
  if (existsSync(gltfpack) && !isNewer(pack, path))
    run(gltfpack, '-i', path, '-o', pack, '-si', String(ratio), '-noq', '-kn', '-km');
  if (existsSync(pack)) made.push(['gltfpack', pack]);
  const welded = join(scratch, `${name}-welded.glb`);
  const transformed = join(scratch, `${name}-${ratio}-transform.glb`);
  if (existsSync(gltfTransform) && !isNewer(transformed, path)) {
    run(gltfTransform, 'weld', path, welded);
    run(gltfTransform, 'simplify', welded, transformed, '--ratio', String(ratio), '--error', '1');
  }
  if (existsSync(transformed)) made.push(['glTF-Transform', transformed]);
  return made;
}

const isNewer = (path, than) => existsSync(path) && statSync(path).mtimeMs >= statSync(than).mtimeMs;

async function picturesOf(path, views) {
  const model = await openFile(engine, path);
  const textures = await texturesOf(model);
  const shown = shownTriangles(engine, model, textures);
  const own = views ?? viewsOf(shown);
  const rest = own.map((view) => drawn(shown, view));
  return {
    model,
    views: own,
    rest,
    textures,
    faces: model.bodies.reduce((sum, { indices }) => sum + indices.length / 3, 0),
  };
}

/** dB in motion: over poses a third and two thirds through the animations of the file; null where no skin moves. */
function inMotion(before, after) {
  const count = poseCount(before.model);
  if (count === 0 || poseCount(after.model) !== count) return null;
  const poses = [Math.floor(count / 3), Math.floor((2 * count) / 3)];
  const [rows, others] = [[], []];
  for (const pose of poses) {
    const first = shownTriangles(engine, before.model, before.textures, pose);
    const views = viewsOf(first);
    const second = shownTriangles(engine, after.model, after.textures, pose);
    rows.push(...views.map((view) => drawn(first, view)));
    others.push(...views.map((view) => drawn(second, view)));
  }
  return psnr(rows, others);
}

const poseCount = ({ document, bodies }) =>
  Math.max(0, ...bodies.map((body) => engine.posesInAnimations(document, body).length));

async function measured(path, name) {
  const before = await picturesOf(path);
  const mask = await silhouettes(engine, path);
  const sheet = [before.rest];
  const rows = [];
  for (const [tool, result] of peerResults(path, name)) {
    const theirs = await picturesOf(result, before.views);
    const out = join(scratch, `${name}-${ratio}-${tool}-limber.glb`);
    const error = run(
      limber,
      'optimize',
      path,
      out,
      '--faces',
      String(theirs.faces),
      '--max-deviation',
      '0',
      '--quiet',
      '--force',
      '--threads',
      '1',
    );
    if (!existsSync(out)) {
      console.log(`${name}: ${error}`);
      continue;
    }
    const ours = await picturesOf(out, before.views);
    sheet.push(theirs.rest, ours.rest);
    const silhouetteOf = async (file) => overlap(mask, await silhouettes(engine, file, mask.views));
    rows.push({
      name,
      tool,
      input: before.faces,
      theirs: {
        faces: theirs.faces,
        psnr: psnr(before.rest, theirs.rest),
        motion: inMotion(before, theirs),
        ...(await silhouetteOf(result)),
      },
      ours: {
        faces: ours.faces,
        psnr: psnr(before.rest, ours.rest),
        motion: inMotion(before, ours),
        ...(await silhouetteOf(out)),
      },
    });
  }
  await writeSheet(join(scratch, `${name}-${ratio}.png`), sheet);
  return rows;
}

const number = (value, digits) => (value === null ? '' : value.toFixed(digits));
const line = ({ name, tool, input, theirs, ours }) =>
  [
    name,
    input,
    tool,
    `${theirs.faces} / ${ours.faces}`,
    `${number(theirs.psnr, 2)} / ${number(ours.psnr, 2)}`,
    number(ours.psnr - theirs.psnr, 2),
    theirs.motion === null || ours.motion === null
      ? ''
      : `${number(theirs.motion, 2)} / ${number(ours.motion, 2)}`,
    `${number(theirs.worst, 3)} / ${number(ours.worst, 3)}`,
    `${theirs.holes} / ${ours.holes}`,
  ].join(' | ');

const rows = [];
for (const path of await listFiles()) {
  const name = basename(path).replace(/\.\w+$/, '');
  try {
    for (const row of await measured(path, name)) {
      rows.push(row);
      console.log(line(row));
    }
  } catch (error) {
    console.log(`${name}: not measured: ${error.message}`);
  }
}
for (const tool of ['gltfpack', 'glTF-Transform']) {
  const own = rows.filter((row) => row.tool === tool);
  const gains = own.map(({ theirs, ours }) => ours.psnr - theirs.psnr);
  console.log(
    `${tool}: ${own.length} files, mean gain ${number(gains.reduce((a, b) => a + b, 0) / gains.length, 2)} dB`,
  );
}
if (words.includes('--write')) writeTable();

/** Replaces what stands between the marks in docs/pictures.md. */
function writeTable() {
  const path = join(root, 'docs', 'pictures.md');
  const [before, after] = ['<!-- table -->', '<!-- end -->'].map((mark) =>
    readFileSync(path, 'utf8').split(mark),
  );
  const head = '| file | faces | peer | faces left | dB | gain | dB in motion | silhouettes | seen through |';
  const table = [head, head.replace(/[^|]+/g, ' - '), ...rows.map((row) => `| ${line(row)} |`)].join('\n');
  writeFileSync(path, `${before[0]}<!-- table -->\n\n${table}\n\n<!-- end -->${after[1]}`);
}
