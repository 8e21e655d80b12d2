/** The state of a call in the worker: the core, the settings, opened models, notes and progress. */

import { pairedModel } from '../../engine/body/paired_bodies';
import { chosenBodies } from '../../engine/body/selection';
import type { Core, Progress } from '../../engine/core/core';
import { startStopwatch } from '../../engine/core/stopwatch';
import { openModel } from '../../engine/document/open';
import type { OpenModel } from '../../engine/document/open';
import { lineAlone, ofModel } from '../../engine/report/warnings';
import type { Warning } from '../../engine/report/warnings';
import { wordNote } from '../../engine/settings/options';
import type { Note, SettingName, Settings } from '../../engine/settings/options';
import { FileRun } from '../../engine/stages/file_run';
import { preparedWarnings } from '../../engine/stages/file_warnings';
import type { StageProgress } from '../options';
import type { ModelFiles, Which } from '../protocol';

/** Callers know settings by their names. */
export const nameOf = (setting: SettingName): string => setting;

/** A note of the engine in these names. */
export const inNames = (note: Note): string => wordNote(note, nameOf);

export class WorkSession {
  readonly notes: string[] = [];
  /** seconds since the last call of it */
  readonly lap = startStopwatch();
  readonly total = startStopwatch();
  private readonly files: FileRun[] = [];
  private readonly where = { body: '', stage: 'opening' };

  constructor(
    readonly core: Core,
    readonly settings: Settings,
    private readonly onProgress: (progress: StageProgress) => void,
  ) {}

  /** Sends the progress of the run to the caller. */
  report({ phase, fraction }: Progress): void {
    this.onProgress({ ...this.where, phase, fraction });
  }

  async open(files: ModelFiles, which: Which = ''): Promise<OpenModel> {
    const model = await openModel(files);
    this.warn(model.notes, which);
    return model;
  }

  /** The indices of the bodies that take part. Throws an Error where none is chosen. */
  chosen(model: OpenModel): number[] {
    return chosenBodies(model, this.settings);
  }

  /** A run over the chosen bodies, prepared; `guides`: see FileRunOptions; one without a usable face stays as it is. Throws where no other is left. */
  prepare(
    model: OpenModel,
    { guides = false, which = '' }: { guides?: boolean; which?: Which } = {},
  ): FileRun {
    const onStage = (stage: string): void => {
      // A stage that only passes on the value of another one has no progress of its own.
      if (stage.endsWith(' where wanted')) return;
      this.where.stage = stage;
      this.report({ phase: 'idle', fraction: 0 });
    };
    const onActivity = (body: string): void => {
      this.where.body = body;
    };
    const options = { chosen: this.chosen(model), guides, onActivity, onStage, caller: 'library' } as const;
    const file = new FileRun(this.core, model, options);
    this.files.push(file);
    this.warn(preparedWarnings(file, this.settings), which);
    return file;
  }

  /** As `prepare`, of the bodies beside those of the original: see `pairedModel`. */
  preparePartners(original: OpenModel, other: OpenModel): FileRun {
    return this.prepare(pairedModel(original, other, this.settings), { which: 'second ' });
  }

  /** `which`: of the models of a call with two, the one that the warnings are about. */
  warn(warnings: Warning[], which: Which = ''): void {
    const named = which === '' ? warnings : warnings.map((warning) => ofModel(`${which}model`, warning));
    this.notes.push(...named.map(lineAlone));
  }

  /** Releases the handles of the runs in the core. */
  dispose(): void {
    for (const file of this.files) file.dispose();
  }
}
