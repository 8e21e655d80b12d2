// The entry of the bundle of seconds.mjs: generators, how files are read, and a tuning without its motion trial.

import type { Core, TriangleMesh } from '../../web/engine/core/core';
import { openModel } from '../../web/engine/document/open';
import { defaultSettings } from '../../web/engine/settings/options';
import type { SolverName } from '../../web/engine/solvers/profiles';
import { BodyRun } from '../../web/engine/stages/body_run';
import { STAGES } from '../../web/engine/stages/stages';
import { tuneMesh } from '../../web/engine/stages/tune';
import { addMesh, glbFile, primitiveOf, startDocument } from '../engine/support/gltf';
import { ball, moved, partsScene } from '../engine/support/scenes';

export { loadCore } from '../../web/engine/core/load_core';

/** A ball with bumps of many sizes, of about so many faces. */
export function bumpyBall(faces: number): TriangleMesh {
  const bump = (x: number, y: number, z: number): number =>
    [1, 2, 4, 8, 16].reduce(
      (sum, k) => sum + (0.12 / k) * Math.sin(3 * k * x + k) * Math.sin(2.6 * k * y) * Math.cos(2.3 * k * z),
      1,
    );
  return moved(ball(Math.round(Math.sqrt(faces / 4))), (x, y, z) =>
    [1.6 * x, y, 0.8 * z].map((value) => value * bump(x, y, z)),
  );
}

const bytesOf = async (document: ReturnType<typeof startDocument>): Promise<Uint8Array> =>
  (await glbFile(document)).bytes;

export function ballFile(faces: number): Promise<Uint8Array> {
  const document = startDocument();
  addMesh(document, 'ball', [primitiveOf(document, bumpyBall(faces))]);
  return bytesOf(document);
}

export const partsFile = (count: number): Promise<Uint8Array> => bytesOf(partsScene(count));

/** Seconds that a tuning of a quarter of the faces takes, without the motion trial, and what is left of the error, in %. */
export async function timeTuning(core: Core, faces: number, solver: SolverName) {
  const { bodies } = await openModel([{ name: 'ball.glb', bytes: await ballFile(faces) }]);
  const run = new BodyRun({ core, body: bodies[0], document: null });
  const settings = { ...defaultSettings(), solver, maxDeviation: 0, targetFaces: faces / 4, fields: false };
  const none = new Uint32Array();
  const [prepared, { result }] = [run.get(STAGES.prepared, settings), run.get(STAGES.fitted, settings)];
  const start = performance.now();
  const coarse = { mesh: result.mesh, pinned: none, pinnedOriginal: none };
  const { tuned } = tuneMesh(core, prepared, coarse, { ...settings, runsTrial: false });
  const seconds = (performance.now() - start) / 1000;
  run.dispose();
  return { seconds, error: tuned.frequencies.errorTuned };
}
