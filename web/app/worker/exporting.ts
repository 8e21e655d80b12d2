/** The file of all bodies, its further levels, the binding and the report, from what the stages have computed. */

import { bindingOfBody, writeBinding } from '../../engine/report/binding_file';
import type { Core, MeshAt } from '../../engine/core/core';
import { exportGlb } from '../../engine/document/export';
import type { OpenModel } from '../../engine/document/open';
import { validateGlb } from '../../engine/document/validate';
import { methodOf } from '../../engine/settings/options';
import type { Settings } from '../../engine/settings/options';
import { exportedBody, measureResult, startStopwatch } from '../../engine/stages/pipeline';
import { meshReport, resultReport, startReport, stopReport, worstSurface } from '../../engine/report/report';
import type { LevelReport, Report, StoppedBody } from '../../engine/report/report';
import { facesByRatio } from '../../engine/stages/face_shares';
import type { ExportedLevel, ExportRequest, ExportResult } from './protocol';
import type { BodyStages } from './session';

/** What is exported: `faces` per body. */
export interface Exporter {
  core: Core;
  model: OpenModel;
  bodies: BodyStages[];
  settings: Settings;
  faces: number[];
  request: ExportRequest;
}

const facesOf = ({ mesh }: MeshAt): number => mesh.triangles.length / 3;
const sum = (values: number[]): number => values.reduce((a, b) => a + b, 0);

export async function exportAll(exporter: Exporter): Promise<Omit<ExportResult, 'key'>> {
  const { bodies, settings, faces, request } = exporter;
  const stopwatch = startStopwatch();
  const results = bodies.map((stages, i) => stages.fitted(settings, faces[i]).result);
  const bytes = await writeFile(exporter, results);
  const validation = await validateGlb(bytes);
  const exportTime = stopwatch();
  const levels: (ExportedLevel & { report: LevelReport })[] = [];
  for (const [i, ratio] of settings.lods.entries())
    levels.push(
      await exportLevel(exporter, { ratio, name: request.output.replace(/\.glb$/, `_lod${i + 1}$&`) }),
    );
  const levelsTime = stopwatch();
  const report = reportOf(exporter);
  if (levels.length > 0) report.levels = levels.map((level) => level.report);
  report.timings = {
    ...report.timings,
    export: exportTime,
    ...(levels.length > 0 ? { levels: levelsTime } : {}),
  };
  const files = levels.map(({ name, faces: count, bytes: own, validation: verdict }) => ({
    name,
    faces: count,
    bytes: own,
    validation: verdict,
  }));
  const binding = request.binding ? bindingText(exporter, results) : null;
  return { bytes, validation, report, faces: sum(results.map(facesOf)), levels: files, binding };
}

/** One GLB with a result for each body. */
function writeFile(
  { core, model, bodies, settings, request }: Exporter,
  results: MeshAt[],
): Promise<Uint8Array> {
  const { fields } = request;
  const exported = bodies.map((stages, i) => {
    const guidance = fields && methodOf(settings).needsGuidance ? stages.guidance(settings) : null;
    const shown = fields ? { guidance, curvature: stages.curvature(settings) } : null;
    return exportedBody(core, stages.prepared(settings), results[i], shown);
  });
  return exportGlb(model, exported, { fields });
}

async function exportLevel(
  exporter: Exporter,
  { ratio, name }: { ratio: number; name: string },
): Promise<ExportedLevel & { report: LevelReport }> {
  const { core, bodies, settings } = exporter;
  const levels = bodies.map((stages) => {
    const prepared = stages.prepared(settings);
    const targetFaces = Math.max(1, facesByRatio(ratio, prepared.mesh.triangles.length / 3));
    const result = stages.level(settings, targetFaces);
    const { history } = stages.history(settings);
    const stopped: StoppedBody = { faces: facesOf(result), targetFaces, history };
    return { result, stopped, measured: measureResult(core, prepared, result) };
  });
  const bytes = await writeFile(
    exporter,
    levels.map(({ result }) => result),
  );
  const output = meshReport(levels.map(({ measured }) => measured));
  const surface = worstSurface(levels.map(({ measured }) => measured.distance));
  const stop = stopReport(levels.map(({ stopped }) => stopped));
  const report: LevelReport = { file: name, ratio, output, surface, stop };
  const faces = sum(levels.map(({ result }) => facesOf(result)));
  return { name, faces, bytes, validation: await validateGlb(bytes), report };
}

function bindingText({ core, bodies, settings }: Exporter, results: MeshAt[]): string {
  return writeBinding(
    bodies.map((stages, i) => {
      const prepared = stages.prepared(settings);
      return bindingOfBody(prepared, facesOf(results[i]), core.bindToResult(prepared.mesh, results[i]));
    }),
  );
}

function reportOf({ core, bodies, settings, faces }: Exporter): Report {
  const results = bodies.map((stages, i) => {
    const fitted = stages.fitted(settings, faces[i]);
    const { result, frequency } = fitted;
    const { history, seconds } = stages.history(settings);
    const stopped: StoppedBody = { faces: facesOf(result), targetFaces: faces[i], history, frequency };
    const measured = stages.measured(settings, faces[i]);
    return { measured, modes: stages.guidingModes(settings), fitted, stopped, seconds };
  });
  const prepared = bodies.map((stages) => stages.prepared(settings));
  const report = startReport(core, 'optimize', { ...settings, faces: sum(faces) }, prepared);
  Object.assign(report, resultReport(results));
  report.timings = { simplify: sum(results.map(({ seconds }) => seconds)) };
  return report;
}
