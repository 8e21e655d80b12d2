/** The poses of original and result at the end of the scenario: simulated in a worker of their own, without being shown. */

import { proxy, wrap } from 'comlink';
import { STEP_SECONDS } from '../../engine/motion/simulation';
import type { SimulationApi, TwinFrame } from '../worker/simulation_protocol';
import { coreFolder } from '../worker/core_folder';
import { twinSetup } from './simulation';
import { failureOf } from './simulation_failure';
import { shownMesh, wants } from './store';
import { say } from '../language/say';

interface PoseRequest {
  /** called with the completed share of the steps, 0..1 */
  onProgress(share: number): void;
  signal: AbortSignal;
}

/** Null if it was cancelled. Throws an Error with one sentence if the bodies cannot be simulated. */
export async function endPose({ onProgress, signal }: PoseRequest): Promise<TwinFrame | null> {
  const steps = Math.max(1, Math.round(wants.settings.value.seconds / STEP_SECONDS));
  const setup = twinSetup(shownMesh.value!);
  const worker = new Worker(new URL('../worker/simulation_worker.ts', import.meta.url), { type: 'module' });
  const failed = failureOf(worker);
  const ended = new Promise<null>((resolve) => signal.addEventListener('abort', () => resolve(null)));
  try {
    const moved = moveTo(wrap<SimulationApi>(worker), { setup, steps }, onProgress);
    return await Promise.race([moved, failed, ended]);
  } finally {
    worker.terminate();
  }
}

async function moveTo(
  api: ReturnType<typeof wrap<SimulationApi>>,
  { setup, steps }: { setup: ReturnType<typeof twinSetup>; steps: number },
  onProgress: (share: number) => void,
): Promise<TwinFrame> {
  let last: TwinFrame | null = null;
  let arrived: () => void = () => {};
  const show = (frame: TwinFrame): Promise<void> => {
    last = frame;
    arrived();
    return Promise.resolve();
  };
  await api.load(coreFolder(), proxy(show), `limber-pose-${crypto.randomUUID()}`);
  await api.start(setup, { vertexDistances: false, driven: false });
  const isThere = (): boolean => last !== null && last.time > (steps - 0.5) * STEP_SECONDS;
  const hasEnded = (): boolean => last !== null && (last.diverged.length > 0 || last.failure !== null);
  for (let step = 0; step < steps && !hasEnded(); step++) {
    await api.step();
    onProgress((step + 1) / steps);
  }
  while (!isThere() && !hasEnded()) await new Promise<void>((resolve) => (arrived = resolve));
  const { failure, diverged } = last!;
  if (failure) throw new Error(failure);
  if (diverged.length > 0)
    throw new Error(say('A body has left the scene: raise the substeps of the Test step.'));
  return last!;
}
