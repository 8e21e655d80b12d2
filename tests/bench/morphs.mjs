// Measures what morph targets gain where collapses count them. Needs `npm run build`.
//
//   node tests/bench/morphs.mjs [--write] [NAME...]     --write: into docs/pictures.md; NAME: of these meshes alone
//
// The meshes are those of ../shared/meshes ($LIMBER_SHARED/meshes); their targets are bumps made here.

import { existsSync, readFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { bundleModule } from '../../scripts/setup/bundle.mjs';
import { table, tellMissing, writeSection } from './section.mjs';

const root = resolve(import.meta.dirname, '..', '..');
const shared = join(process.env.LIMBER_SHARED ?? join(root, '..', 'shared'), 'meshes');
const RATIO = 0.25;
const MESHES = { spot: 'spot_uv.obj', goathead: 'goathead.obj', bob: 'bob_genus1.obj' };
const BUMPS = [
  { count: 6, share: 1 },
  { count: 40, share: 0.15 },
];

const scratch = join(root, 'build', 'bench', 'morphs');
await bundleModule('tests/bench/morphs_entry.ts', scratch);
const { loadCore, measureMorphs } = await import(pathToFileURL(join(scratch, 'morphs_entry.js')).href);
const core = await loadCore({
  threads: 1,
  wasmFolder: pathToFileURL(join(root, 'public', 'wasm', '/')).href,
});

const words = process.argv.slice(2);
const wanted = words.filter((word) => !word.startsWith('--'));
const names = Object.keys(MESHES).filter((name) => wanted.length === 0 || wanted.includes(name));
const missing = names.filter((name) => !existsSync(join(shared, MESHES[name])));

const rows = [];
for (const name of names.filter((one) => !missing.includes(one))) {
  const obj = new Uint8Array(readFileSync(join(shared, MESHES[name])));
  for (const bumps of BUMPS) {
    const { before, ignored, counted } = await measureMorphs(core, obj, { bumps, ratio: RATIO });
    const pair = (key, digits) => `${ignored[key].toFixed(digits)} / ${counted[key].toFixed(digits)}`;
    rows.push([name, bumps.count, `${before} -> ${counted.faces}`, pair('largest', 3), pair('rest', 4)]);
    console.log(rows.at(-1).join('\t'));
  }
}
tellMissing(missing);
const measures = table(['mesh', 'bumps', 'faces', 'largest with a target, %', 'mean at rest, %'], rows);
if (words.includes('--write'))
  await writeSection({
    name: 'morphs',
    title: 'The gain from counting morph targets',
    document: 'pictures.md',
    remark:
      'A quarter of the faces, `--max-deviation 0`; each pair is without and with the targets in the error measure. A bump is 5 % of the diagonal high. Six are spread over a body; forty overlap in the part with the first 15 % of its vertices. The largest distance is measured with one target at full weight and averaged over the targets; all distances are in % of the diagonal.',
    missing,
    sections: [measures],
  });
