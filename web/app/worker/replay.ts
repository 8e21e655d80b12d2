/** Replays the history of one body in a worker other than the one that made it, so that the slider never waits for other work. */

import type { Core, History, HistoryHandle, MeshAt, MeshHandle, TriangleMesh } from '../../engine/core/core';
import { levelAt } from '../../engine/stages/level';

/** A history as passed on by the worker that has made it. */
export interface HandedHistory {
  /** unique for every history of every worker */
  id: string;
  mesh: TriangleMesh;
  history: History;
}

/** The calls of the worker that replays. */
export interface ReplayApi {
  /** Loads the core from this folder. The worker holds the lock for its lifetime, see `watchLife`. */
  start(wasmFolder: string, lock: string): Promise<void>;
  /** Sets a port at which histories arrive, each replacing the previous one. */
  listen(port: MessagePort): void;
  /**
   * The largest mesh with at most this many faces, as soon as the history has arrived; null: another one has replaced
   * it. Throws if the core could not keep it.
   */
  meshAt(id: string, faces: number): Promise<MeshAt | null>;
}

interface Kept {
  id: string;
  history: History;
  historyHandle: HistoryHandle;
  meshHandle: MeshHandle;
}

export class Replay {
  private kept: Kept | null = null;
  /** the last history, if the core could not keep it */
  private refused: { id: string; error: unknown } | null = null;
  private readonly former = new Set<string>();
  private arrived: () => void = () => undefined;
  private arrival = this.nextArrival();

  constructor(private readonly core: Core) {}

  private nextArrival(): Promise<void> {
    return new Promise((resolve) => (this.arrived = resolve));
  }

  /** Replaces the history. */
  keep({ id, mesh, history }: HandedHistory): void {
    this.release();
    try {
      const [meshHandle, historyHandle] = [this.core.keepMesh(mesh), this.core.keepHistory(history)];
      this.kept = { id, history, historyHandle, meshHandle };
    } catch (error) {
      this.refused = { id, error };
    }
    this.arrived();
    this.arrival = this.nextArrival();
  }

  private release(): void {
    if (this.refused) this.former.add(this.refused.id);
    this.refused = null;
    if (!this.kept) return;
    this.former.add(this.kept.id);
    this.core.releaseHistory(this.kept.historyHandle);
    this.core.releaseMesh(this.kept.meshHandle);
    this.kept = null;
  }

  /** See ReplayApi. */
  async meshAt(id: string, faces: number): Promise<MeshAt | null> {
    while (![this.kept?.id, this.refused?.id].includes(id) && !this.former.has(id)) await this.arrival;
    if (this.refused?.id === id) throw this.refused.error;
    return this.kept?.id === id ? levelAt(this.core, this.kept, faces) : null;
  }
}
