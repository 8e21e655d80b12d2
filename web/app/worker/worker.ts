/** The worker's entry: runs the engine, one call at a time. */

import { expose, transfer } from 'comlink';
import { zipSync } from 'fflate';
import type { Core } from '../../engine/core/core';
import { droppedByExport } from '../../engine/document/export';
import { openModel } from '../../engine/document/open';
import type { OpenModel } from '../../engine/document/open';
import { describeHealth } from '../../engine/body/health';
import { loadCore } from '../../engine/core/load_core';
import { checkSettings } from '../../engine/settings/options';
import { isHeldBySeams } from '../../engine/stages/pipeline';
import { exportKey, historyKey, modesKey, resultKey } from '../state/keys';
import { CANCELLED } from './protocol';
import { carrySettingErrors } from './errors';
import { exportAll } from './exporting';
import type { WorkerApi } from './protocol';
import { BodyStages } from './session';
import { strainOverview } from './strain_overview';

let core: Core;
let model: OpenModel | null = null;
let bodies: BodyStages[] = [];

function stagesOf(body: number): BodyStages {
  const stages = bodies[body];
  if (!stages) throw new Error('No file is open: open one first.');
  return stages;
}

/** Errors lose their name on the way to the page: a cancelled call is known by its message. */
async function speak<T>(make: () => T | Promise<T>): Promise<T> {
  try {
    return await make();
  } catch (error) {
    throw error instanceof Error && error.name === 'Cancelled' ? new Error(CANCELLED) : error;
  }
}

/** The same files make the same archive. */
const ZIP_TIME = new Date(1980, 0, 1);

const api: WorkerApi = {
  start: async (wasmFolder, threads, onProgress) => {
    core = await loadCore({ wasmFolder, threads, onProgress: (progress) => onProgress(progress) });
    return { threads: core.threads, job: core.job };
  },
  open: (files) =>
    speak(async () => {
      const opened = await openModel(files);
      if (opened.bodies.length === 0)
        throw new Error(`${opened.name} holds no triangles: export a mesh with faces.`);
      model = opened;
      bodies = opened.bodies.map((_, i) => new BodyStages(core, opened, i));
      return {
        name: opened.name,
        format: opened.format,
        bodies: opened.bodies.map(({ name, indices, mesh }) => ({ name, faces: indices.length / 3, mesh })),
        notes: opened.notes,
        dropped: droppedByExport(opened),
      };
    }),
  prepare: (body, settings) =>
    speak(() => {
      checkSettings(settings);
      const { mesh, diagonal, inspection, quality, weld, body: source } = stagesOf(body).prepared(settings);
      const { minAngle, meanMinAngle } = quality;
      return {
        mesh,
        diagonal,
        scale: source.scale,
        inspection,
        minAngle,
        meanMinAngle,
        health: describeHealth(source, weld, inspection),
        vertexOfSource: weld.vertexOfSource,
        pinAttributes: stagesOf(body).pinAttributes(),
      };
    }),
  pins: (body, settings) => speak(() => ({ text: settings.pins, vertices: stagesOf(body).pinned(settings) })),
  modes: (body, settings) =>
    speak(() => {
      checkSettings(settings);
      const modes = stagesOf(body).modes(settings);
      const overview = strainOverview(core, stagesOf(body).prepared(settings).mesh, modes);
      return { ...modes, ...overview, key: modesKey(settings) };
    }),
  guidance: (body, settings) =>
    speak(() => {
      checkSettings(settings);
      return stagesOf(body).guidance(settings);
    }),
  curvature: (body, settings) => speak(() => stagesOf(body).curvature(settings)),
  history: (body, settings) =>
    speak(() => {
      checkSettings(settings);
      const { history, seconds } = stagesOf(body).history(settings);
      const { triangleCount, trianglesAfter, refused } = history;
      const { note } = stagesOf(body).held(settings);
      const heldBySeams = isHeldBySeams(stagesOf(body).prepared(settings), refused, settings);
      const floorFaces = trianglesAfter.at(-1) ?? triangleCount;
      return { faces: triangleCount, floorFaces, refused, heldBySeams, note, seconds };
    }),
  marks: (body, settings) =>
    speak(() => ({ marks: stagesOf(body).marks(settings), key: historyKey(settings) })),
  meshAt: (body, settings, faces) => speak(() => stagesOf(body).result(settings, faces)),
  fit: (body, settings, faces) =>
    speak(() => {
      const fitted = stagesOf(body).fitted(settings, faces);
      const isSame = fitted.result === stagesOf(body).result(settings, faces);
      const result = isSame ? null : fitted.result;
      return { ...fitted, result, key: `${resultKey(settings)} ${faces}` };
    }),
  why: (body, settings, faces) =>
    speak(() => ({ ...stagesOf(body).why(settings, faces), key: `${historyKey(settings)} ${faces}` })),
  measure: (body, settings, faces) =>
    speak(() => {
      const { quality, distance, certificate, inspection } = stagesOf(body).measured(settings, faces);
      const { minAngle, meanMinAngle } = quality;
      return {
        minAngle,
        meanMinAngle,
        hausdorff: distance.hausdorff,
        mean: distance.mean,
        certificate,
        inspection,
      };
    }),
  export: (settings, faces, request) =>
    speak(async () => {
      if (!model) throw new Error('No file is open: open one first.');
      const done = await exportAll({ core, model, bodies, settings, faces, request });
      const buffers = [done, ...done.levels].map(({ bytes }) => bytes.buffer);
      return transfer({ ...done, key: exportKey(settings, faces, request) }, buffers);
    }),
  pack: (files) => {
    const bytes = zipSync(files, { level: 6, mtime: ZIP_TIME });
    return Promise.resolve(transfer(bytes, [bytes.buffer]));
  },
};

carrySettingErrors();
expose(api);
