/** Runs the bodies of one file. */

import type { PreparedBody } from '../body/prepared_body';
import type { Core } from '../core/core';
import { sum } from '../core/mesh';
import type { Body } from '../document/model';
import type { OpenModel } from '../document/open';
import type { Settings } from '../settings/options';
import { admitBodies, admitFit } from './admission';
import type { Caller, MemoryLimit } from './admission';
import { BodyRun } from './body_run';
import { FileProgress } from './many_bodies/file_progress';
import type { WorkSpan } from './many_bodies/file_progress';
import { tooSmallToMove, withFewFaces } from './many_bodies/scene_share';
import { ValueCache } from './many_bodies/value_cache';
import { STAGES } from './stages';

export interface FileRunOptions {
  /**
   * Whether modes are needed only for guidance, which is the default: a part that cannot be solved is not guided, and
   * parts of a file with many are solved more coarsely. false: the modes themselves are wanted.
   */
  guides?: boolean;
  /** numbers of the bodies that take part; absent: all of them */
  chosen?: number[];
  /** called when work on a body begins, and before each number of faces that is tried to keep its frequencies */
  onActivity?: (body: string, triedFaces?: number) => void;
  /** called as work on many bodies goes on, see FileProgress */
  onProgress?: (span: WorkSpan | null) => void;
  /** called with the name of each stage that is about to be computed */
  onStage?: (stage: string) => void;
  /** who reads the errors; absent: the command line */
  caller?: Caller;
}

/**
 * The runs over the bodies of a model; page, command line and library work through it and `FileOutput`. The constructor throws an Error
 * where the core cannot have enough memory.
 */
export class FileRun {
  private readonly all: (BodyRun | null)[];
  readonly progress: FileProgress;
  readonly guides: boolean;

  constructor(
    readonly core: Core,
    readonly model: OpenModel,
    private readonly options: FileRunOptions = {},
  ) {
    this.progress = new FileProgress(options.onProgress);
    const chosen = options.chosen && new Set(options.chosen);
    const { document, bodies } = model;
    this.guides = options.guides !== false;
    const isChosen = (i: number) => !chosen || chosen.has(i);
    const taking = bodies.filter((_, i) => isChosen(i));
    admitBodies(taking, this.memoryLimit);
    const tooSmall = this.guides ? tooSmallToMove(document, taking) : new Set<Body>();
    const few = withFewFaces(taking);
    const cache = bodies.length > 1 ? new ValueCache(2 * bodies.length) : undefined;
    this.all = bodies.map((body, i) => {
      if (!isChosen(i)) return null;
      const onTry = (faces: number) => options.onActivity?.(body.name, faces);
      const guidedBodies = this.guides ? bodies.length : undefined;
      const isTooSmallToMove = tooSmall.has(body);
      const hasFewFaces = few.has(body);
      const context = { core, body, document, onTry, guidedBodies, isTooSmallToMove, hasFewFaces, cache };
      return new BodyRun(context, options.onStage);
    });
  }

  /** runs[i] is that of model.bodies[i]; null: the body does not take part and stays as it is. */
  get runs(): readonly (BodyRun | null)[] {
    return this.all;
  }

  /** Releases the handles of the runs in the core. The file must not be run afterwards. */
  dispose(): void {
    for (const run of this.all) run?.dispose();
  }

  /** The runs of the bodies that take part, with their numbers. */
  get usable(): { run: BodyRun; i: number }[] {
    return this.all.flatMap((run, i) => (run ? [{ run, i }] : []));
  }

  /**
   * Prepares the bodies that take part and drops those without a usable face; returns one sentence for each of these.
   * Throws the first of the errors where no body is left, and an Error where results need more memory than the core can have.
   */
  prepare(settings: Settings): string[] {
    const unusable = this.leaveOutUnusable(settings);
    if (this.guides) admitFit(this.prepared(settings), settings, this.memoryLimit);
    return unusable;
  }

  private get memoryLimit(): MemoryLimit {
    return { heapLimit: this.core.heapLimit, caller: this.options.caller ?? 'command line' };
  }

  private leaveOutUnusable(settings: Settings): string[] {
    const refused: Error[] = [];
    const sizeOf = ({ context }: BodyRun): number => context.body.indices.length;
    const piece = this.progress.pass(sum(this.usable.map(({ run }) => sizeOf(run))), 1);
    for (const { run, i } of this.usable)
      piece(sizeOf(run), () => {
        const error = this.refusalOf(run, settings);
        if (!error) return;
        refused.push(error);
        this.all[i] = null;
      });
    if (refused.length > 0 && this.usable.length === 0) throw refused[0];
    return refused.map(({ message }) => message);
  }

  /** Prepares a body; returns the error of one without a usable face. */
  private refusalOf(run: BodyRun, settings: Settings): Error | null {
    this.announce(run);
    try {
      run.get(STAGES.prepared, settings);
      return null;
    } catch (error) {
      if (!(error instanceof Error) || error.constructor !== Error) throw error;
      return error;
    }
  }

  /** The prepared bodies that take part. */
  prepared(settings: Settings): PreparedBody[] {
    return this.preparedOf(this.usable, settings);
  }

  /** The prepared bodies of some of the runs. */
  preparedOf(some: FileRun['usable'], settings: Settings): PreparedBody[] {
    return some.map(({ run }) => run.get(STAGES.prepared, settings));
  }

  /** Calls `onActivity` when work on the body of this run begins. */
  announce({ context }: BodyRun): void {
    this.options.onActivity?.(context.body.name);
  }
}
