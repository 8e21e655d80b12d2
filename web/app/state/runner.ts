/** Runs tasks in the worker, in order, whenever the key of a task differs from that of its result. */

import { batch, effect, signal, untracked } from '@preact/signals';
import type { SourceFile } from '../../engine/document/open';
import { fileDefaults, modelDefaults } from '../../engine/settings/options';
import { CANCELLED } from '../worker/protocol';
import type { OpenedBody, OpenedFile } from '../worker/protocol';
import { WorkerLost } from './client';
import { takeAwaited } from './link';
import type { Wanted } from './link';
import { refusedLock } from './locks';
import { fittingOwnFaces } from './own_faces';
import { isLinedUp } from './queue/queue';
import { startReplay } from './replay';
import { client, complain, replayer, whileBusy } from './running';
import { afterSample } from './samples/sample_settings';
import { saveFiles, startSaving } from './saved_session';
import { results, status, view, wants } from './store';
import type { Task } from './tasks/task';
import { startResting, tasks } from './tasks/tasks';
import { twin } from './twin';
import { forgetUndo, startUndo } from './undo';
import { beginWork, endWork, startKeepingWork, workBefore } from './work/file_work';
import { contentKey } from './work/kept_work';

/** The key with which each task was last computed or failed. */
const done = new Map<Task, string>();
/** The key of each task that the user has cancelled or whose worker has ended: with that key it waits for `resume`. */
const stopped = signal<ReadonlyMap<Task, string>>(new Map());
/** the running task, the shown body, the key of its result, and the key that the task had when the user cancelled it */
let running: { task: Task; body: number; key: string; cancelled: string | null } | null = null;
/** the call of the last task, settled once it has stopped */
let call: Promise<unknown> = Promise.resolve();
let looping = false;
let opening: Promise<void> = Promise.resolve();
/** the files that are being opened */
let opened: { isCancelled: boolean } | null = null;

/** The request for files that are opened. */
export interface HowToOpen {
  /** the request of a link or an earlier session */
  asked?: Wanted;
  /** the initial settings without a request and without earlier work on them; absent: those of any other model */
  fresh?: Wanted;
  /** what is said once they are open of others that came with them */
  leftOut?: string;
}

/** Opens files in place of the shown ones; if they cannot be read, the shown ones stay and a notice says why. */
export function openFiles(files: SourceFile[], how: HowToOpen = {}): Promise<void> {
  if (running) client.cancel();
  replayer.open();
  opening = opening.then(() =>
    whileBusy('Opening', () => openNow(files, how)).catch((error: unknown) => {
      if (!isCancel(error)) complain(error);
    }),
  );
  return opening.then(loop);
}

const isCancel = (error: unknown): boolean => error instanceof Error && error.message === CANCELLED;

async function openNow(files: SourceFile[], how: HowToOpen): Promise<void> {
  const own = (opened = { isCancelled: false });
  try {
    await call.catch(() => null);
    if (own.isCancelled) return;
    const [file, key] = await Promise.all([client.open(files), contentKey(files)]);
    endWork();
    // The models of a queue share their settings.
    const startsAnew = !isLinedUp(files);
    const asked = how.asked ?? takeAwaited(file.name);
    const fresh = how.fresh ?? freshWanted(startsAnew);
    const before = asked ? null : workBefore(key, fresh, !startsAnew);
    take(file, asked ?? before ?? fresh, startsAnew);
    beginWork(key, { fresh, name: file.name, isKept: before !== null });
    if (how.leftOut) status.notice.value ??= { kind: 'info', text: how.leftOut };
    void saveFiles(files);
  } finally {
    opened = null;
  }
}

/** The request for a single model. `startsAnew`: without the settings that belong to the last model. */
function freshWanted(startsAnew: boolean): Wanted {
  const { value: last } = wants.settings;
  const settings = {
    ...last,
    ...afterSample(results.file.value?.name, last),
    ...(startsAnew ? modelDefaults() : fileDefaults()),
  };
  return { settings, faces: null, own: new Map(), body: 0, file: null };
}

/** Shows a file that the worker has opened. */
function take(file: OpenedFile, wanted: Wanted, startsAnew: boolean): void {
  done.clear();
  batch(() => {
    stopped.value = new Map();
    for (const task of tasks) task.result.value = null;
    results.mesh.value = null;
    results.file.value = file;
    results.opened.value += 1;
    wants.body.value = bodyToShow(file, wanted);
    wants.faces.value = wanted.faces;
    wants.own.value = fittingOwnFaces(wanted.own, file.bodies);
    wants.exportOpen.value = false;
    twin.wantsGeneric.value = false;
    view.hidden.value = new Set();
    view.animated.value = false;
    wants.settings.value = wanted.settings;
    if (startsAnew) twin.wantsTuned.value = twin.isSolverUnknown.value = false;
    status.refusedPins.value = refusedLock.value = null;
    view.picking.value = false;
    view.brush.value = { ...view.brush.value, tool: null };
    status.notice.value = null;
  });
  forgetUndo();
}

/** The requested body, if the file has it and it can be used. */
const bodyToShow = ({ bodies, first }: OpenedFile, { body }: Wanted): number =>
  isUsable(bodies, body) ? body : first;

const isUsable = (bodies: OpenedBody[], index: number): boolean =>
  index < bodies.length && bodies[index].health !== null;

/** Shows another body of the same file, if it exists and can be used. */
export function showBody(index: number): void {
  if (index === wants.body.value || !isUsable(results.file.value?.bodies ?? [], index)) return;
  if (running) client.cancel();
  const ofBody = tasks.filter((task) => !task.isOfFile);
  for (const task of ofBody) done.delete(task);
  batch(() => {
    stopped.value = new Map([...stopped.value].filter(([task]) => task.isOfFile));
    for (const task of ofBody) task.result.value = null;
    results.mesh.value = null;
    wants.body.value = index;
    // The sentence belongs to the other body; if this one refuses the pins too, it is shown again.
    status.refusedPins.value = null;
  });
}

/** Cancels on behalf of the user: a file is not opened, and a task waits until its inputs change or `resume` is called. */
export function cancelRunning(): void {
  if (opened) opened.isCancelled = true;
  // If its inputs have just changed, the cancellation applies to the task that would run next.
  else if (running) running.cancelled = running.task.key();
  client.cancel();
}

export function resume(): void {
  if (stopped.value.size === 0) return;
  stopped.value = new Map();
  done.clear();
  void loop();
}

/** From now on, runs tasks whenever the state requires them. */
export function startRunner(): void {
  startUndo(showBody);
  startReplay();
  startResting();
  void startSaving();
  startKeepingWork();
  void client
    .ready()
    .then(() => (status.threads.value = client.threads))
    .catch((error: unknown) => complain(error));
  effect(() => {
    const keys = tasks.map((task) => task.key());
    untracked(() => {
      // The result of a call whose inputs have changed would not be shown.
      if (running && (keys[tasks.indexOf(running.task)] !== running.key || mustWait(running.task)))
        client.cancel();
      void loop();
    });
  });
  effect(() => {
    const names = tasks.filter((task) => isStopped(task, task.key())).map(({ what }) => what);
    if (names.join() !== status.paused.peek().join()) status.paused.value = names;
  });
}

/** Whether another task is due before a patient task continues. */
const mustWait = (task: Task): boolean => task.isPatient === true && nextTask() !== task;

const isStopped = (task: Task, key: string | null): boolean =>
  key !== null && stopped.value.get(task) === key;

function isDue(task: Task): boolean {
  const key = task.key();
  return key !== null && done.get(task) !== key && !isStopped(task, key);
}

/** Patient tasks come after all others anyway. */
function nextTask(): Task | undefined {
  const due = tasks.filter(isDue);
  return due.find((task) => !task.isPatient && !task.isLate?.()) ?? due[0];
}

async function loop(): Promise<void> {
  if (looping) return;
  looping = true;
  status.isComputing.value = true;
  for (;;) {
    // A file that is being opened replaces the input of the next task.
    await opening;
    const task = nextTask();
    if (!task || !(await run(task, task.key()!))) break;
  }
  looping = false;
  status.isComputing.value = false;
}

/** Runs a task; returns whether the next one follows. */
async function run(task: Task, key: string): Promise<boolean> {
  const own: typeof running = (running = { task, body: wants.body.value, key, cancelled: null });
  try {
    const value = await (call = whileBusy(task.what, () => task.run()));
    // Another body may be chosen while the answer is in transit, which cannot be cancelled.
    if (own.body !== wants.body.value && !task.isOfFile) return true;
    done.set(task, key);
    setStopped(task, null);
    task.result.value = value;
    return true;
  } catch (error) {
    if (isCancel(error)) {
      setStopped(task, own.cancelled);
      // Otherwise its inputs have changed, or another task is due.
      return own.cancelled === null || own.cancelled !== task.key();
    }
    // A worker may end again for the same reason, so the user decides whether the task runs again.
    if (error instanceof WorkerLost) setStopped(task, key);
    else if (task.giveUp) task.giveUp();
    else done.set(task, key);
    complain(error);
    // The task is not retried before its inputs change.
    return task.key() !== key;
  } finally {
    running = null;
  }
}

function setStopped(task: Task, key: string | null): void {
  const all = new Map(stopped.value);
  if (key === null) all.delete(task);
  else all.set(task, key);
  stopped.value = all;
}
