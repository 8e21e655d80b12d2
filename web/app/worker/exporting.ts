/** The file of all bodies, checked: the engine writes it, its further levels, the binding, the settings and the report. */

import { startStopwatch } from '../../engine/core/stopwatch';
import { faceCount, sum } from '../../engine/core/mesh';
import { validateGlb } from '../../engine/document/validate';
import { settingsAsUsed } from '../../engine/report/report';
import type { LevelReport } from '../../engine/report/result_report';
import { FileOutput } from '../../engine/stages/file_output';
import type { FileRequest } from '../../engine/stages/file_request';
import type { FileRun } from '../../engine/stages/file_run';
import type { ExportedLevel, ExportRequest, ExportResult } from './protocol';

/** The same bytes as those of the command line from the same request. */
export async function exportAll(
  file: FileRun,
  request: FileRequest,
  { output: name, binding }: ExportRequest,
): Promise<Omit<ExportResult, 'key' | 'inputValidation'>> {
  const { settings, targets } = request;
  const asked = request.faces ?? sum(targets);
  const stopwatch = startStopwatch();
  const output = new FileOutput(file, request);
  const results = output.results();
  const bytes = await output.glb();
  const validation = await validateGlb(bytes);
  const exportTime = stopwatch();
  const { levels, reports } = await exportLevels(output, name);
  const levelsTime = stopwatch();
  const report = output.report({ ...settingsAsUsed(settings), faces: asked }, reports);
  report.timings = {
    ...report.timings,
    export: exportTime,
    ...(levels.length > 0 ? { levels: levelsTime } : {}),
  };
  const faces = sum(results.map(({ mesh }) => faceCount(mesh)));
  const text = binding ? output.binding() : null;
  const tuned = settings.solver === 'none' ? null : output.settings();
  const shown = { bytes, validation, report, faces, targetFaces: asked };
  return { ...shown, levels, binding: text, settings: tuned };
}

/** `name`: of the file of the first level. */
async function exportLevels(
  output: FileOutput,
  name: string,
): Promise<{ levels: ExportedLevel[]; reports: LevelReport[] }> {
  const levels: ExportedLevel[] = [];
  const reports: LevelReport[] = [];
  for (let i = 0; i < output.levelCount; ++i) {
    const { bytes, faces, report } = await output.level(i);
    const own = name.replace(/\.glb$/, `_lod${i + 1}$&`);
    levels.push({ name: own, faces, bytes, validation: await validateGlb(bytes) });
    reports.push({ file: own, ...report });
  }
  return { levels, reports };
}
