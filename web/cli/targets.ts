/** Which targets of limber optimize are missed, and why. */

import type { PreparedBody } from '../engine/body/prepared_body';
import { sum } from '../engine/core/mesh';
import { worstSurface } from '../engine/report/result_report';
import { describeRefused, isBlockedBySeams, stopReport } from '../engine/report/stop_report';
import type { StoppedBody } from '../engine/report/stop_report';
import type { Settings } from '../engine/settings/options';
import type { FaceTarget } from '../engine/stages/budget/face_shares';
import type { FileOutput } from '../engine/stages/file_output';
import { STAGES } from '../engine/stages/stages';
import type { Arguments } from './arguments';
import type { WrittenLevel } from './levels';
import { count, plural } from './words';

const DEFAULT_RATIO = 0.5;

/** A sentence for each missed target, without a full stop. */
export interface MissedTargets {
  /** asked for as a number or limit */
  asked: string[];
  /** a default, of which nothing is missed */
  unasked: string[];
}

/** What is asked for; half the faces where nothing else is a target. */
export function targetOf({ faces, ratio, asked, settings }: Arguments): FaceTarget {
  const { minAngle, maxFrequencyError } = settings;
  const isAlone =
    faces === null && !asksForDeviation({ asked, settings }) && minAngle === 0 && maxFrequencyError === 0;
  return { faces, ratio: ratio ?? (isAlone ? DEFAULT_RATIO : null) };
}

/** Whether the largest deviation was asked for: by default it is a guard, and stopping at it misses no target. */
const asksForDeviation = ({ asked, settings }: Pick<Arguments, 'asked' | 'settings'>): boolean =>
  asked.has('max-deviation') && settings.maxDeviation > 0;

export function missedTargets(args: Arguments, output: FileOutput, levels: WrittenLevel[]): MissedTargets {
  const { asked, settings } = args;
  const describe = (bodies: StoppedBody[], where = '') =>
    describeMiss(bodies, output.prepared(), { where, settings });
  const describeLevel = (bodies: StoppedBody[], where: string) => [
    describe(bodies, where),
    ...(asksForDeviation(args) ? [] : [describeGuard(bodies, where)]),
  ];
  const ofFile = describe(output.stopped());
  const isAsked = args.faces !== null || args.ratio !== null;
  const { faces, ratio } = targetOf(args);
  const hasCount = faces !== null || ratio !== null;
  const guard = asksForDeviation(args) ? '' : describeGuard(output.stopped());
  const found = {
    deviation: worstSurface(output.values(STAGES.measured).map(({ distance }) => distance)).hausdorff,
    frequencyError: stopReport(output.stopped()).frequency?.error ?? 0,
  };
  const isPresent = (sentence: string) => sentence !== '';
  return {
    asked: [
      ...(isAsked ? [ofFile] : []),
      ...levels.flatMap(({ bodies, report: { file } }) => describeLevel(bodies, `${file}: `)),
      ...brokenLimits(settings, asked, found),
      ...(isAsked ? [guard] : []),
    ].filter(isPresent),
    unasked: (isAsked ? [] : [...(hasCount ? [ofFile] : []), guard]).filter(isPresent),
  };
}

/** Why bodies have more faces than was asked for, because the surface would go too far; '' where none has. */
export function describeGuard(bodies: StoppedBody[], where = ''): string {
  const { guarded = [] } = stopReport(bodies);
  if (guarded.length === 0) return '';
  const [{ body, faces, deviation, limit }] = [...guarded].sort((a, b) => b.deviation - a.deviation);
  const others = guarded.length > 1 ? ` and ${plural(guarded.length - 1, 'other body', 'other bodies')}` : '';
  return `${where}${body}${others} stopped at ${count(faces)} faces, ${deviation.toFixed(2)} % of its diagonal from the original: fewer would go beyond ${limit} %; --max-deviation 0 lifts this`;
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

/**
 * Why bodies have more faces than was asked for, because no more edge can collapse, and how to go on where seams are the
 * reason; '' where none has. `bodies[i]` comes from `originals[i]`. `where`: how the sentence begins.
 */
export function describeMiss(
  bodies: StoppedBody[],
  originals: PreparedBody[],
  { where, settings }: { where: string; settings: Settings },
): string {
  const missed = bodies.filter(isExhausted);
  if (missed.length === 0) return '';
  const [after, target] = [
    sum(missed.map(({ faces }) => faces)),
    sum(missed.map((body) => body.targetFaces)),
  ];
  const which = bodies.length > 1 ? ` in ${plural(missed.length, 'body', 'bodies')} of ${bodies.length}` : '';
  const reasons = describeRefused(stopReport(missed).refused);
  const isBlocked = bodies.some(
    (body, i) => isExhausted(body) && isBlockedBySeams(originals[i], body.history.refused, settings),
  );
  const cure = isBlocked ? '; --seams cross lets them give way' : '';
  return `${where}Stopped at ${count(after)} faces${which}, not ${count(target)}: ${reasons}${cure}`;
}

const isExhausted = (body: StoppedBody): boolean => stopReport([body]).reason === 'exhausted';
