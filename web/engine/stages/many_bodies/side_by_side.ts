/** Runs the small bodies of a file side by side: each is too small to keep all threads busy by itself. */

import type { PreparedBody } from '../../body/prepared_body';
import type { Core } from '../../core/core';
import { vertexCount } from '../../core/mesh';
import { methodOf } from '../../settings/options';
import type { BodyRun } from '../body_run';
import { deviationsStage } from '../budget/deviations';
import { errorCurveStage } from '../budget/error_curve';
import { guardSideBySide } from '../budget/guarded_level';
import type { GuardedBody } from '../budget/guarded_level';
import type { FileRun } from '../file_run';
import { fittedStage } from '../fitted';
import { guidanceStage } from '../guidance';
import { historyStage } from '../history';
import { keptHistoryStage } from '../kept_history';
import { levelStage } from '../level';
import { measureDistances } from '../measure';
import { modesStage } from '../modes';
import { preparedStage } from '../prepared';
import type { AnyStage, RunSettings, SettingsOf } from '../stage';
import { callAll, resultOf } from './core_call';
import type { CoreCall } from './core_call';
import type { EqualWork } from './equal_work';

type Usable = FileRun['usable'];

/** A body of more vertices is worth all threads. */
const MOST_VERTICES = 4000;
/** Vertices of the bodies that are run at a time, so that progress is seen and cancelling loses little. */
const VERTICES_AT_A_TIME = 8000;

/** How the bodies of a file are run. */
export interface BodyWork<Value> {
  settingsOf: (i: number) => RunSettings;
  /** how far the work that is done side by side goes */
  upTo: 'history' | 'result';
  /** what is made of each body then: its stages find the results of their calls */
  each: (usable: Usable[number]) => Value;
}

/** Runs some of the bodies of a file, in order; what the stages of small bodies ask of the core is done side by side. */
export function runBodies<Value>(file: FileRun, some: Usable, work: BodyWork<Value>): Value[] {
  return groupsOf(file, some, work.settingsOf).flatMap((group) => {
    file.announce(group[0].run);
    if (group.length > 1) callAhead(file.core, bodiesOf(group, work.settingsOf), work.upTo);
    return group.map((usable) => {
      file.announce(usable.run);
      return work.each(usable);
    });
  });
}

interface RunOfBody {
  run: BodyRun;
  settings: RunSettings;
}

const bodiesOf = (group: Usable, settingsOf: BodyWork<unknown>['settingsOf']): RunOfBody[] =>
  group.map(({ run, i }) => ({ run, settings: settingsOf(i) }));

function callAhead(core: Core, bodies: RunOfBody[], upTo: BodyWork<unknown>['upTo']): void {
  const [{ settings }] = bodies;
  if (methodOf(settings).needsGuidance)
    for (const stage of [modesStage, guidanceStage]) callFirst(core, bodies, stage);
  callFirst(core, bodies, historyStage);
  if (upTo === 'history') return;
  guardSideBySide(core, bodies.map(guardedBody));
  callFirst(core, bodies, fittedStage, measureFits);
}

/** A body and the call with which a stage of it begins. */
interface First extends RunOfBody {
  call: CoreCall;
}

/** Makes the first calls of a stage; `then` is part of its work. */
function callFirst(
  core: Core,
  bodies: RunOfBody[],
  stage: AnyStage,
  then: (core: Core, firsts: First[]) => void = () => {},
): void {
  const firsts = bodies.flatMap(({ run, settings }): First[] => {
    const call = run.firstCall(stage, settings);
    return call ? [{ run, settings, call }] : [];
  });
  const start = performance.now();
  callAll(
    core,
    equalWorkOf(bodies),
    firsts.map(({ call }) => call),
  );
  then(core, firsts);
  const seconds = (performance.now() - start) / 1000;
  for (const { run } of firsts) run.addAhead(stage, seconds / firsts.length);
}

function measureFits(core: Core, firsts: First[]): void {
  const fits = firsts.map(({ run, settings, call }) => {
    const { result } = resultOf(core, run.context.equalWork, call as CoreCall<'fitShape'>);
    return { prepared: preparedOf(run, settings), mesh: result.mesh };
  });
  measureDistances(core, fits);
}

const guardedBody = ({ run, settings }: RunOfBody): GuardedBody => ({
  kept: run.get(keptHistoryStage, settings),
  curve: run.get(errorCurveStage, settings),
  deviations: run.get(deviationsStage, settings),
  level: run.get(levelStage, settings),
  limit: settings.maxDeviation,
});

/** Runs of a file with several bodies share one. */
const equalWorkOf = ([{ run }]: RunOfBody[]): EqualWork => run.context.equalWork!;

const preparedOf = (run: BodyRun, settings: SettingsOf<typeof preparedStage>): PreparedBody =>
  run.get(preparedStage, settings);

/** Small bodies that follow each other, together; all others alone. */
function groupsOf(file: FileRun, some: Usable, settingsOf: (i: number) => RunSettings): Usable[] {
  const groups: Usable[] = [];
  let room = 0;
  for (const usable of some) {
    const size = vertexCount(preparedOf(usable.run, settingsOf(usable.i)).mesh);
    const isSmall = file.core.threads > 1 && size <= MOST_VERTICES;
    if (isSmall && size <= room) groups[groups.length - 1].push(usable);
    else groups.push([usable]);
    room = isSmall ? (size <= room ? room : VERTICES_AT_A_TIME) - size : 0;
  }
  return groups;
}
