/** The page's tasks, and their keys: those of the underlying stages, for the shown file and body. */

import type { Signal } from '@preact/signals';
import type { Settings } from '../../../engine/settings/options';
import { keyOf } from '../../../engine/stages/stage';
import type { Stage } from '../../../engine/stages/stage';
import { isHistoryStale, results, wants } from '../store';

/** One call of the worker whose result the page shows. */
export interface Task {
  /** the text of the progress line */
  what: string;
  /** equal keys lead to equal results; null: the result is not needed now */
  key(): string | null;
  run(): Promise<unknown>;
  result: Signal<unknown>;
  /** any other task has priority over it, and stops it while it runs */
  isPatient?: boolean;
  /** whether any task that is neither late nor patient has priority over it */
  isLate?(): boolean;
  /** its result is the same for every body of the file */
  isOfFile?: boolean;
  /** withdraws the request after a failure: if the user repeats it, the task runs again with the same key */
  giveUp?(): void;
}

/** null: the task is not needed now */
type Key = () => string | null;

/** A stage that only depends on the settings: the page requests whole histories. */
export type SettingsStage = Stage<unknown, keyof Settings | 'fewestFaces'>;
/** A stage that may also depend on a number of faces. */
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

/** The same once the body has the history of the current settings: no result is made from an earlier one. */
export const afterHistory =
  (make: () => string): Key =>
  () =>
    results.history.value && !isHistoryStale.value ? afterBody(make)() : null;
