/** Starts the worker that holds the core, in Node or a browser. The bundle for one of them does not contain the other. */

import type { Listener, StartedWorker } from './protocol';

/** `assets`: of RunOptions. `threads`: as asked for; 1 needs only the core of one thread. */
export async function startWorker(
  listener: Listener,
  { assets, threads }: { assets: string | null; threads: number },
): Promise<StartedWorker> {
  if (import.meta.env.SSR) {
    const { startNodeWorker } = await import('./node_worker');
    return startNodeWorker(listener);
  } else {
    const { startBrowserWorker } = await import('./browser_worker');
    return startBrowserWorker(listener, { assets, threads });
  }
}
