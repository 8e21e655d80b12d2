/** The only request of a file needs no collapses beyond what it asks for, and gives the same file as one that others follow. */

import { beforeAll, expect, it } from 'vitest';
import type { Core, TriangleMesh } from '../../web/engine/core/core';
import { faceCount } from '../../web/engine/core/mesh';
import { openModel } from '../../web/engine/document/open';
import { defaultSettings } from '../../web/engine/settings/options';
import type { Settings } from '../../web/engine/settings/options';
import type { FaceTarget } from '../../web/engine/stages/budget/face_shares';
import { requestFile } from '../../web/engine/stages/budget/file_targets';
import { FileOutput } from '../../web/engine/stages/file_output';
import { FileRun } from '../../web/engine/stages/file_run';
import { STAGES } from '../../web/engine/stages/stages';
import { loadTestCore } from './support/core';
import { textFile } from './support/files';
import { butterfly, cube, grid, toObj, torus } from './support/shapes';

let core: Core;
beforeAll(async () => {
  core = await loadTestCore(1);
});

async function answer(mesh: TriangleMesh, change: Partial<Settings>, target: FaceTarget, isOnly: boolean) {
  const model = await openModel([textFile('a.obj', toObj(mesh))]);
  const file = new FileRun(core, model);
  const settings = { ...defaultSettings(), ...change };
  const output = new FileOutput(file, requestFile(file, { settings, fields: true, isOnly, ...target }));
  const [first] = await output.files('a.glb');
  const levels = await Promise.all(settings.lods.map((_, n) => output.level(n, `a_${n}.glb`)));
  const { timings, ...report } = output.report(
    {},
    levels.map(({ report: level }, n) => ({ ...level, file: `a_${n}.glb` })),
  );
  const [history] = output.values(STAGES.history);
  const files = [first, ...levels.flatMap((level) => level.files)].map(({ bytes }) => bytes);
  file.dispose();
  return { answer: { files, report }, history, timings };
}

/** Every face a second time, wound the other way. */
const withBackSides = ({ positions, triangles }: TriangleMesh): TriangleMesh => ({
  positions,
  triangles: Uint32Array.from([...triangles, ...[...triangles].reverse()]),
});

const half: FaceTarget = { faces: null, ratio: 0.5 };
const CASES: [string, TriangleMesh, Partial<Settings>, FaceTarget][] = [
  ['a part of its faces', torus(), {}, half],
  ['a number of faces', torus(), { method: 'qem', maxDeviation: 0 }, { faces: 100, ratio: null }],
  ['fewer faces than it may have', torus(), { maxDeviation: 2 }, { faces: 20, ratio: null }],
  ['fewer faces than it can have', cube(), { maxDeviation: 0 }, { faces: 1, ratio: null }],
  ['further levels', torus(), { lods: [0.5, 0.2], maxDeviation: 0 }, half],
  ['pairs of mirror images', butterfly(), { symmetry: 'x' }, half],
  ['faces with back sides', withBackSides(grid(8, 6)), {}, half],
  ['low errors of frequencies', torus(), { maxFrequencyError: 3, maxDeviation: 0 }, half],
];

it.each(CASES)(
  'with %s gives the same result as with further requests',
  async (_name, mesh, change, target) => {
    const only = await answer(mesh, change, target, true);
    const any = await answer(mesh, change, target, false);
    expect(only.answer).toEqual(any.answer);
    expect(only.history.kept.length).toBeLessThanOrEqual(any.history.kept.length);
  },
);

it('ends its history at the requested faces', async () => {
  const only = await answer(torus(), { maxDeviation: 0 }, half, true);
  const any = await answer(torus(), { maxDeviation: 0 }, half, false);
  expect(only.history.trianglesAfter.at(-1)).toBeLessThanOrEqual(faceCount(torus()) / 2);
  expect(only.history.kept.length).toBeLessThan(0.7 * any.history.kept.length);
});
