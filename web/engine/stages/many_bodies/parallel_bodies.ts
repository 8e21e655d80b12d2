/** Runs the small bodies of a file in parallel: each is too small to keep all threads busy by itself. */

import type { PreparedBody } from '../../body/prepared_body';
import type { Core, MeshAt } from '../../core/core';
import { sum, vertexCount } from '../../core/mesh';
import { methodOf } from '../../settings/options';
import type { BodyRun } from '../body_run';
import { deviationsStage } from '../budget/deviations';
import { errorCurveStage } from '../budget/error_curve';
import { guardInParallel } from '../budget/guarded_level';
import type { LevelToGuard } from '../budget/guarded_level';
import type { FileRun } from '../file_run';
import { fittedStage } from '../fitted';
import { collapsedLevelsStage, furtherLevelsStage } from '../further_levels';
import { guidanceStage, guidingModes } from '../guidance';
import { historyStage } from '../history';
import { keptHistoryStage } from '../kept_history';
import { levelStage } from '../level';
import { measureDistances } from '../measure';
import { measuredStage } from '../measured';
import { modesStage } from '../modes';
import { preparedStage } from '../prepared';
import type { AnyStage, RunSettings, SettingsOf } from '../stage';
import { callAll, knownResult } from './core_call';
import type { CoreCall } from './core_call';
import { groupsOf } from './groups';
import type { Usable } from './groups';
import type { ValueCache } from './value_cache';

/** The stage that every body is taken to: the error curve follows from its history, the others are those of its results. */
type LastStage =
  typeof errorCurveStage | typeof fittedStage | typeof measuredStage | typeof furtherLevelsStage;

/** How the bodies of a file are run. */
export interface BodyWork {
  settingsOf: (i: number) => RunSettings;
  last: LastStage;
  /** share of the rest of the call, see FileProgress; absent: all of it */
  share?: number;
  onDone?: (usable: Usable[number]) => void;
}

/** Runs some of the bodies of a file up to a stage, in order; the first calls of the stages of small bodies are made in parallel. */
export function runBodies(file: FileRun, some: Usable, work: BodyWork): void {
  const workOf = (group: Usable): number =>
    sum(requestsOf(group, work).map((body) => workLeft(body, work.last)));
  const piece = file.progress.pass(workOf(some), work.share ?? 1);
  for (const group of groupsOf(file.core, some, work.settingsOf)) {
    file.announce(group[0].run);
    const steps = [...stepsAhead(file.core, requestsOf(group, work), work.last), finish(file, group, work)];
    const all = sum(steps.map(({ weight }) => weight));
    for (const { weight, run, isOneCall } of steps) piece((workOf(group) * weight) / all, run, isOneCall);
  }
}

/** A body and its request. */
interface BodyRequest {
  run: BodyRun;
  settings: RunSettings;
}

const requestsOf = (group: Usable, { settingsOf }: BodyWork): BodyRequest[] =>
  group.map(({ run, i }) => ({ run, settings: settingsOf(i) }));

/** Work grows with the number of vertices. */
const workLeft = ({ run, settings }: BodyRequest, last: LastStage): number =>
  run.has(last, settings) ? 0 : vertexCount(preparedOf(run, settings).mesh);

/** A part of the work on a group. */
interface Step {
  /** roughly the time that it takes, beside those of the other steps */
  weight: number;
  run: () => void;
  isOneCall?: boolean;
}

function finish(file: FileRun, group: Usable, { settingsOf, last, onDone }: BodyWork): Step {
  const run = (): void => {
    for (const usable of group) {
      file.announce(usable.run);
      usable.run.get(last, settingsOf(usable.i));
      onDone?.(usable);
    }
  };
  return { weight: 1, run };
}

/** Work ahead of the stages of bodies that are not computed yet: for several in parallel, for a single one with all threads. */
function stepsAhead(core: Core, group: BodyRequest[], last: LastStage): Step[] {
  const bodies = group.filter(({ run, settings }) => !run.has(last, settings));
  if (bodies.length === 0) return [];
  const lacks = (stage: LastStage | typeof historyStage): boolean =>
    bodies.some(({ run, settings }) => !run.has(stage, settings));
  const steps = group.length > 1 ? stepsTogether(core, bodies) : stepsAlone(bodies[0]);
  return [
    ...(lacks(historyStage) ? steps.history : []),
    ...(last === furtherLevelsStage ? steps.levels : []),
    ...(isOfResult(last) && lacks(fittedStage) ? steps.result : []),
  ];
}

const isOfResult = (last: LastStage): boolean => last === fittedStage || last === measuredStage;

/** Steps to the history, and from there to the result or to the further levels. */
interface Steps {
  history: Step[];
  result: Step[];
  levels: Step[];
}

function stepsAlone({ run, settings }: BodyRequest): Steps {
  return {
    history: [
      { weight: 10, run: () => run.get(guidingModes, settings) },
      { weight: 2, run: () => run.get(historyStage, settings) },
    ],
    result: [{ weight: 8, run: () => run.get(fittedStage, settings) }],
    levels: [{ weight: 8, run: () => run.get(furtherLevelsStage, settings) }],
  };
}

function stepsTogether(core: Core, bodies: BodyRequest[]): Steps {
  const [{ settings }] = bodies;
  const first = (weight: number, stage: AnyStage): Step => ({
    weight,
    run: () => callFirst(core, bodies, stage),
    isOneCall: true,
  });
  const guidance = [first(9, modesStage), first(1, guidanceStage)];
  return {
    history: [...(methodOf(settings).needsGuidance ? guidance : []), first(2, historyStage)],
    result: [
      guardTogether(core, bodies, ({ run, settings }) => [run.get(levelStage, settings)]),
      ...fitTogether(core, bodies, fittedStage),
    ],
    levels: [
      guardTogether(core, bodies, ({ run, settings }) =>
        run.get(collapsedLevelsStage, settings).map(({ level }) => level),
      ),
      ...fitTogether(core, bodies, furtherLevelsStage),
    ],
  };
}

function guardTogether(core: Core, bodies: BodyRequest[], levelsOf: (body: BodyRequest) => MeshAt[]): Step {
  const run = (): void => {
    const levels = bodies.flatMap((body) => levelsOf(body).map((level) => levelToGuard(body, level)));
    guardInParallel(core, levels);
  };
  return { weight: 4, run };
}

function fitTogether(core: Core, bodies: BodyRequest[], stage: AnyStage): Step[] {
  let fits: FirstCall[] = [];
  return [
    { weight: 3, run: () => (fits = callFirst(core, bodies, stage)), isOneCall: true },
    { weight: 1, run: () => aheadOf(stage, fits, () => measureFits(core, fits)) },
  ];
}

/** A body and a call with which a stage of it begins. */
interface FirstCall extends BodyRequest {
  call: CoreCall;
}

/** Makes and returns the first calls of a stage. */
function callFirst(core: Core, bodies: BodyRequest[], stage: AnyStage): FirstCall[] {
  const firsts = bodies.flatMap(({ run, settings }): FirstCall[] =>
    run.firstCalls(stage, settings).map((call) => ({ run, settings, call })),
  );
  const calls = firsts.map(({ call }) => call);
  aheadOf(stage, firsts, () => callAll(core, cacheOf(bodies), calls));
  return firsts;
}

/** Counts the time that `work` takes as that of the stage. */
function aheadOf(stage: AnyStage, firsts: FirstCall[], work: () => void): void {
  const start = performance.now();
  work();
  const seconds = (performance.now() - start) / 1000;
  for (const { run } of firsts) run.addSeconds(stage, seconds / firsts.length);
}

/** Measures the fits ahead; a failed fit is repeated by its stage, which throws its Error. */
function measureFits(core: Core, firsts: FirstCall[]): void {
  const fits = firsts.flatMap(({ run, settings, call }) => {
    const fitted = knownResult(cacheOf(firsts), call as CoreCall<'fitShape'>);
    return fitted ? [{ prepared: preparedOf(run, settings), mesh: fitted.result.mesh }] : [];
  });
  measureDistances(core, fits);
}

const levelToGuard = ({ run, settings }: BodyRequest, level: MeshAt): LevelToGuard => ({
  kept: run.get(keptHistoryStage, settings),
  curve: run.get(errorCurveStage, settings),
  deviations: run.get(deviationsStage, settings),
  level,
  limit: settings.maxDeviation,
});

/** Runs of a file with several bodies share one. */
const cacheOf = ([{ run }]: BodyRequest[]): ValueCache => run.context.cache!;

const preparedOf = (run: BodyRun, settings: SettingsOf<typeof preparedStage>): PreparedBody =>
  run.get(preparedStage, settings);
