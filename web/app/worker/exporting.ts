/** The file of all bodies, checked: the engine writes it, its further levels, the binding, the settings and the report. */

import { startStopwatch } from '../../engine/core/stopwatch';
import { faceCount, sum } from '../../engine/core/mesh';
import { exportGlb, isSmoothed } from '../../engine/document/export';
import { validateFiles } from '../../engine/document/validate';
import { droppedByExport } from '../../engine/document/dropped';
import { lostIn } from '../../engine/document/write/lost';
import { levelNames, outputForm } from '../../engine/document/write/output_form';
import { settingsOfMethod } from '../../engine/report/report';
import { worstSurface } from '../../engine/report/result_report';
import type { LevelReport } from '../../engine/report/result_report';
import { defaultSettings } from '../../engine/settings/options';
import { GENERIC_SOLVERS, profileOf } from '../../engine/solvers/profiles';
import type { GenericSolver } from '../../engine/solvers/profiles';
import { FileOutput } from '../../engine/stages/file_output';
import type { FileRequest } from '../../engine/stages/file_request';
import type { FileRun } from '../../engine/stages/file_run';
import { STAGES } from '../../engine/stages/stages';
import { exportedMesh } from '../../engine/stages/written';
import type { DrawnLevel, ExportedLevel, ExportRequest, ExportResult } from './protocol';

/** The same bytes as from the command line with the same request. */
export async function exportAll(
  file: FileRun,
  request: FileRequest,
  { output: name, binding }: ExportRequest,
): Promise<Omit<ExportResult, 'key' | 'inputValidation'>> {
  const { settings, targets } = request;
  const asked = request.faces ?? sum(targets);
  const stopwatch = startStopwatch();
  const output = new FileOutput(file, { ...request, binding });
  output.compute();
  const files = await output.files(name);
  const { bytes } = files[0];
  const validation = await validateFiles(files);
  const exportTime = stopwatch();
  const { levels, reports } = await exportLevels(output, levelNames(name, settings));
  const levelsTime = stopwatch();
  const report = output.report({ ...settingsOfMethod(settings), faces: asked }, reports);
  report.timings = {
    ...report.timings,
    export: exportTime,
    ...(levels.length > 0 ? { levels: levelsTime } : {}),
  };
  const { after: faces } = output.writtenFaces();
  const text = binding ? output.binding() : null;
  const tuned = settings.solver === 'none' ? null : output.settings();
  const shown = { bytes, files, validation, report, faces, targetFaces: asked };
  return { ...shown, levels, binding: text, settings: tuned, lost: lostOf(file, request, name) };
}

/**
 * The file, with vertices in its own order, and a settings file for each generic solver, all for the same mesh.
 * `request`: without a solver.
 */
export async function exportForGeneric(
  file: FileRun,
  request: FileRequest,
  { output: name }: ExportRequest,
): Promise<Record<string, Uint8Array>> {
  const plain = new FileOutput(file, { ...request, binding: true });
  plain.compute();
  const [{ bytes }] = await plain.files(name);
  const targets = [...request.targets];
  plain.results().forEach(({ mesh }, n) => (targets[file.usable[n].i] = faceCount(mesh)));
  // A target for the frequencies in a solver would give each solver a different mesh. Further levels are not in the
  // archive.
  const settings = { ...request.settings, maxFrequencyError: 0, lods: [] };
  const stem = name.replace(/(\.(glb|gltf|obj|ply))?(\.zip)?$/, '');
  const files: Record<string, Uint8Array> = { [name]: bytes };
  for (const solver of GENERIC_SOLVERS) {
    const output = new FileOutput(file, { ...request, targets, settings: { ...settings, solver } });
    files[`${stem}.${familyName(solver)}.settings.json`] = new TextEncoder().encode(output.settings());
  }
  return files;
}

/** The name on the page as part of a file name: "edges-and-hinges". */
const familyName = (solver: GenericSolver): string =>
  profileOf(solver).label.toLowerCase().replaceAll(' ', '-');

/** What the file `name` omits. */
function lostOf({ model }: FileRun, { settings }: FileRequest, name: string): string[] {
  const { format } = outputForm(name, settings.format, model.format);
  if (format === 'glb' || format === 'gltf') return droppedByExport(model);
  return [...lostIn(format, model), ...model.unread];
}

/**
 * The open file as a GLB for display: if its format does not prescribe a shading, bodies without normals get those that
 * their results will have, so that both are equally smooth.
 */
export function drawOriginal({ model, runs }: FileRun): Promise<Uint8Array> {
  const drawn = runs.map((run) => {
    const prepared = isSmoothed(model) && run ? run.get(STAGES.prepared, defaultSettings()) : null;
    // Duplicate faces are drawn as in the file.
    return prepared?.layers.isPlain ? exportedMesh(prepared) : null;
  });
  return exportGlb(model, drawn, { fields: false });
}

/** Every level of detail as a GLB. `request`: for files of their own, not compressed, see drawnSettings. */
export async function drawLevels(file: FileRun, request: FileRequest): Promise<DrawnLevel[]> {
  const output = new FileOutput(file, request);
  output.compute();
  const bytes = await output.glb();
  const { hausdorff } = worstSurface(output.values(STAGES.measured).map(({ distance }) => distance));
  const { after: faces } = output.writtenFaces();
  const levels: DrawnLevel[] = [{ bytes, faces, deviation: hausdorff }];
  for (let i = 0; i < output.levelCount; ++i) {
    const { files, faces: own, report } = await output.level(i, 'level.glb');
    levels.push({ bytes: files[0].bytes, faces: own, deviation: report.surface.hausdorff });
  }
  return levels;
}

/** `names`: the names of the levels. */
async function exportLevels(
  output: FileOutput,
  names: string[],
): Promise<{ levels: ExportedLevel[]; reports: LevelReport[] }> {
  const levels: ExportedLevel[] = [];
  const reports: LevelReport[] = [];
  for (const [i, name] of names.entries()) {
    const { files, faces, report } = await output.level(i, name);
    if (files.length > 0) {
      const validation = await validateFiles(files);
      levels.push({ name, faces, bytes: files[0].bytes, files, validation });
    }
    reports.push({ file: name, ...report });
  }
  return { levels, reports };
}
