/** The page's tasks, and keys for them: those of the stages behind them, for the file and the body that are shown. */

import type { Signal } from '@preact/signals';
import type { Settings } from '../../../engine/settings/options';
import { keyOf } from '../../../engine/stages/stage';
import type { Stage } from '../../../engine/stages/stage';
import { isHistoryStale, results, wants } from '../store';

/** One call of the worker whose result the page shows. */
export interface Task {
  /** what the progress line says */
  what: string;
  /** equal keys lead to equal results; null: the result is not needed now */
  key(): string | null;
  run(): Promise<unknown>;
  result: Signal<unknown>;
  /** any other task goes before it, and stops it where it runs */
  isPatient?: boolean;
  /** whether any task that is neither late nor patient goes before it */
  isLate?(): boolean;
  /** its result is the same for every body of the file */
  isOfFile?: boolean;
  /** takes back the question after a failure: where the user asks again, the task runs again with the same key */
  giveUp?(): void;
}

/** null: the task is not needed now */
type Key = () => string | null;

/** A stage that the settings alone decide about: the page asks for whole histories. */
export type SettingsStage = Stage<unknown, keyof Settings | 'fewestFaces'>;
/** A stage that a number of faces may decide about as well. */
export type LevelStage = Stage<unknown, keyof Settings | 'fewestFaces' | 'targetFaces'>;

export const of = (stage: SettingsStage) => (): string => keyOf(stage, wants.settings.value);

export const ofFaces = (stage: LevelStage, faces: () => number) => (): string =>
  keyOf(stage, { ...wants.settings.value, targetFaces: faces() });

/** `make` for the shown body of the open file; null without a file. */
export const keyed =
  (make: () => string): Key =>
  () =>
    results.file.value ? `${results.opened.value} ${wants.body.value} ${make()}` : null;

/** The same for the file as a whole, whichever body is shown. */
export const keyedByFile =
  (make: () => string): Key =>
  () =>
    results.file.value ? `${results.opened.value} ${make()}` : null;

/** The same once the body is prepared. */
export const afterBody =
  (make: () => string): Key =>
  () =>
    results.body.value ? keyed(make)() : null;

/** The same once the body has the history of the settings: nothing is made of an earlier one. */
export const afterHistory =
  (make: () => string): Key =>
  () =>
    results.history.value && !isHistoryStale.value ? afterBody(make)() : null;
