/** The core of the command line. It is started while a command is loaded, which takes as long. */

import { existsSync, readdirSync } from 'node:fs';
import type { Core, Progress } from '../engine/core/core';
import { loadCore } from '../engine/core/load_core';
import type { Arguments } from './arguments';
import { UsageError } from './failure';
import { canRedraw } from './terminal';

type OnProgress = (progress: Progress) => void;

interface Started {
  core: Promise<Core>;
  /** who is told of the progress */
  onProgress: OnProgress;
}

let started: Started | null = null;

/** Starts the core that `takeCore` returns. What goes wrong is told there. */
export function startCore(args: Arguments): void {
  const own: Started = { core: loadFor(args, (progress) => own.onProgress(progress)), onProgress: () => {} };
  own.core.catch(() => {});
  started = own;
}

/** The core for the arguments; `onProgress` is called where there is a line of progress. */
export async function takeCore(args: Arguments, onProgress: OnProgress): Promise<Core> {
  if (started === null) startCore(args);
  const { core } = Object.assign(started!, { onProgress });
  started = null;
  return core;
}

const loadFor = (args: Arguments, onProgress: OnProgress): Promise<Core> =>
  loadSessionCore(args.settings.threads, showsProgress(args) ? onProgress : undefined, args.memory);

const showsProgress = ({ quiet }: Arguments): boolean => !quiet && canRedraw(process.stderr);

/** A core from where the command line has it. */
export const loadSessionCore = async (
  threads: number,
  onProgress?: OnProgress,
  memory: number | null = null,
): Promise<Core> => loadCore({ threads, wasmFolder: findWasm(), onProgress, memory: memory ?? undefined });

/** The core is among the assets of the npm package, beside the built page, or in public/ in a working copy. */
function findWasm(): string {
  const folders = ['../assets/', ...foldersOfPage(), '../../public/wasm/'].map(
    (folder) => new URL(folder, import.meta.url),
  );
  const found = folders.find((folder) => existsSync(new URL('limber-single.js', folder)));
  if (!found) throw new UsageError('The WebAssembly core is missing: run npm run build.');
  return found.href;
}

/** Where the built page has the core: in a folder named after its bytes. */
function foldersOfPage(): string[] {
  const all = '../app/wasm/';
  const path = new URL(all, import.meta.url);
  return existsSync(path) ? readdirSync(path).map((version) => `${all}${version}/`) : [];
}
