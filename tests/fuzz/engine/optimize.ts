/** The fuzz target of a whole optimization: any mesh with any settings, to a file that can be read again. */

import type { Core } from '../../../web/engine/core/core';
import { openAnyModel, openModel } from '../../../web/engine/document/open';
import { OPTIONS, SETTING_NAMES, checkSettings } from '../../../web/engine/settings/options';
import type { Settings } from '../../../web/engine/settings/options';
import { defaultSettings } from '../../../web/engine/settings/methods';
import { requestFile } from '../../../web/engine/stages/budget/file_targets';
import { FileOutput } from '../../../web/engine/stages/file_output';
import { FileRun } from '../../../web/engine/stages/file_run';
import { butterfly, cube, grid, toObj, torus } from '../../engine/support/shapes';
import type { Choices } from './choices';
import type { FuzzTarget } from './fuzz_target';

const SHAPES = [toObj(grid(4, 3)), toObj(cube()), toObj(torus(8, 5)), toObj(butterfly(3, 4))];
const SPECIAL = ['0', '1e30', '-1e30', '1e-30', '1e-38', '1', '0.5', '3.4e38'];

/** The lines of an OBJ with some coordinates and corners replaced, scaled by any power of ten. */
function drawObj(choices: Choices): string {
  const lines = choices.pick(SHAPES).split('\n');
  const vertices = lines.filter((line) => line.startsWith('v ')).length;
  for (let left = choices.below(6); left > 0; --left) {
    const at = choices.below(lines.length);
    const words = lines[at].split(' ');
    if (words.length < 4) continue;
    words[1 + choices.below(3)] =
      words[0] === 'v' ? choices.pick(SPECIAL) : String(1 + choices.below(vertices));
    lines[at] = words.join(' ');
    if (choices.chance(0.2)) lines.push(lines[at]);
  }
  if (!choices.chance(0.3)) return lines.join('\n');
  const scale = 10 ** (choices.below(60) - 30);
  return lines
    .map((line) =>
      line.startsWith('v ') ? line.replace(/[-\d.e+]+/g, (word) => String(Number(word) * scale)) : line,
    )
    .join('\n');
}

/** Settings of which some are at an end of their range. */
function drawSettings(choices: Choices): Settings {
  const settings = defaultSettings(choices.pick(['limber', 'limber', 'paper', 'qem'] as const));
  // A lattice costs a thousand times what a shell of so few faces costs.
  if (choices.chance(0.9)) settings.model = 'shell';
  for (let left = choices.below(4); left > 0; --left) {
    const name = choices.pick(SETTING_NAMES);
    const option = OPTIONS[name];
    const ends = 'min' in option ? [option.min, option.max].filter((end) => Number.isFinite(end)) : [];
    const values: unknown[] =
      option.kind === 'choice' ? [...option.choices] : option.kind === 'switch' ? [true, false] : ends;
    if (values.length > 0) Object.assign(settings, { [name]: choices.pick(values) });
  }
  checkSettings(settings);
  return settings;
}

export const optimizeTarget = (core: Core): FuzzTarget => ({
  name: 'optimize',
  run: async (choices) => {
    const settings = drawSettings(choices);
    const bytes = new TextEncoder().encode(drawObj(choices));
    const model = await openModel([{ name: 'a.obj', bytes }]);
    const file = new FileRun(core, model);
    try {
      file.prepare(settings);
      const ratio = (1 + choices.below(100)) / 100;
      const output = new FileOutput(
        file,
        requestFile(file, { settings, fields: choices.chance(0.1), faces: null, ratio }),
      );
      output.compute();
      const written = await openAnyModel([{ name: 'a.glb', bytes: await output.glb() }]);
      const facesOf = ({ bodies }: typeof model) =>
        bodies.reduce((sum, { indices }) => sum + indices.length / 3, 0);
      if (facesOf(written) > facesOf(model)) throw new TypeError('The result has more faces than the input.');
      const values = written.bodies.flatMap(({ positions }) => [...positions]);
      if (!values.every(Number.isFinite)) throw new TypeError('A position of the result is not finite.');
    } finally {
      file.dispose();
    }
  },
});
