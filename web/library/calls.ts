/** The calls of the library. One worker runs them in their order. */

import type { Document } from '@gltf-transform/core';
import { checkOptions, checkRun } from './arguments';
import { applyBodies, filesOf, isDocument } from './models';
import type {
  CompareOptions,
  CompareReport,
  FileLevel,
  InspectOptions,
  Model,
  ModesOptions,
  ModesResult,
  OptimizedDocument,
  OptimizedGlb,
  OptimizeOptions,
  Reported,
  RunOptions,
  SimulateOptions,
  SimulatePairReport,
  SimulateResult,
  TuneOptions,
  TuneResult,
} from './options';
import type { CommandName, Commands } from './protocol';
import { workQueue } from './work_queue';

/**
 * Removes triangles where they matter least for how the bodies bend. A document is changed in place, and nothing else may change it
 * until the call has ended. For bytes and files, the result has the bytes that the command line writes with the same settings. A
 * document does not stay compressed: compress it again with a transform of glTF-Transform.
 *
 * Rejects with LimberError if the model or an option cannot be used, and with the signal's reason if it is aborted; a document is
 * then unchanged.
 */
export function optimize(
  model: Document,
  options?: OptimizeOptions,
  run?: RunOptions,
): Promise<OptimizedDocument>;
export function optimize(
  model: Exclude<Model, Document>,
  options?: OptimizeOptions & { lodStyle?: 'files' },
  run?: RunOptions,
): Promise<OptimizedGlb<FileLevel>>;
export function optimize(
  model: Exclude<Model, Document>,
  options?: OptimizeOptions,
  run?: RunOptions,
): Promise<OptimizedGlb>;
export function optimize(
  model: Model,
  options?: OptimizeOptions,
  run?: RunOptions,
): Promise<OptimizedDocument | OptimizedGlb>;
export async function optimize(
  model: Model,
  options: OptimizeOptions = {},
  run: RunOptions = {},
): Promise<OptimizedDocument | OptimizedGlb> {
  checkOptions(options);
  const wantsBodies = isDocument(model);
  const { files, bodies, ...others } = await work('optimize', [model], { ...options, wantsBodies }, run);
  if (!wantsBodies) return { glb: files[0].bytes, files, ...others };
  await applyBodies(model, bodies, options.fields ?? false);
  // Further levels of a document are files.
  return { document: model, ...others, levels: others.levels as FileLevel[] };
}

/** A transform for `document.transform(limber({ ratio: 0.5 }))` of glTF-Transform; see `optimize`. */
export function limber(options: OptimizeOptions = {}, run: RunOptions = {}) {
  const transforms = {
    async limber(document: Document): Promise<void> {
      await optimize(document, options, run);
    },
  };
  return transforms.limber;
}

/** Finds the solver parameters with which `coarse`, any coarser mesh of `original`, moves like it. */
export const tune: (
  original: Model,
  coarse: Model,
  options: TuneOptions,
  run?: RunOptions,
) => Promise<TuneResult> = (original, coarse, options: Partial<TuneOptions> = {}, run = {}) =>
  work('tune', [original, coarse], options, run);

/** Finds the natural frequencies of the bodies, and the modes in which they vibrate. */
export const modes = (model: Model, options: ModesOptions = {}, run: RunOptions = {}): Promise<ModesResult> =>
  work('modes', [model], options, run);

/** Measures how similar the original and another model are in shape and vibration. */
export const compare = (
  original: Model,
  other: Model,
  options: CompareOptions = {},
  run: RunOptions = {},
): Promise<Reported<CompareReport>> => work('compare', [original, other], options, run);

/** Simulates the original and, unless it is null, another model. The report has the times per step and the motion deviation. */
export function simulate(
  original: Model,
  other: Model,
  options?: SimulateOptions,
  run?: RunOptions,
): Promise<SimulateResult<SimulatePairReport>>;
export function simulate(
  original: Model,
  other: Model | null,
  options?: SimulateOptions,
  run?: RunOptions,
): Promise<SimulateResult>;
export function simulate(
  original: Model,
  other: Model | null,
  options: SimulateOptions = {},
  run: RunOptions = {},
): Promise<SimulateResult> {
  return work('simulate', other === null ? [original] : [original, other], options, run);
}

/** Reports the contents and the defects of a model. */
export const inspect = (
  model: Model,
  options: InspectOptions = {},
  run: RunOptions = {},
): Promise<Reported> => work('inspect', [model], options, run);

/** Ends the worker and frees its memory. Calls that have not ended are rejected; the next call starts another worker. */
export const close = (): void => workQueue().close();

/** Of the models of a call with two. */
const ORDINALS = ['first ', 'second '] as const;

async function work<Name extends CommandName>(
  command: Name,
  models: Model[],
  options: Commands[Name]['options'],
  run: RunOptions,
): Promise<Commands[Name]['reply']> {
  checkOptions(options);
  checkRun(run);
  // Signals of older browsers and of libraries have no throwIfAborted.
  if (run.signal?.aborted) throw run.signal.reason;
  // Queued at once, whatever the models take: calls are worked on in their order, and `close` ends all that were made.
  const files = models.map((model, i) => filesOf(model, models.length > 1 ? ORDINALS[i] : ''));
  return workQueue().run(command, Promise.all(files), options, run);
}
