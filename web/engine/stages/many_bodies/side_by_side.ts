/** Runs the small bodies of a file side by side: each is too small to keep all threads busy by itself. */

import type { PreparedBody } from '../../body/prepared_body';
import type { Core } from '../../core/core';
import { vertexCount } from '../../core/mesh';
import { methodOf } from '../../settings/options';
import type { Settings } from '../../settings/options';
import type { BodyRun } from '../body_run';
import { callAll, resultOf } from './core_call';
import type { CoreCall } from './core_call';
import type { EqualWork } from './equal_work';
import type { FileRun } from '../file_run';
import { fittedStage } from '../fitted';
import { guidanceStage } from '../guidance';
import { historyStage } from '../history';
import { measureDistances } from '../measure';
import { modesStage } from '../modes';
import { preparedStage } from '../prepared';
import type { AnyStage, RunSettings, SettingsOf } from '../stage';

type Usable = FileRun['usable'];

/** A body of more vertices is worth all threads. */
const MOST_VERTICES = 4000;
/** Vertices of the bodies that are run at a time, so that progress is seen and cancelling loses little. */
const VERTICES_AT_A_TIME = 8000;

/** The stages up to the history that begin with a call of the core, in order. */
export const stagesOfHistory = (settings: Pick<Settings, 'method'>): AnyStage[] => [
  ...(methodOf(settings).needsGuidance ? [modesStage, guidanceStage] : []),
  historyStage,
];

/** How the bodies of a file are run. */
export interface BodyWork<Value> {
  /** stages whose first calls are made side by side, in order */
  stages: AnyStage[];
  /** whether the results of `fittedStage`, which is the last of them, are measured side by side as well */
  measures?: boolean;
  settingsOf: (i: number) => RunSettings;
  /** what is made of each body then; its stages have made their first calls */
  each: (usable: Usable[number]) => Value;
}

/** Runs some of the bodies of a file, in order; calls that belong to the same stage of small bodies are made side by side. */
export function runBodies<Value>(file: FileRun, some: Usable, work: BodyWork<Value>): Value[] {
  return groupsOf(file, some, work.settingsOf).flatMap((group) => {
    file.announce(group[0].run);
    if (group.length > 1) callAhead(file.core, group, work);
    return group.map((usable) => {
      file.announce(usable.run);
      return work.each(usable);
    });
  });
}

/** A body and the call with which a stage of it begins. */
interface First {
  run: BodyRun;
  prepared: PreparedBody;
  call: CoreCall;
}

function callAhead(core: Core, group: Usable, { stages, settingsOf, measures }: BodyWork<unknown>): void {
  const { equalWork } = group[0].run.context;
  if (!equalWork) return;
  for (const stage of stages) {
    const firsts = group.flatMap(({ run, i }): First[] => {
      const call = run.firstCall(stage, settingsOf(i));
      return call ? [{ run, call, prepared: preparedOf(run, settingsOf(i)) }] : [];
    });
    const start = performance.now();
    callAll(
      core,
      equalWork,
      firsts.map(({ call }) => call),
    );
    if (measures && stage === fittedStage) measureFits(core, equalWork, firsts);
    const seconds = (performance.now() - start) / 1000;
    for (const { run } of firsts) run.addAhead(stage, seconds / firsts.length);
  }
}

function measureFits(core: Core, equalWork: EqualWork, firsts: First[]): void {
  const fits = firsts.map(({ prepared, call }) => {
    const { result } = resultOf(core, equalWork, call as CoreCall<'fitShape'>);
    return { prepared, mesh: result.mesh };
  });
  measureDistances(core, fits);
}

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
