/** Fuzz targets of texts that come back from outside: configurations of batches, links, what a tab has kept, bindings. */

import { readLink, writeLink } from '../../../web/app/state/link';
import { readSaved } from '../../../web/app/state/saved_text';
import { readBinding, writeBinding } from '../../../web/engine/report/binding_file';
import {
  BATCH_SCHEMA,
  optionsFor,
  readBatchConfig,
  settingsFor,
} from '../../../web/engine/settings/batch_config';
import { OPTIONS, SETTING_NAMES } from '../../../web/engine/settings/options';
import { matchesPath } from '../../../web/engine/settings/path_pattern';
import type { Choices } from './choices';
import type { FuzzTarget } from './fuzz_target';
import { anyWord, mutateText, mutatedJsonText } from './mutate';

const BATCH = {
  schema: BATCH_SCHEMA,
  options: { method: 'limber', ratio: 0.25, pins: 'box:0,0,0:1,1,1', maxDeviation: 0.5, fields: true },
  overrides: [
    { files: ['props/**/*.obj', 'a?.{obj,ply}'], options: { faces: 100, soft: true } },
    { files: ['*'], options: { model: 'shell', modeCount: 6 } },
  ],
  exclude: ['**/old/**'],
};

const batchConfigs: FuzzTarget = {
  name: 'batch configurations',
  run: (choices) => {
    const config = readBatchConfig(mutatedJsonText(BATCH, choices.below(5), choices), 'b.json');
    settingsFor(optionsFor(config, choices.pick(['props/x/a.obj', 'a1.ply', 'b']), {}));
  },
};

const pathPatterns: FuzzTarget = {
  name: 'patterns of paths',
  run: (choices) => {
    const letters = ['a', 'b', '*', '**', '/', '?', '{', '}', ',', '[', ']', '\\', '.', '😀'];
    matchesPath(anyWord(letters, 20, choices), anyWord(letters, 20, choices));
  },
};

const LINKS = [
  'method=paper&ratio=0.5&faces=100&own=1:20,3:5&body=1&file=a.glb',
  'pins=box:0,0,0:1,1,1&paint=0:A1B2C3&max-deviation=0.5%25',
  'strain-weight=2&modes=1-4,7&model=shell&symmetry=on',
];

function anyLink(choices: Choices): string {
  let link = choices.pick(LINKS);
  if (choices.chance(0.5))
    link += `&${OPTIONS[choices.pick(SETTING_NAMES)].flag}=${choices.pick(['1', '', 'x', '-1', '%', '1e999'])}`;
  for (let left = choices.below(5); left > 0; --left) link = mutateText(link, choices);
  return link;
}

const links: FuzzTarget = {
  name: 'links',
  run: (choices) => {
    const wanted = readLink(anyLink(choices));
    if (wanted === null) return;
    const link = writeLink(wanted);
    const again = readLink(link);
    if (again !== null && writeLink(again) !== link)
      throw new TypeError(`The link ${link} reads as another one.`);
  },
};

const savedTexts: FuzzTarget = {
  name: 'saved state',
  run: (choices) => {
    const saved = {
      link: anyLink(choices),
      step: 'motion',
      layout: 'slider',
      field: 'strain',
      undo: { past: [anyLink(choices), LINKS[0]], future: [LINKS[1]] },
    };
    let text = mutatedJsonText(saved, choices.below(5), choices);
    if (choices.chance(0.1)) text = text.slice(0, choices.below(text.length));
    try {
      readSaved(text);
    } catch (error) {
      // It is read by `sessionOf` alone, which goes on without it.
      if (!(error instanceof SyntaxError)) throw error;
    }
  },
};

const binding = {
  triangle: Uint32Array.of(0, 0, 1),
  barycentric: Float32Array.of(1, 0, 0, 0, 1, 0, 0.5, 0.5, 0),
  offset: Float32Array.of(0, 0, 0.5),
};
const BINDING = JSON.parse(writeBinding([{ name: 'a', mesh: 0, faces: 2, binding }])) as object;

const bindings: FuzzTarget = {
  name: 'bindings',
  run: (choices) => {
    for (const { mesh, faces, binding } of readBinding(
      'a.json',
      mutatedJsonText(BINDING, choices.below(5), choices),
    )) {
      if (!Number.isInteger(mesh) || !Number.isInteger(faces)) throw new TypeError('A body has no numbers.');
      if (![...binding.barycentric, ...binding.offset].every(Number.isFinite))
        throw new TypeError('A bound vertex is nowhere.');
    }
  },
};

export const keptTextTargets: FuzzTarget[] = [batchConfigs, pathPatterns, links, savedTexts, bindings];
