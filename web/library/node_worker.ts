/** The worker in Node: a file of the package, beside this one. */

import { existsSync } from 'node:fs';
import { Worker } from 'node:worker_threads';
import type { Listener, StartedWorker, WorkMessage, WorkRequest } from './protocol';

/** Throws an Error where a bundler has taken this file out of its package. */
export function startNodeWorker(listener: Listener): StartedWorker {
  // Two steps, so that bundlers do not take the worker for one of their own.
  const folder = new URL('./', import.meta.url);
  const [program, assets] = [new URL('worker.mjs', folder), new URL('../assets/', folder)];
  if (!existsSync(program))
    throw new Error(
      `${program.pathname} is missing: let the bundler leave limber external for Node, as packages with files are.`,
    );
  // The program needs no flags of the caller, of which workers refuse some, such as --input-type.
  const worker = new Worker(program, { execArgv: [] });
  worker.on('message', (message: WorkMessage) => listener.onMessage(message));
  worker.on('error', (error: Error) => listener.onError(error));
  worker.on('exit', (code) => listener.onError(new Error(`The worker has ended with exit code ${code}.`)));
  worker.unref();
  return {
    core: { wasmFolder: assets.href },
    post: (request: WorkRequest) => worker.postMessage(request),
    keepAlive: (isBusy) => (isBusy ? worker.ref() : worker.unref()),
    terminate: () => void worker.terminate(),
  };
}
