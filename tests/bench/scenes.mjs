// Measures how much of the silhouettes of scenes is left at half of their faces, beside gltfpack. Needs `npm run build`.
//
//   node tests/bench/scenes.mjs [--parts N]     N: times a file of N parts too
//
// Scenes are those of tests/engine/support/scenes.ts and, where LIMBER_SHARED names it, the folder meshes/gltf there.
// GLTFPACK: path of gltfpack's cli.js, where it is not installed here.

import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, readdirSync, writeFileSync } from 'node:fs';
import { basename, join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { bundleModule } from '../../scripts/setup/bundle.mjs';
import { silhouettes, overlap } from './silhouette.mjs';

const root = resolve(import.meta.dirname, '..', '..');
const scratch = join(root, 'build', 'bench', 'scenes');
const limber = join(root, 'dist', 'cli', 'limber.mjs');
const gltfpack = process.env.GLTFPACK ?? join(root, 'node_modules', 'gltfpack', 'cli.js');
const parts = process.argv.includes('--parts')
  ? Number(process.argv[process.argv.indexOf('--parts') + 1])
  : 0;

mkdirSync(scratch, { recursive: true });
await bundleModule('tests/bench/scenes_entry.ts', join(scratch, 'engine'));
const scenes = await import(pathToFileURL(join(scratch, 'engine', 'scenes_entry.js')).href);

const made = {
  table: scenes.tableScene(),
  palm: scenes.palmScene(),
  leaf: scenes.twoSidedLeaf(),
  boxes: scenes.boxScene(),
  rooms: scenes.roomScene(),
};
const files = [];
for (const [name, document] of Object.entries(made)) {
  const path = join(scratch, `${name}.glb`);
  writeFileSync(path, (await scenes.glbFile(document)).bytes);
  files.push(path);
}
const shared = process.env.LIMBER_SHARED && join(process.env.LIMBER_SHARED, 'meshes', 'gltf');
if (shared && existsSync(shared))
  files.push(
    ...readdirSync(shared)
      .filter((name) => /\.(glb|gltf)$/.test(name))
      .map((name) => join(shared, name)),
  );
else console.log('LIMBER_SHARED names no folder with meshes/gltf: only the made scenes are measured.');
if (!existsSync(gltfpack)) console.log(`gltfpack is not at ${gltfpack}: it is left out.`);

/** The last line of an error, for the table. */
const run = (command, words) => {
  try {
    execFileSync(process.execPath, [command, ...words], { stdio: 'pipe', timeout: 110_000 });
    return '';
  } catch (error) {
    return String(error.stderr ?? error.message)
      .trim()
      .split('\n')
      .pop()
      .slice(0, 60);
  }
};

const percent = (value) => value.toFixed(4);
console.log(
  ['file', 'faces', 'limber', 'overlap', 'seen through', 'gltfpack', 'overlap', 'seen through'].join('\t'),
);
for (const path of files) {
  const name = basename(path);
  let before;
  try {
    before = await silhouettes(scenes, path);
  } catch (error) {
    console.log([name, `not read: ${error.message.slice(0, 60)}`].join('\t'));
    continue;
  }
  const row = [name, before.faces];
  const outputs = [
    ['limber', limber, (out) => ['optimize', path, out, '--quiet', '--threads', '1']],
    ...(existsSync(gltfpack)
      ? [['gltfpack', gltfpack, (out) => ['-i', path, '-o', out, '-si', '0.5', '-noq', '-kn']]]
      : []),
  ];
  for (const [tool, command, words] of outputs) {
    const out = join(scratch, `${name.replace(/\.\w+$/, '')}-${tool}.glb`);
    const error = run(command, words(out));
    if (error !== '' || !existsSync(out)) {
      row.push(error, '', '');
      continue;
    }
    const after = await silhouettes(scenes, out, before.views);
    const { worst, holes } = overlap(before, after);
    row.push(after.faces, percent(worst), holes);
  }
  console.log(row.join('\t'));
}

if (parts > 0) {
  const path = join(scratch, `parts${parts}.glb`);
  writeFileSync(path, (await scenes.glbFile(scenes.partsScene(parts))).bytes);
  const start = performance.now();
  const error = run(limber, ['optimize', path, join(scratch, 'parts-limber.glb'), '--quiet']);
  console.log(`${parts} parts: ${((performance.now() - start) / 1000).toFixed(1)} s ${error}`);
}
