/** The page's side of the worker that replays histories. */

import { transfer, wrap } from 'comlink';
import type { Remote } from 'comlink';
import type { MeshAt } from '../../engine/core/core';
import { watchLife } from '../worker/life';
import type { ReplayApi } from '../worker/replay';
import { coreFolder } from '../worker/core_folder';

export class Replayer {
  private remote: Remote<ReplayApi> | null = null;
  private ended: Promise<never> = new Promise(() => undefined);
  private port: MessagePort | null = null;

  /** `base`: the address of the page's folder, with a final slash. */
  constructor(private readonly base: string) {}

  /** The port to which a worker sends its histories. */
  listen(port: MessagePort): void {
    if (this.remote) void this.remote.listen(transfer(port, [port]));
    else this.port = port;
  }

  /** Starts the worker unless it has been started before. */
  open(): void {
    if (this.remote) return;
    const worker = new Worker(new URL('../worker/replay_worker.ts', import.meta.url), { type: 'module' });
    this.remote = wrap<ReplayApi>(worker);
    const lock = `limber-replay-${crypto.randomUUID()}`;
    const started = this.remote.start(coreFolder(this.base), lock);
    this.ended = new Promise((_, reject) => {
      const end = (why: string): void => reject(new Error(why));
      worker.addEventListener('error', ({ message }) => end(message ?? 'Failed to fetch its script'));
      started.then(
        () => watchLife(lock, () => end('the browser has ended it')),
        (error: unknown) => end(String(error)),
      );
    });
    this.ended.catch(() => undefined);
    if (this.port) this.listen(this.port);
    this.port = null;
  }

  /** See ReplayApi. Rejects if the worker could not be started or has ended. */
  meshAt(id: string, faces: number): Promise<MeshAt | null> {
    this.open();
    return Promise.race([this.remote!.meshAt(id, faces), this.ended]);
  }
}
