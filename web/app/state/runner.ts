/** Runs tasks in the worker, in their order, whenever the key of one differs from the key that its result was made from. */

import { batch, effect, signal, untracked } from '@preact/signals';
import type { SourceFile } from '../../engine/document/open';
import { faceCount } from '../../engine/core/mesh';
import { fileDefaults } from '../../engine/settings/options';
import { STAGES } from '../../engine/stages/stages';
import { CANCELLED, sharesKey } from '../worker/protocol';
import { WorkerLost } from './client';
import { canDrawFile, resultFileNow } from './drawn_file';
import { exportSettings } from '../worker/export_form';
import { exportedKey, exportRequest, levelsKey } from './export_request';
import { findPins } from './find_pins';
import { takeAwaited } from './link';
import { compareMethods, comparison, comparisonTaskKey } from './methods';
import type { Wanted } from './link';
import { fittingOwnFaces } from './own_faces';
import { isReplayed, startReplay } from './replay';
import { client, complain, replayer, whileBusy } from './running';
import { saveFiles, startSaving } from './saved_session';
import { afterBody, afterHistory, keyed, keyedByFile, of, ofFaces } from './task';
import type { LevelStage, Task } from './task';
import { isTuningWanted, twin } from './twin';
import {
  changeSettings,
  isFileDrawn,
  keptFaces,
  results,
  shownMesh,
  status,
  view,
  wantedFaces,
  whyKey,
  wants,
} from './store';
import { forgetUndo, startUndo } from './undo';

const REST_MILLISECONDS = 180;
const settings = () => wants.settings.value;
const body = () => wants.body.value;

/** The wanted faces as they were when the slider last rested. */
const restedFaces = signal(0);

/** Whether results are looked at. */
const isReducing = (): boolean =>
  view.step.value === 'reduce' || view.step.value === 'test' || wants.exportOpen.value;

const areSeveral = (): boolean => (results.file.value?.bodies.length ?? 0) > 1;
const sharesNow = (): string => sharesKey(settings(), keptFaces.value);

/** The key of a stage that waits until the slider rests on a mesh that is shown; see replay.ts. */
const atRest = (stage: LevelStage) => (): string | null =>
  isReducing() && restedFaces.value === wantedFaces.value && isReplayed.value
    ? afterHistory(ofFaces(stage, () => restedFaces.value))()
    : null;

const tasks: Task[] = [
  {
    what: 'Reading the mesh',
    key: keyed(of(STAGES.prepared)),
    run: () => client.call((worker) => worker.prepare(body(), settings())),
    result: results.body,
  },
  {
    what: 'Reading the materials',
    key: () => (results.body.value && canDrawFile() ? keyedByFile(() => 'original')() : null),
    run: () => client.call((worker) => worker.original()),
    result: results.originalFile,
    isOfFile: true,
  },
  {
    what: 'Finding pins',
    key: afterBody(of(STAGES.pinned)),
    run: () => findPins(client, body()),
    result: results.pins,
  },
  {
    what: 'Finding modes',
    key: afterBody(of(STAGES.modes)),
    run: () => client.call((worker) => worker.modes(body(), settings())),
    result: results.modes,
  },
  {
    what: 'Measuring strain',
    key: () => (results.modes.value ? afterBody(of(STAGES.guidance))() : null),
    run: () => client.call((worker) => worker.guidance(body(), settings())),
    result: results.guidance,
  },
  {
    what: 'Measuring curvature',
    key: afterBody(of(STAGES.curvature)),
    run: () => client.call((worker) => worker.curvature(body(), settings())),
    result: results.curvature,
  },
  {
    what: 'Collapsing edges',
    key: afterBody(of(STAGES.history)),
    run: () => client.call((worker) => worker.history(body(), settings())),
    result: results.history,
  },
  {
    what: 'Sharing the faces out',
    key: () => (isReducing() && areSeveral() ? afterHistory(sharesNow)() : null),
    run: () => client.call((worker) => worker.shares(settings(), keptFaces.value)),
    result: results.shares,
  },
  {
    what: 'Fitting the result',
    key: atRest(STAGES.fitted),
    run: () => client.call((worker) => worker.fit(body(), settings(), restedFaces.value)),
    result: results.fitted,
  },
  {
    what: 'Tuning the result to its solver',
    key: () => (isTuningWanted.value && results.fitted.value ? atRest(STAGES.tuned)() : null),
    run: () => client.call((worker) => worker.tune(body(), settings(), restedFaces.value)),
    result: results.tuned,
  },
  {
    what: 'Measuring the result',
    key: () => (results.fitted.value ? atRest(STAGES.measured)() : null),
    run: () => client.call((worker) => worker.measure(body(), settings(), restedFaces.value)),
    result: results.metrics,
  },
  {
    what: 'Writing and checking the file',
    key: () =>
      wants.exportOpen.value && restedFaces.value === wantedFaces.value ? afterHistory(exportedKey)() : null,
    run: () =>
      client.call((worker) => worker.export(exportSettings(settings()), keptFaces.value, exportRequest())),
    result: results.exported,
  },
  {
    what: 'Tuning for all generic solvers',
    key: () =>
      twin.wantsGeneric.value && restedFaces.value === wantedFaces.value ? afterHistory(exportedKey)() : null,
    run: () =>
      client.call((worker) =>
        worker.genericFiles(exportSettings(settings()), keptFaces.value, exportRequest()),
      ),
    result: results.genericFiles,
    isPatient: true,
  },
  {
    what: 'Drawing the levels',
    key: () =>
      wants.exportOpen.value && wants.levelsShown.value && settings().lods.length > 0
        ? afterHistory(levelsKey)()
        : null,
    run: () => client.call((worker) => worker.drawnLevels(settings(), keptFaces.value)),
    result: results.drawnLevels,
    isPatient: true,
  },
  {
    what: 'Dressing the result in its materials',
    key: () => (isResultFileWanted() ? keyedByFile(resultFileNow)() : null),
    run: () => client.call((worker) => worker.resultFile(settings(), keptFaces.value)),
    result: results.resultFile,
    isOfFile: true,
    isPatient: true,
  },
  {
    what: 'Comparing methods',
    key: comparisonTaskKey,
    run: () => compareMethods(client),
    result: comparison.compared,
    isPatient: true,
  },
  {
    what: 'Asking why vertices stay',
    key: () =>
      view.step.value === 'reduce' && view.hover.value !== null && results.metrics.value !== null
        ? afterHistory(whyKey)()
        : null,
    run: () => client.call((worker) => worker.why(body(), settings(), faceCount(shownMesh.value!.mesh))),
    result: results.why,
    isPatient: true,
  },
  {
    what: 'Marking the deviation on the slider',
    key: () => (isMarkingWanted() ? afterHistory(of(STAGES.deviationMarks))() : null),
    run: () => client.call((worker) => worker.marks(body(), settings())),
    result: results.marks,
    isPatient: true,
  },
];

const isResultFileWanted = (): boolean =>
  view.step.value === 'reduce' &&
  isFileDrawn.value &&
  results.metrics.value !== null &&
  restedFaces.value === wantedFaces.value &&
  canDrawFile() &&
  isStoppable();

/** Without shared memory a patient task can only be stopped by a fresh worker, which has everything to do again. */
const MOST_FACES_UNSTOPPABLE = 20_000;

const isMarkingWanted = (): boolean =>
  view.step.value === 'reduce' && results.metrics.value !== null && isStoppable();

const isStoppable = (): boolean =>
  client.canStop || (results.history.value?.faces ?? 0) <= MOST_FACES_UNSTOPPABLE;

/** The key that the result of each task was made from. */
const done = new Map<Task, string>();
let running: Task | null = null;
/** the call of the last task, settled once it has stopped */
let call: Promise<unknown> = Promise.resolve();
let looping = false;
let opening: Promise<void> = Promise.resolve();

/**
 * Opens files in place of what is shown; where they cannot be read, what is shown stays and a notice says why. `asked`:
 * what a link or an earlier session asks of them.
 */
export function openFiles(files: SourceFile[], asked?: Wanted): Promise<void> {
  if (running) client.cancel();
  replayer.open();
  opening = opening.then(async () => {
    await whileBusy('Opening', async () => {
      await call.catch(() => null);
      const file = await client.open(files);
      const wanted = asked ?? takeAwaited(file.name);
      done.clear();
      batch(() => {
        for (const task of tasks) task.result.value = null;
        results.mesh.value = null;
        results.file.value = file;
        results.opened.value += 1;
        wants.body.value = wanted && wanted.body < file.bodies.length ? wanted.body : file.first;
        wants.faces.value = wanted?.faces ?? null;
        wants.own.value = fittingOwnFaces(wanted?.own, file.bodies);
        wants.exportOpen.value = false;
        view.hidden.value = new Set();
        view.animated.value = false;
        if (wanted) wants.settings.value = wanted.settings;
        else changeSettings(fileDefaults());
        status.refusedPins.value = null;
        view.picking.value = false;
        view.brush.value = { ...view.brush.value, tool: null };
        status.notice.value = null;
      });
      forgetUndo();
      void saveFiles(files);
    }).catch((error: unknown) => complain(error));
  });
  return opening.then(loop);
}

/** Shows another body of the same file. */
export function showBody(index: number): void {
  if (index === wants.body.value) return;
  if (running) client.cancel();
  const ofBody = tasks.filter((task) => !task.isOfFile);
  for (const task of ofBody) done.delete(task);
  batch(() => {
    for (const task of ofBody) task.result.value = null;
    results.mesh.value = null;
    wants.body.value = index;
  });
  forgetUndo();
}

/** The user's cancel: the task waits until its inputs change or `resume` is called. */
export function cancelRunning(): void {
  if (!running) return;
  status.paused.value = running.what;
  client.cancel();
}

export function resume(): void {
  if (status.paused.value === null) return;
  status.paused.value = null;
  done.clear();
  void loop();
}

/** Runs tasks from now on whenever the state asks for them. */
export function startRunner(): void {
  startUndo();
  startReplay();
  void startSaving();
  void client
    .ready()
    .then(() => (status.threads.value = client.threads))
    .catch((error: unknown) => complain(error));
  effect(() => {
    const keys = tasks.map((task) => task.key());
    untracked(() => {
      // The result of a call whose inputs have changed would not be shown.
      if (running && (keys[tasks.indexOf(running)] !== runningKey || mustWait(running))) client.cancel();
      void loop();
    });
  });
  effect(() => {
    const faces = wantedFaces.value;
    const timer = setTimeout(() => (restedFaces.value = faces), REST_MILLISECONDS);
    return () => clearTimeout(timer);
  });
}

/** Whether something else is due before a patient task goes on. */
const mustWait = (task: Task): boolean => task.isPatient === true && nextTask() !== task;

let runningKey: string | null = null;

const nextTask = () =>
  tasks.find((task) => {
    const key = task.key();
    return key !== null && done.get(task) !== key;
  });

async function loop(): Promise<void> {
  if (looping) return;
  looping = true;
  status.isComputing.value = true;
  for (;;) {
    // A file that is being opened replaces what the next task works on.
    await opening;
    const task = nextTask();
    if (!task) break;
    running = task;
    runningKey = task.key();
    const key = runningKey!;
    try {
      const value = await (call = whileBusy(task.what, () => task.run()));
      done.set(task, key);
      status.paused.value = null;
      task.result.value = value;
    } catch (error) {
      const isStopped = error instanceof Error && error.message === CANCELLED;
      // It may end again for the same reason, so the user decides whether it runs again.
      if (error instanceof WorkerLost) status.paused.value = task.what;
      if (!isStopped) complain(error);
      // The task is not tried again before its inputs change.
      if (!isStopped || status.paused.value !== null) {
        done.set(task, key);
        break;
      }
    } finally {
      running = null;
    }
  }
  looping = false;
  status.isComputing.value = false;
}
