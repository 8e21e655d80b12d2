/** Optimizes a model. */

import { describeResiduals } from '../../engine/body/health';
import { describeAddedErrors, loadValidator } from '../../engine/document/validate';
import { settingsOfMethod } from '../../engine/report/report';
import type { OpenModel } from '../../engine/document/open';
import type { Report } from '../../engine/report/report';
import { SettingError } from '../../engine/settings/options';
import type { Settings } from '../../engine/settings/options';
import { listLost } from '../../engine/document/write/lost';
import { levelLabels, levelNames, resultName } from '../../engine/document/write/output_form';
import { FileOutput } from '../../engine/stages/file_output';
import { runSettings } from '../../engine/stages/file_request';
import type { FileRequest } from '../../engine/stages/file_request';
import { requestFile } from '../../engine/stages/budget/file_targets';
import type { FileRun } from '../../engine/stages/file_run';
import { resultWarnings, sizeWarnings } from '../../engine/stages/file_warnings';
import { faceTarget, missedTargets, NAMED_TARGETS } from '../../engine/stages/missed_targets';
import type { RequestedTargets, StoppedLevel } from '../../engine/stages/missed_targets';
import { STAGES } from '../../engine/stages/stages';
import { checkWritten } from '../../engine/stages/written_form';
import type { Level } from '../options';
import type { ModelFiles, OptimizeReply, OptimizeRequest } from '../protocol';
import { resultFiles } from './result_bytes';
import { nameOf } from './session';
import type { WorkSession } from './session';

/** Throws SettingError for options of files that do not apply to a document. Its further levels are files. */
function checkDocument({ lods, lodStyle, format, compress }: Settings): void {
  const other = 'leave it out, or give the bytes of a model.';
  if (lods.length > 0) {
    if (lodStyle !== 'files')
      throw new SettingError('lodStyle', `is "${lodStyle}", but levels of a document are files: ${other}`);
    return;
  }
  if (format !== 'auto')
    throw new SettingError('format', `is "${format}", but a document is no file: ${other}`);
  if (compress !== 'like-input' && compress !== 'none')
    throw new SettingError('compress', `is "${compress}", but a document is not compressed: ${other}`);
}

export async function optimizeModel(
  session: WorkSession,
  [source]: ModelFiles[],
  options: OptimizeRequest,
): Promise<OptimizeReply> {
  const { settings, notes } = session;
  if (options.wantsBodies) checkDocument(settings);
  const { fields = false, bind: binding = false, validate = true } = options;
  if (validate) loadValidator();
  const model = await session.open(source);
  const load = session.lap();
  // A document has no name.
  const name = resultName(options.wantsBodies ? '' : nameOfModel(source, model), settings.format);
  const { lost } = checkWritten(model, session.chosen(model), { name, settings });
  const file = session.prepare(model, { guides: true });
  if (settings.solver !== 'none') session.warn(sizeWarnings(file, settings, nameOf));
  const weld = session.lap();
  const targets = requestedTargets(session, options);
  const target = faceTarget(targets);
  const request = requestFile(file, { settings, fields, binding, isOnly: true, ...target });
  const output = new FileOutput(file, request);
  output.compute((run, own) => session.warn(resultWarnings(run, own)));
  session.lap();
  const files = options.wantsBodies ? [] : resultFiles(await output.files(name));
  const bodies = options.wantsBodies ? writtenBodies(file, request) : [];
  const bindingFile = binding ? output.binding() : null;
  const settingsFile = settings.solver === 'none' ? null : output.settings();
  if (lost.length > 0) notes.push(`the result leaves out ${listLost(lost)}`);
  const exportTime = session.lap();
  const { levels, bodies: ofLevels } = await furtherLevels(output, levelNames(name, settings));
  const stopped = levelLabels(name, settings).map((file, i) => ({ file, bodies: ofLevels[i] }));
  if (validate) notes.push(...(await addedErrors({ files, levels }, source)));
  const levelsTime = session.lap();
  const report = output.report(
    optionsAsUsed(session, options, target),
    levels.map((level) => level.report),
  );
  const missed = missedTargets(targets, output, { levels: stopped, nameOf });
  notes.push(...describeResiduals(report.modes ?? []), ...missed.requested, ...missed.byDefault);
  report.timings = {
    ...{ load, weld, ...report.timings, export: exportTime },
    ...(levels.length > 0 ? { levels: levelsTime } : {}),
    total: session.total(),
  };
  return {
    ...{ files, bodies, settingsFile, levels, notes },
    binding: bindingFile,
    report: finished(session, report),
  };
}

/** The name that the caller knows the model by: that of the only file, which may be an archive, or of the main one. */
const nameOfModel = (source: ModelFiles, { name }: OpenModel): string =>
  source.length === 1 ? source[0].name : name;

/** Notes on validator errors in the files of a result that its source does not have. */
async function addedErrors(
  { files, levels }: Pick<OptimizeReply, 'files' | 'levels'>,
  source: ModelFiles,
): Promise<string[]> {
  const made = [
    { name: 'the result', all: files },
    ...levels.map(({ report, files: all }) => ({ name: report.file, all })),
  ];
  const notes: string[] = [];
  for (const { name, all } of made) {
    const errors = await describeAddedErrors(all, source);
    if (errors !== null)
      notes.push(`the glTF validator finds errors in ${name} that the model does not have: ${errors}`);
  }
  return notes;
}

/** The report with the memory at the end. */
export const finished = <OfCall extends Report>({ core }: WorkSession, report: OfCall): OfCall => ({
  ...report,
  peakHeapBytes: core.peakHeapBytes(),
});

const requestedTargets = (
  { settings }: WorkSession,
  { faces, ratio, ...given }: OptimizeRequest,
): RequestedTargets => ({
  ...{ settings, faces: faces ?? null, ratio: ratio ?? null },
  named: new Set(NAMED_TARGETS.filter((name) => given[name] !== undefined)),
});

const writtenBodies = (file: FileRun, request: FileRequest): OptimizeReply['bodies'] =>
  file.runs.map((run, i) => run && run.get(STAGES.written, runSettings(request, i)));

/** Writes the levels under these names. */
async function furtherLevels(
  output: FileOutput,
  names: string[],
): Promise<{ levels: Level[]; bodies: StoppedLevel['bodies'][] }> {
  const [levels, stopped]: [Level[], StoppedLevel['bodies'][]] = [[], []];
  for (const [i, file] of names.entries()) {
    const { files: written, bodies, report } = await output.level(i, file);
    const files = resultFiles(written);
    levels.push({ glb: files[0]?.bytes ?? null, files, report: { file, ...report } });
    stopped.push(bodies);
  }
  return { levels, bodies: stopped };
}

function optionsAsUsed(
  { settings }: WorkSession,
  { fields = false }: OptimizeRequest,
  { faces, ratio }: Pick<RequestedTargets, 'faces' | 'ratio'>,
): object {
  const target = { ...(faces !== null ? { faces } : {}), ...(ratio !== null ? { ratio } : {}) };
  return { ...settingsOfMethod(settings), ...target, fields };
}
