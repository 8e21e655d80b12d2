/** The check of the substeps on the Test step: runs on demand in a worker of its own, and can be ended at any time. */

import { computed, signal } from '@preact/signals';
import { wrap } from 'comlink';
import type { Convergence } from '../../engine/motion/convergence';
import type { ConvergenceApi } from '../worker/convergence_worker';
import { coreFolder } from '../worker/core_folder';
import { simulationKey, twinSetup } from './simulation';
import { failureOf } from './simulation_failure';
import { shownMesh } from './store';

interface Checked {
  /** the inputs of the simulation that was checked */
  key: string;
  convergence: Convergence | null;
  /** why it could not be checked, in one sentence */
  failure: string | null;
}

const checked = signal<Checked | null>(null);
const checkingKey = signal<string | null>(null);
let worker: Worker | null = null;

/** The result for the current simulation; null: it has not been checked. */
export const convergenceCheck = computed(() =>
  checked.value?.key === simulationKey.value ? checked.value : null,
);
export const isCheckingConvergence = computed(
  () => checkingKey.value !== null && checkingKey.value === simulationKey.value,
);

export function endConvergenceCheck(): void {
  worker?.terminate();
  worker = null;
  checkingKey.value = null;
}

/** Replaces a check that is running. */
export async function checkConvergence(): Promise<void> {
  const [key, result] = [simulationKey.value, shownMesh.value];
  endConvergenceCheck();
  if (key === null || !result) return;
  const own = new Worker(new URL('../worker/convergence_worker.ts', import.meta.url), { type: 'module' });
  worker = own;
  checkingKey.value = key;
  const found = { key, convergence: null, failure: null };
  try {
    const wasmFolder = coreFolder();
    const measured = wrap<ConvergenceApi>(own).measure(wasmFolder, twinSetup(result));
    const convergence = await Promise.race([measured, failureOf(own)]);
    if (worker === own) checked.value = { ...found, convergence };
  } catch (error) {
    if (worker === own)
      checked.value = { ...found, failure: error instanceof Error ? error.message : String(error) };
  }
  if (worker === own) endConvergenceCheck();
}
