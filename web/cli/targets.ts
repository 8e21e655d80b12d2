/** Which targets of limber optimize are missed, and why. */

import type { PreparedBody } from '../engine/body/prepared_body';
import { sum } from '../engine/core/mesh';
import { worstSurface } from '../engine/report/result_report';
import { describeRefused, isBlockedBySeams, stopReport } from '../engine/report/stop_report';
import type { StoppedBody } from '../engine/report/stop_report';
import type { Settings } from '../engine/settings/options';
import type { FileOutput } from '../engine/stages/file_output';
import { STAGES } from '../engine/stages/stages';
import type { Arguments } from './arguments';
import type { WrittenLevel } from './levels';
import { count, plural } from './words';

/** A sentence for each missed target, without a full stop. */
export interface MissedTargets {
  /** asked for as a number or limit */
  asked: string[];
  /** a default, of which nothing is missed */
  unasked: string[];
}

export function missedTargets(args: Arguments, output: FileOutput, levels: WrittenLevel[]): MissedTargets {
  const { asked, settings } = args;
  const isGuarded = !asked.has('max-deviation');
  const describe = (bodies: StoppedBody[], where = '') =>
    describeMiss(bodies, output.prepared(), { where, settings, isGuarded });
  const ofFile = describe(output.stopped());
  const isAsked = args.faces !== null || args.ratio !== null;
  const found = {
    deviation: worstSurface(output.values(STAGES.measured).map(({ distance }) => distance)).hausdorff,
    frequencyError: stopReport(output.stopped()).frequency?.error ?? 0,
  };
  const isPresent = (sentence: string) => sentence !== '';
  return {
    asked: [
      ...(isAsked ? [ofFile] : []),
      ...levels.map(({ bodies, report: { file } }) => describe(bodies, `${file}: `)),
      ...brokenLimits(settings, asked, found),
    ].filter(isPresent),
    unasked: (isAsked ? [] : [ofFile]).filter(isPresent),
  };
}

/** What lies within rounding of a limit keeps it. */
const ROUNDING = 1.0001;

/** A sentence for each limit that was asked for and that the result does not keep. */
export function brokenLimits(
  { maxDeviation, maxFrequencyError }: Pick<Settings, 'maxDeviation' | 'maxFrequencyError'>,
  asked: ReadonlySet<string>,
  found: { deviation: number; frequencyError: number },
): string[] {
  const isBroken = (flag: string, limit: number, value: number) =>
    asked.has(flag) && limit > 0 && value > ROUNDING * limit;
  return [
    ...(isBroken('max-deviation', maxDeviation, found.deviation)
      ? [`The surface deviates by ${found.deviation.toFixed(2)} %, not by at most ${maxDeviation} %`]
      : []),
    ...(isBroken('max-frequency-error', maxFrequencyError, found.frequencyError)
      ? [`Frequencies are off by ${found.frequencyError.toFixed(2)} %, not by at most ${maxFrequencyError} %`]
      : []),
  ];
}

interface MissRequest {
  /** how the sentence begins */
  where: string;
  settings: Settings;
  /** whether the largest deviation is the default, at which it stops short, and no target of the user's */
  isGuarded: boolean;
}

/**
 * Why bodies have more faces than was asked for, because no more edge can collapse or the guard of the deviation stops it, and
 * how to go on; '' where none has. `bodies[i]` comes from `originals[i]`.
 */
export function describeMiss(
  bodies: StoppedBody[],
  originals: PreparedBody[],
  { where, settings, isGuarded }: MissRequest,
): string {
  const reasonOf = (body: StoppedBody) => stopReport([body]).reason;
  const isExhausted = (body: StoppedBody) => reasonOf(body) === 'exhausted';
  const missed = bodies.filter((body) => isExhausted(body) || (isGuarded && reasonOf(body) === 'deviation'));
  if (missed.length === 0) return '';
  const [after, target] = [
    sum(missed.map(({ faces }) => faces)),
    sum(missed.map((body) => body.targetFaces)),
  ];
  const which = bodies.length > 1 ? ` in ${plural(missed.length, 'body', 'bodies')} of ${bodies.length}` : '';
  const begin = `${where}Stopped at ${count(after)} faces${which}, not ${count(target)}`;
  const exhausted = missed.filter(isExhausted);
  if (exhausted.length === 0)
    return `${begin}: fewer would take the surface farther than ${settings.maxDeviation} % of the diagonal from the original; --max-deviation 0 lifts this guard`;
  const isBlocked = bodies.some(
    (body, i) => isExhausted(body) && isBlockedBySeams(originals[i], body.history.refused, settings),
  );
  const cure = isBlocked ? '; --seams cross lets them give way' : '';
  return `${begin}: ${describeRefused(stopReport(exhausted).refused)}${cure}`;
}
