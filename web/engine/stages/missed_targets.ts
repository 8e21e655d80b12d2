/** Which targets of a file are missed, and why. */

import type { PreparedBody } from '../body/prepared_body';
import { sum } from '../core/mesh';
import { besideLimit, counted, grouped } from '../core/words';
import { describeFinerLevels } from '../report/level_words';
import { worstSurface } from '../report/result_report';
import { describeRefused, isBlockedBySeams, stopReport, writtenFacesOf } from '../report/stop_report';
import type { StoppedBody } from '../report/stop_report';
import type { SettingName, Settings } from '../settings/options';
import type { FaceTarget } from './budget/face_shares';
import type { FileOutput } from './file_output';
import { STAGES } from './stages';

const DEFAULT_RATIO = 0.5;

/** Limits of which nothing is missed where a default or a preset sets them: they are guards then. */
export const LIMITS = ['maxDeviation', 'minAngle', 'maxFrequencyError'] as const satisfies SettingName[];

/** What is a target only where it was asked for by name. */
export const NAMED_TARGETS = [...LIMITS, 'lods'] as const satisfies SettingName[];

/** What was asked for. */
export interface AskedTargets extends FaceTarget {
  settings: Settings;
  /** those of NAMED_TARGETS that were asked for by name */
  named: ReadonlySet<SettingName>;
}

/** How the reader knows what a sentence names. */
export interface TargetWords {
  levels: StoppedLevel[];
  nameOf: (setting: SettingName) => string;
}

/** A further level with what stopped its bodies. */
export interface StoppedLevel {
  file: string;
  bodies: StoppedBody[];
}

/** A sentence for each missed target, without a full stop. */
export interface MissedTargets {
  /** asked for as a number or limit */
  asked: string[];
  /** a default, of which nothing is missed */
  unasked: string[];
}

/** The faces that are asked for; half of them where nothing else is a target. */
export function faceTarget({ faces, ratio, settings, named }: AskedTargets): FaceTarget {
  const isAlone = faces === null && !LIMITS.some((name) => named.has(name) && settings[name] > 0);
  return { faces, ratio: ratio ?? (isAlone ? DEFAULT_RATIO : null) };
}

/** Whether the largest deviation was asked for: by default it is a guard, and stopping at it misses no target. */
const asksForDeviation = ({ named, settings }: Pick<AskedTargets, 'named' | 'settings'>): boolean =>
  named.has('maxDeviation') && settings.maxDeviation > 0;

export function missedTargets(
  asked: AskedTargets,
  output: FileOutput,
  { levels, nameOf }: TargetWords,
): MissedTargets {
  const { settings, named } = asked;
  const describe = (bodies: StoppedBody[], where = '') =>
    describeMiss(bodies, output.prepared(), { where, settings, nameOf });
  const guardOf = (bodies: StoppedBody[], where = '') =>
    asksForDeviation(asked) ? '' : describeGuard(bodies, nameOf, where);
  const [ofFile, guard] = [describe(output.stopped()), guardOf(output.stopped())];
  const isAsked = asked.faces !== null || asked.ratio !== null;
  const { faces, ratio } = faceTarget(asked);
  const hasCount = faces !== null || ratio !== null;
  const found = {
    deviation: worstSurface(output.values(STAGES.measured).map(({ distance }) => distance)).hausdorff,
    frequencyError: stopReport(output.stopped()).frequency?.error ?? 0,
  };
  const ofLevels = levels.flatMap(({ bodies, file }) => [
    describe(bodies, `${file}: `),
    guardOf(bodies, `${file}: `),
  ]);
  const isPresent = (sentence: string) => sentence !== '';
  return {
    asked: [
      ...(isAsked ? [ofFile] : []),
      ...(named.has('lods') ? ofLevels : []),
      ...brokenLimits(settings, named, found),
      ...(isAsked ? [guard] : []),
    ].filter(isPresent),
    unasked: [
      ...(isAsked ? [] : [...(hasCount ? [ofFile] : []), guard]),
      ...(named.has('lods') ? [] : ofLevels),
      ...describeFinerLevels(
        writtenFacesOf(output.stopped()),
        levels.map(({ file, bodies }) => ({ file, faces: writtenFacesOf(bodies) })),
        nameOf('lods'),
      ),
    ].filter(isPresent),
  };
}

/** Why bodies have more faces than was asked for, because the surface would go too far; '' where none has. */
function describeGuard(bodies: StoppedBody[], nameOf: TargetWords['nameOf'], where: string): string {
  const guarded = bodies.flatMap((stopped) => (stopped.guard ? [{ stopped, ...stopped.guard }] : []));
  if (guarded.length === 0) return '';
  const [{ stopped, deviation, limit }] = [...guarded].sort((a, b) => b.deviation - a.deviation);
  const { name = '' } = stopped;
  const others =
    guarded.length > 1 ? ` and ${counted(guarded.length - 1, 'other body', 'other bodies')}` : '';
  return `${where}${name}${others} stopped at ${describeFaces([stopped])}, ${besideLimit(deviation, limit)} % of its diagonal from the original: the next collapses would go beyond ${limit} %; ${nameOf('maxDeviation')} 0 lifts this`;
}

/** The faces as they are in the file, and how many count for targets where these are fewer. */
function describeFaces(bodies: StoppedBody[]): string {
  const faces = sum(bodies.map((body) => body.faces));
  const duplicates = sum(bodies.map((body) => body.duplicates ?? 0));
  const all = `${grouped(writtenFacesOf(bodies))} faces`;
  return duplicates > 0 ? `${all} (${grouped(faces)} without duplicates)` : all;
}

/** What lies within rounding of a limit keeps it. */
const ROUNDING = 1.0001;

/** A sentence for each limit that was asked for and that the result does not keep. */
export function brokenLimits(
  { maxDeviation, maxFrequencyError }: Pick<Settings, 'maxDeviation' | 'maxFrequencyError'>,
  named: ReadonlySet<SettingName>,
  found: { deviation: number; frequencyError: number },
): string[] {
  const isBroken = (name: SettingName, limit: number, value: number) =>
    named.has(name) && limit > 0 && value > ROUNDING * limit;
  return [
    ...(isBroken('maxDeviation', maxDeviation, found.deviation)
      ? [
          `The surface deviates by ${besideLimit(found.deviation, maxDeviation)} %, not by at most ${maxDeviation} %`,
        ]
      : []),
    ...(isBroken('maxFrequencyError', maxFrequencyError, found.frequencyError)
      ? [
          `Frequencies are off by ${besideLimit(found.frequencyError, maxFrequencyError)} %, not by at most ${maxFrequencyError} %`,
        ]
      : []),
  ];
}

/**
 * Why bodies have more faces than was asked for, because no more edge can collapse, and how to go on where seams are the
 * reason; '' where none has. `bodies[i]` comes from `originals[i]`. `where`: how the sentence begins.
 */
function describeMiss(
  bodies: StoppedBody[],
  originals: PreparedBody[],
  { where, settings, nameOf }: { where: string; settings: Settings; nameOf: TargetWords['nameOf'] },
): string {
  const missed = bodies.filter(isExhausted);
  if (missed.length === 0) return '';
  const target = sum(missed.map((body) => body.targetFaces));
  const which =
    bodies.length > 1 ? ` in ${counted(missed.length, 'body', 'bodies')} of ${bodies.length}` : '';
  const reasons = describeRefused(stopReport(missed).refused);
  const isBlocked = bodies.some(
    (body, i) => isExhausted(body) && isBlockedBySeams(originals[i], body.history.refused, settings),
  );
  const cure = isBlocked ? `; ${nameOf('seams')} cross lets them give way` : '';
  return `${where}Stopped at ${describeFaces(missed)}${which}, not ${grouped(target)}: ${reasons}${cure}`;
}

const isExhausted = (body: StoppedBody): boolean => stopReport([body]).reason === 'exhausted';
