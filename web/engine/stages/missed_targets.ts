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

/** Limits that are targets only if the user set them; those of a default or a preset are guards. */
export const LIMITS = ['maxDeviation', 'minAngle', 'maxFrequencyError'] as const satisfies SettingName[];

/** Settings that are targets only if the user named them. */
export const NAMED_TARGETS = [...LIMITS, 'lods'] as const satisfies SettingName[];

/** The targets of a request. */
export interface RequestedTargets extends FaceTarget {
  settings: Settings;
  /** those of NAMED_TARGETS that the user named */
  named: ReadonlySet<SettingName>;
}

/** The reader's names for what a sentence refers to. */
export interface TargetWords {
  levels: StoppedLevel[];
  nameOf: (setting: SettingName) => string;
}

/** A further level and why its bodies stopped. */
export interface StoppedLevel {
  /** its file, and where it is in it if the file has several */
  file: string;
  bodies: StoppedBody[];
}

/** A sentence for each missed target, without a full stop. */
export interface MissedTargets {
  /** those that the user gave as a number or limit */
  requested: string[];
  /** those of a default, which are no errors */
  byDefault: string[];
}

/** The requested faces; half of them without any other target. */
export function faceTarget({ faces, ratio, settings, named }: RequestedTargets): FaceTarget {
  const isAlone = faces === null && !LIMITS.some((name) => named.has(name) && settings[name] > 0);
  return { faces, ratio: ratio ?? (isAlone ? DEFAULT_RATIO : null) };
}

/** Whether the user gave the largest deviation: by default it is a guard, and stopping at it misses no target. */
const isDeviationTarget = ({ named, settings }: Pick<RequestedTargets, 'named' | 'settings'>): boolean =>
  named.has('maxDeviation') && settings.maxDeviation > 0;

export function missedTargets(
  targets: RequestedTargets,
  output: FileOutput,
  { levels, nameOf }: TargetWords,
): MissedTargets {
  const { settings, named } = targets;
  const describe = (bodies: StoppedBody[], where = '') =>
    describeMiss(bodies, output.prepared(), { where, settings, nameOf });
  const guardOf = (bodies: StoppedBody[], where = '') =>
    isDeviationTarget(targets) ? '' : describeGuard(bodies, nameOf, where);
  const [ofFile, guard] = [describe(output.stopped()), guardOf(output.stopped())];
  const isRequested = targets.faces !== null || targets.ratio !== null;
  const { faces, ratio } = faceTarget(targets);
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
    requested: [
      ...(isRequested ? [ofFile] : []),
      ...(named.has('lods') ? ofLevels : []),
      ...brokenLimits(settings, named, found),
      ...(isRequested ? [guard] : []),
    ].filter(isPresent),
    byDefault: [
      ...(isRequested ? [] : [...(hasCount ? [ofFile] : []), guard]),
      ...(named.has('lods') ? [] : ofLevels),
      ...describeFinerLevels(
        writtenFacesOf(output.stopped()),
        levels.map(({ file, bodies }) => ({ file, faces: writtenFacesOf(bodies) })),
        nameOf('lods'),
      ),
    ].filter(isPresent),
  };
}

/** A sentence on bodies that the deviation limit stopped above their targets; '' without any. */
function describeGuard(bodies: StoppedBody[], nameOf: TargetWords['nameOf'], where: string): string {
  const guarded = bodies.flatMap((stopped) => (stopped.guard ? [{ stopped, ...stopped.guard }] : []));
  if (guarded.length === 0) return '';
  const [{ stopped, deviation, limit }] = [...guarded].sort((a, b) => b.deviation - a.deviation);
  const { name = '' } = stopped;
  const others =
    guarded.length > 1
      ? `, and ${counted(guarded.length - 1, 'other body', 'other bodies')} stopped at that limit, too`
      : '';
  return `${where}${name} stopped at ${describeFaces([stopped])}, ${besideLimit(deviation, limit)} % of its diagonal from the original${others}: the next collapses would exceed ${limit} %; ${nameOf('maxDeviation')} 0 lifts this limit`;
}

/** The written faces, and those that count for targets if they are fewer. */
function describeFaces(bodies: StoppedBody[]): string {
  const faces = sum(bodies.map((body) => body.faces));
  const duplicates = sum(bodies.map((body) => body.duplicates ?? 0));
  const all = counted(writtenFacesOf(bodies), 'face');
  return duplicates > 0 ? `${all} (${grouped(faces)} without duplicates)` : all;
}

/** Values within this factor of a limit count as keeping it, because of rounding. */
const ROUNDING = 1.0001;

/** A sentence for each limit that the user gave and the result violates. */
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
          `The surface deviates by ${besideLimit(found.deviation, maxDeviation)} %, more than the limit of ${maxDeviation} %`,
        ]
      : []),
    ...(isBroken('maxFrequencyError', maxFrequencyError, found.frequencyError)
      ? [
          `Frequencies are off by ${besideLimit(found.frequencyError, maxFrequencyError)} %, more than the limit of ${maxFrequencyError} %`,
        ]
      : []),
  ];
}

/**
 * A sentence on bodies that stopped above their targets because no more edge can collapse, with a cure if seams are the
 * reason; '' without any. `bodies[i]` comes from `originals[i]`. `where`: the beginning of the sentence.
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
  const cure = isBlocked ? `; ${nameOf('seams')} cross lets collapses cross seams` : '';
  return `${where}Stopped at ${describeFaces(missed)}${which}, not ${grouped(target)}: ${reasons}${cure}`;
}

const isExhausted = (body: StoppedBody): boolean => stopReport([body]).reason === 'exhausted';
