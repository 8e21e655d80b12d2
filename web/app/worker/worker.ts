/** The worker's entry: runs the engine, one call at a time. */

import { expose, transfer } from 'comlink';
import type { Core } from '../../engine/core';
import { droppedByExport, exportGlb } from '../../engine/document/export';
import { openModel } from '../../engine/document/open';
import type { OpenModel } from '../../engine/document/open';
import { validateGlb } from '../../engine/document/validate';
import { describeHealth } from '../../engine/health';
import { loadCore } from '../../engine/load_core';
import { checkSettings } from '../../engine/options';
import type { Settings } from '../../engine/options';
import { exportedBody, startStopwatch } from '../../engine/pipeline';
import type { Report } from '../../engine/report';
import { meshReport, modesReport, startReport, stopReport, worstSurface } from '../../engine/report';
import { historyKey, modesKey, resultKey } from '../state/keys';
import { CANCELLED } from './protocol';
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

function reportOf(settings: Settings, faces: number[], seconds: number): Report {
  const results = bodies.map((stages, i) => ({
    prepared: stages.prepared(settings),
    measured: stages.measured(settings, faces[i]),
    guiding: stages.guidingModes(settings),
    history: stages.history(settings),
    targetFaces: faces[i],
    faces: stages.fitted(settings, faces[i]).result.mesh.triangles.length / 3,
    frequency: stages.fitted(settings, faces[i]).frequency,
  }));
  const total = faces.reduce((sum, count) => sum + count, 0);
  const report = startReport(
    core,
    'optimize',
    { ...settings, faces: total },
    results.map(({ prepared }) => prepared),
  );
  report.output = meshReport(results.map(({ measured }) => measured));
  const sets = results.flatMap(({ guiding }) => (guiding ? [guiding] : []));
  if (sets.length > 0) Object.assign(report, modesReport(sets));
  report.surface = worstSurface(results.map(({ measured }) => measured.distance));
  report.stop = stopReport(results.map((result) => ({ ...result, history: result.history.history })));
  report.timings = {
    simplify: results.reduce((sum, { history }) => sum + history.seconds, 0),
    export: seconds,
  };
  return report;
}

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
      const floorFaces = trianglesAfter.at(-1) ?? triangleCount;
      return { faces: triangleCount, floorFaces, refused, note, seconds };
    }),
  marks: (body, settings) =>
    speak(() => ({ marks: stagesOf(body).marks(settings), key: historyKey(settings) })),
  meshAt: (body, settings, faces) => speak(() => stagesOf(body).result(settings, faces)),
  fit: (body, settings, faces) =>
    speak(() => ({ ...stagesOf(body).fitted(settings, faces), key: `${resultKey(settings)} ${faces}` })),
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
  export: (settings, faces, fields) =>
    speak(async () => {
      if (!model) throw new Error('No file is open: open one first.');
      const stopwatch = startStopwatch();
      const exported = bodies.map((stages, i) =>
        exportedBody(
          core,
          stages.prepared(settings),
          stages.fitted(settings, faces[i]).result,
          fields
            ? {
                guidance: settings.method === 'qem' ? null : stages.guidance(settings),
                curvature: stages.curvature(settings),
              }
            : null,
        ),
      );
      const bytes = await exportGlb(model, exported, { fields });
      const validation = await validateGlb(bytes);
      const report = reportOf(settings, faces, stopwatch());
      const count = bodies.reduce(
        (sum, s, i) => sum + s.fitted(settings, faces[i]).result.mesh.triangles.length / 3,
        0,
      );
      return transfer({ bytes, validation, report, faces: count }, [bytes.buffer]);
    }),
};

expose(api);
