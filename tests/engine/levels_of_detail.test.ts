// Files that have levels of detail already keep them as levels of each other.

import { beforeAll, describe, expect, it } from 'vitest';
import type { Core } from '../../web/engine/core/core';
import { withKnownLevels } from '../../web/engine/document/facts/levels_of_detail';
import { openModel } from '../../web/engine/document/open';
import { defaultSettings } from '../../web/engine/settings/options';
import { requestFile } from '../../web/engine/stages/budget/file_targets';
import { FileRun } from '../../web/engine/stages/file_run';
import { checkWritten } from '../../web/engine/stages/written_form';
import { loadTestCore } from './support/core';
import { failureOf } from './support/files';
import { addMesh, glbFile, primitiveOf, startDocument } from './support/gltf';
import { ball } from './support/scenes';

let core: Core;
beforeAll(async () => {
  core = await loadTestCore(1);
});

/** A fine and a coarse ball whose nodes have these names. */
async function modelOf(...names: string[]) {
  const document = startDocument();
  for (const [i, name] of names.entries())
    addMesh(document, name, [primitiveOf(document, ball(12 - 6 * i))])
      .listParents()
      .forEach((parent) => parent.propertyType === 'Node' && parent.setName(name));
  return openModel([await glbFile(document)]);
}

const settings = { ...defaultSettings(), method: 'qem', maxDeviation: 0 } as const;
const NOTE =
  'levels of detail: each keeps the same share of its faces, and the settings for when it is shown stay unchanged';

describe('levels of detail of a file', () => {
  it.each([
    [['ball_LOD0', 'ball_LOD1'], true],
    [['ball-lod1', 'ball-lod2'], true],
    [['ball_LOD0', 'cube_LOD1'], false],
    [['ball_LOD0', 'ball_LOD0'], false],
    [['ball1', 'ball2'], false],
  ])('are nodes of one name with different numbers: %j', async (names, expected) => {
    const model = await modelOf(...names);
    expect(model.hasLevels ?? false).toBe(expected);
    expect(model.notes.includes(NOTE)).toBe(expected);
  });

  it('are nodes that MSFT_lod names', async () => {
    const model = await modelOf('near', 'far');
    const extension = {
      name: 'MSFT_lod',
      path: ['nodes', 0],
      value: { ids: [1] },
      obstacle: null,
    };
    const foreign = {
      extensions: [extension],
      listed: { used: [], required: [] },
      textures: [],
      samplers: [],
    };
    expect(withKnownLevels({ ...model, foreign }).hasLevels).toBe(true);
  });

  it('are groups of an OBJ too', async () => {
    const text = ['v 0 0 0', 'v 1 0 0', 'v 0 1 0', 'o ball_LOD0', 'f 1 2 3', 'o ball_LOD1', 'f 3 2 1', ''];
    const model = await openModel([{ name: 'a.obj', bytes: new TextEncoder().encode(text.join('\n')) }]);
    expect([model.hasLevels, model.notes.includes(NOTE)]).toEqual([true, true]);
  });

  it('keep the same share of their faces, so that none becomes coarser than the next', async () => {
    const targetsOf = async (...names: string[]) => {
      const file = new FileRun(core, await modelOf(...names), { guides: false });
      file.prepare(settings);
      const { targets } = requestFile(file, { settings, fields: false, faces: null, ratio: 0.5 });
      file.dispose();
      return targets;
    };
    const [fine, coarse] = [12, 6].map((rings) => ball(rings).triangles.length / 3);
    expect(await targetsOf('ball_LOD0', 'ball_LOD1')).toEqual([fine / 2, coarse / 2]);
    expect(await targetsOf('ball', 'other')).not.toEqual([fine / 2, coarse / 2]);
  });

  it('cannot get further levels inside the same file', async () => {
    const model = await modelOf('ball_LOD0', 'ball_LOD1');
    const check = (lodStyle: 'msft' | 'files') =>
      checkWritten(model, [0, 1], { name: 'a.glb', settings: { ...settings, lods: [0.5], lodStyle } });
    expect(await failureOf(() => check('msft'))).toBe(
      '“Levels go into” would put levels into test.glb, which already has levels of detail: give files, or leave out “Further levels”.',
    );
    expect(check('files').lost).toEqual([]);
  });
});
