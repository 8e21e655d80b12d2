/** The messages between the caller and the worker that holds the core: plain data. */

import type { ExportedBody } from '../engine/document/export';
import type { SourceFile } from '../engine/document/open';
import type { SettingName } from '../engine/settings/options';
import type {
  ModesOptions,
  ModesResult,
  OptimizedGlb,
  OptimizeOptions,
  Reported,
  SimulateOptions,
  SimulateResult,
  StageProgress,
  TuneOptions,
  TuneResult,
  CompareOptions,
  CompareReport,
  InspectOptions,
} from './options';

/** A model as files, with its companions. */
export type ModelFiles = SourceFile[];

/** One of several models of a call, in words before "model"; '' for the only one. */
export type Which = '' | 'first ' | 'second ';

/** The main files of models that callers give as bytes and as documents: these names are unknown to the callers. */
export const glbName = (which: Which): string => `${which}model.glb`;
export const documentName = (which: Which): string => `${which}document.gltf`;

const WORDS = new Map(
  (['', 'first ', 'second '] as const).flatMap((which) => [
    [glbName(which), `the ${which}model`],
    [documentName(which), `the ${which}document`],
  ]),
);

/** A sentence about these models that names none of their files by a name that the caller does not know. */
export const inCallersWords = (sentence: string, models: ModelFiles[]): string =>
  models
    .flatMap(([main]) => (main ? [main.name] : []))
    .reduce((text, name) => renamed(text, name, WORDS.get(name)), sentence);

function renamed(sentence: string, name: string, words: string | undefined): string {
  if (words === undefined) return sentence;
  const text = sentence.replaceAll(name, words);
  return sentence.startsWith(name) ? `${text[0].toUpperCase()}${text.slice(1)}` : text;
}

export interface OptimizeRequest extends OptimizeOptions {
  /** the caller replaces the bodies in a document of its own, instead of getting a GLB */
  wantsBodies: boolean;
}

export interface OptimizeReply extends Omit<OptimizedGlb, 'glb'> {
  /** per body of the file; null: it is unchanged */
  bodies: (ExportedBody | null)[];
}

/** Per command its options and its reply. */
export interface Commands {
  optimize: { options: OptimizeRequest; reply: OptimizeReply };
  tune: { options: Partial<TuneOptions>; reply: TuneResult };
  modes: { options: ModesOptions; reply: ModesResult };
  compare: { options: CompareOptions; reply: Reported<CompareReport> };
  simulate: { options: SimulateOptions; reply: SimulateResult };
  inspect: { options: InspectOptions; reply: Reported };
}

export type CommandName = keyof Commands;

/** Where the worker finds the core, see CoreOptions. */
export interface CoreAddress {
  wasmFolder: string;
  addresses?: Record<string, string>;
}

/** The cure for missing or wrong files of the core. */
export const SERVE_ASSETS =
  'serve all files of limber/assets, of this version and unchanged, from its folder.';

export interface WorkRequest {
  command: CommandName;
  models: ModelFiles[];
  options: Commands[CommandName]['options'];
  core: CoreAddress;
}

/** An error on its way to the caller. */
export interface Failure {
  message: string;
  setting: SettingName | null;
  isInternal: boolean;
}

/** Any number of `progress` messages, then one of the others. */
export type WorkMessage =
  { progress: StageProgress } | { value: Commands[CommandName]['reply'] } | { failure: Failure };

/** A started worker; `listener` gets its messages, and the error that ends it. */
export interface StartedWorker {
  core: CoreAddress;
  post(request: WorkRequest): void;
  /** whether the program waits for the worker before it ends; Node only */
  keepAlive(isBusy: boolean): void;
  terminate(): void;
}

export interface Listener {
  onMessage(message: WorkMessage): void;
  onError(error: Error): void;
}
