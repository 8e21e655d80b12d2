/** The summary of results that limber optimize prints. */

import { describeShapeFit } from '../engine/report/fit_words';
import type { Report } from '../engine/report/report';
import { fitReport, worstSurface } from '../engine/report/result_report';
import type { LevelReport } from '../engine/report/result_report';
import { describeTuning } from '../engine/report/solver_report';
import { stopReport } from '../engine/report/stop_report';
import type { StopReport } from '../engine/report/stop_report';
import type { SolverName } from '../engine/solvers/profiles';
import type { FileOutput } from '../engine/stages/file_output';
import { STAGES } from '../engine/stages/stages';
import type { Arguments } from './arguments';
import { shownName, shownOutput } from './standard';
import { besideLimit, counted } from '../engine/core/words';
import { facesChange } from './words';

export function summaryLine({ operands }: Arguments, output: FileOutput, seconds: number): string {
  const { before, after } = output.writtenFaces();
  const measured = output.values(STAGES.measured);
  const distance = worstSurface(measured.map((one) => one.distance));
  const broken = measured.flatMap(({ certificate }) =>
    (['components', 'boundaryLoops', 'genus'] as const).filter((key) => !certificate[key]),
  );
  const topology =
    broken.length === 0 ? 'topology kept' : `TOPOLOGY CHANGED (${[...new Set(broken)].join(', ')})`;
  const smallest = Math.min(...measured.map(({ quality }) => quality.minAngle));
  return [
    `${shownName(operands[0])}: ${facesChange(before, after)}`,
    topology,
    `deviation ${distance.hausdorff.toFixed(2)} % (mean ${distance.mean.toFixed(2)} %)`,
    `smallest angle ${smallest.toFixed(1)} deg`,
    ...fitWords(output),
    ...frequencyWords(stopReport(output.stopped())),
    `${seconds.toFixed(1)} s -> ${shownOutput(operands[1])}`,
  ].join(', ');
}

/** What results were fitted to; of a modal fit the frequency errors of the part where they are largest. */
function fitWords(output: FileOutput): string[] {
  const { fit } = fitReport(output.values(STAGES.fitted));
  if (!fit) return [];
  const why = fit.unfitted ? [`not fitted: ${fit.unfitted.join('; ')}`] : [];
  const { before = 0, after = 0, flips } = fit;
  if (flips !== undefined) return [describeShapeFit({ flips }), ...why];
  const off = `frequencies off ${after.toFixed(2)} % (${before.toFixed(2)} % before the fit)`;
  return before > 0 ? [off, ...why] : why;
}

/** How far the frequencies are off where they are a target, and how far they would be with fewer faces. */
function frequencyWords({ frequency }: StopReport): string[] {
  if (!frequency) return [];
  const { error, limit, beyond } = frequency;
  const less = beyond ? ` (${counted(beyond.faces, 'face')}: ${besideLimit(beyond.error, limit)} %)` : '';
  return [`frequencies within ${besideLimit(error, limit)} % of ${limit} %${less}`];
}

/** How closely the results follow their originals in the solver that they are tuned for; none without one. */
export const tuningLines = ({ fidelity }: Report): string[] =>
  Object.entries(fidelity?.solvers ?? {}).flatMap(([solver, report]) =>
    describeTuning(solver as SolverName, report),
  );

/** `label`: what the level is called. */
export function levelLine(label: string, { output, surface }: LevelReport): string {
  const { hausdorff, mean } = surface;
  const deviation = `deviation ${hausdorff.toFixed(2)} % (mean ${mean.toFixed(2)} %)`;
  return `${label}: ${counted(output.faces, 'face')}, ${deviation}`;
}
