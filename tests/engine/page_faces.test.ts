/** Faces as the page counts them: those that a result can have, duplicates included, in the scene and in its results. */

import { expect, it } from 'vitest';
import { describeBodies } from '../../web/app/worker/bodies';
import { exportAll } from '../../web/app/worker/exporting';
import { openModel } from '../../web/engine/document/open';
import { defaultSettings } from '../../web/engine/settings/options';
import { requestFile, shareFaces } from '../../web/engine/stages/budget/file_targets';
import { FileOutput } from '../../web/engine/stages/file_output';
import { FileRun } from '../../web/engine/stages/file_run';
import { loadTestCore } from './support/core';
import { textFile } from './support/files';
import { box, grid, toObj } from './support/shapes';

it('are the same in the list of bodies, on the slider and in what is written', async () => {
  const core = await loadTestCore(1);
  const { positions, triangles } = grid(12, 12);
  const copy = { positions: positions.map((x, i) => (i % 3 === 0 ? x + 50 : x)), triangles };
  const vertices = positions.length / 3;
  const second = toObj(copy).replaceAll(/^f .*/gm, (face) =>
    face.replaceAll(/\d+/g, (v) => String(Number(v) + vertices)),
  );
  // Two faces without area, and the first face of each body once more.
  const [one, two] = [`${toObj(grid(12, 12))}\nf 1 1 2\nf 2 3 3\n`, `${second}\n`];
  const twice = (text: string): string => `${text}${/^f .*/m.exec(text)![0]}\n`;
  const model = await openModel([textFile('two.obj', `o one\n${twice(one)}o two\n${twice(two)}`)]);
  const file = new FileRun(core, model, { guides: true });
  file.prepare(defaultSettings());
  const bodies = describeBodies(file);
  expect(bodies.map(({ faces }) => faces)).toEqual([289, 289]);
  const asked = {
    settings: { ...defaultSettings(), maxDeviation: 0 },
    fields: false,
    faces: null,
    ratio: 0.5,
    own: new Map(),
  };
  expect(shareFaces(file, asked)).toMatchObject({ faces: 578, wanted: 289 });
  const request = requestFile(file, asked);
  const output = new FileOutput(file, request);
  const written = output.writtenFacesOfBodies();
  const exported = await exportAll(file, request, { output: 'two.glb', fields: false, binding: false });
  const after = written[0] + written[1];
  expect([exported.faces, exported.report.output!.faces]).toEqual([after, after]);
  expect(after).toBeLessThanOrEqual(289);
  expect(after).toBeGreaterThan(280);
  file.dispose();
});

it('are those that bodies stop at where a scene cannot have so few as are asked for', async () => {
  const core = await loadTestCore(1);
  const { positions, triangles } = box(3, 3, 3);
  const copy = { positions: positions.map((x, i) => (i % 3 === 0 ? x + 50 : x)), triangles };
  const second = toObj(copy).replaceAll(/^f .*/gm, (face) =>
    face.replaceAll(/\d+/g, (v) => String(Number(v) + positions.length / 3)),
  );
  const text = `o one\n${toObj(box(3, 3, 3))}o two\n${second}\n`;
  const file = new FileRun(core, await openModel([textFile('two.obj', text)]), { guides: true });
  file.prepare(defaultSettings());
  const asked = { settings: defaultSettings(), fields: false, faces: 3, ratio: null, own: new Map() };
  const { fewest, targets, expected } = shareFaces(file, asked);
  // A closed body has four faces at least.
  expect(fewest).toBe(8);
  expect(targets).toEqual([1, 1]);
  expect(expected).toEqual([4, 4]);
  const enough = shareFaces(file, { ...asked, faces: 100 });
  expect(enough.expected).toEqual(enough.targets);
  file.dispose();
});
