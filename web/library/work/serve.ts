/** Answers requests in the worker, one at a time. */

import type { Core, Progress } from '../../engine/core/core';
import { loadCore } from '../../engine/core/load_core';
import { SettingError, wordSentence } from '../../engine/settings/options';
import { inCallersWords, SERVE_ASSETS } from '../protocol';
import type {
  CoreAddress,
  Failure,
  Commands,
  CommandName,
  ModelFiles,
  WorkMessage,
  WorkRequest,
} from '../protocol';
import { findModes, inspectModel } from './modes';
import { optimizeModel } from './optimize';
import { compareModels, tuneModel } from './pairs';
import { WorkSession } from './session';
import { settingsFrom } from './settings';
import { simulateModels } from './simulate';

type Run<Name extends CommandName> = (
  session: WorkSession,
  models: ModelFiles[],
  options: Commands[Name]['options'],
) => Promise<Commands[Name]['reply']>;

const RUN: { [Name in CommandName]: Run<Name> } = {
  optimize: optimizeModel,
  tune: tuneModel,
  modes: findModes,
  compare: compareModels,
  simulate: simulateModels,
  inspect: inspectModel,
};

export class Server {
  /** of all requests: those for another number of threads go to another worker */
  private core: Core | null = null;
  private onProgress: (progress: Progress) => void = () => {};
  /** whether a request waits for its end */
  private isOpen = false;

  /** `send` takes a message to the caller. */
  constructor(private readonly send: (message: WorkMessage) => void) {}

  /** Sends progress, and then the reply or the failure. */
  async answer(request: WorkRequest): Promise<void> {
    this.isOpen = true;
    try {
      this.end({ value: await this.run(request) });
    } catch (error) {
      this.end({ failure: failureOf(error, request.models) });
    }
  }

  /** Ends the request with an error, which may arrive outside of it. */
  fail(error: unknown): void {
    this.end({ failure: failureOf(error, []) });
  }

  /** Sends the final message of a request. A core that cannot start fails twice; the second failure is not for the next request. */
  private end(message: WorkMessage): void {
    if (this.isOpen) this.send(message);
    this.isOpen = false;
  }

  private async run({ command, models, options, core: address }: WorkRequest) {
    const settings = settingsFrom(command, options);
    const onProgress = (progress: Progress) => this.onProgress(progress);
    this.core ??= await loadCore({ threads: settings.threads, onProgress, ...address }).catch(
      (error: unknown) => {
        throw isServed(address) && !(error instanceof RangeError) ? new Error(notLoaded(address)) : error;
      },
    );
    const session = new WorkSession(this.core, settings, (progress) => this.send({ progress }));
    this.onProgress = (progress) => session.report(progress);
    try {
      return await (RUN[command] as Run<CommandName>)(session, models, options as never);
    } finally {
      session.dispose();
    }
  }
}

/** Whether the caller serves the files of the core itself, which may go wrong. */
const isServed = ({ wasmFolder }: CoreAddress): boolean => /^https?:/.test(wasmFolder);

const notLoaded = ({ wasmFolder }: CoreAddress): string =>
  `The core in ${wasmFolder} cannot be loaded: ${SERVE_ASSETS}`;

/** Callers know settings by their names, and models without a name by their place. Plain Errors of the engine are about the input. */
function failureOf(error: unknown, models: ModelFiles[]): Failure {
  if (error instanceof SettingError) {
    const name = (setting: string) => setting;
    const message = inCallersWords(wordSentence(error.setting, error.sentence, name), models);
    return { message, setting: error.setting, isInternal: false };
  }
  const message = inCallersWords(error instanceof Error ? error.message : String(error), models);
  const isSentence = error instanceof Error && error.constructor === Error;
  return { message, setting: null, isInternal: !isSentence };
}
