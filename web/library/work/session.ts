/** What every call needs in the worker: the core, the settings, opened models, notes and progress. */

import { describeHealth } from '../../engine/body/health';
import type { PreparedBody } from '../../engine/body/prepared_body';
import { chosenBodies } from '../../engine/body/selection';
import type { Core, Progress } from '../../engine/core/core';
import { startStopwatch } from '../../engine/core/stopwatch';
import { openModel } from '../../engine/document/open';
import type { OpenModel } from '../../engine/document/open';
import { wordNote } from '../../engine/settings/options';
import type { Note, Settings } from '../../engine/settings/options';
import { FileRun } from '../../engine/stages/file_run';
import type { StageProgress } from '../options';
import type { ModelFiles } from '../protocol';

/** A note of the engine; callers know settings by their names. */
export const inNames = (note: Note): string => wordNote(note, (setting) => setting);

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

  /** Tells the caller where the run is. */
  report({ phase, fraction }: Progress): void {
    this.onProgress({ ...this.where, phase, fraction });
  }

  async open(files: ModelFiles): Promise<OpenModel> {
    const model = await openModel(files);
    this.notes.push(...model.notes);
    return model;
  }

  /** The numbers of the bodies that take part. Throws an Error where none is chosen. */
  chosen(model: OpenModel): number[] {
    return chosenBodies(model, this.settings);
  }

  /** A run over the chosen bodies, prepared; `guides`: see FileRunOptions; one without a usable face stays as it is. Throws where no other is left. */
  prepare(model: OpenModel, { guides = false } = {}): FileRun {
    const onStage = (stage: string): void => {
      // A stage that only passes on the value of another has nothing of its own to tell.
      if (stage.endsWith(' where wanted')) return;
      this.where.stage = stage;
      this.report({ phase: 'idle', fraction: 0 });
    };
    const onActivity = (body: string): void => {
      this.where.body = body;
    };
    const file = new FileRun(this.core, model, { chosen: this.chosen(model), guides, onActivity, onStage });
    this.files.push(file);
    for (const sentence of file.prepare(this.settings))
      this.notes.push(`${sentence.replace(/\.$/, '')}; it stays as it is`);
    for (const body of file.prepared(this.settings)) this.noteHealth(model, body);
    return file;
  }

  private noteHealth({ bodies }: OpenModel, { body, weld, inspection }: PreparedBody): void {
    const name = bodies.length > 1 ? `${body.name}: ` : '';
    for (const { kind, text } of describeHealth(body, weld, inspection))
      if (kind !== 'fact') this.notes.push(`${name}${text}`);
  }

  /** Gives back what the runs hold in the core. */
  dispose(): void {
    for (const file of this.files) file.dispose();
  }
}
