/** Methods at an equal budget: the request, and the results so far. */

import { computed, signal } from '@preact/signals';
import { MATERIAL_SETTINGS } from '../../engine/body/material';
import { SETTING_NAMES } from '../../engine/settings/options';
import { COMPARED_METHODS } from '../../engine/stages/equal_budget/equal_budget';
import type { MethodResult } from '../../engine/stages/equal_budget/equal_budget';
import { STAGES } from '../../engine/stages/stages';
import { CANCELLED } from '../worker/protocol';
import type { Client } from './client';
import { isHistoryStale, results, view, wantedFaces, wants } from './store';

export interface ComparedMethods {
  /** see comparisonKey */
  key: string;
  /** the most faces that each result may have */
  faces: number;
  /** in the order of COMPARED_METHODS; fewer while methods still run */
  results: readonly MethodResult[];
}

export const comparison = {
  isOpen: signal(false),
  compared: signal<ComparedMethods | null>(null),
};

/** The inputs of each method's result and its measures, see resultAtBudget. */
const FOLLOWED: readonly string[] = [...STAGES.fitted.reads, ...MATERIAL_SETTINGS];
/** Settings that affect the comparison; those of export and simulation do not. */
const READ = SETTING_NAMES.filter((name) => FOLLOWED.includes(name));

/** Text that is equal for equal comparisons of the shown body. */
export const comparisonKey = (): string =>
  JSON.stringify([
    results.opened.value,
    wants.body.value,
    wantedFaces.value,
    READ.map((name) => wants.settings.value[name]),
  ]);

/** Null while the panel is closed or there is nothing to compare. */
export const comparisonTaskKey = (): string | null =>
  comparison.isOpen.value &&
  view.step.value === 'reduce' &&
  results.history.value &&
  !isHistoryStale.value &&
  results.metrics.value
    ? comparisonKey()
    : null;

/** The comparison for the current settings. */
export const shownComparison = computed(() =>
  comparison.compared.value?.key === comparisonKey() ? comparison.compared.value : null,
);

/**
 * Runs the methods that are still missing, one after the other, and shows each as soon as it is ready. Throws an Error
 * with CANCELLED if the inputs change meanwhile.
 */
export async function compareMethods(client: Client): Promise<ComparedMethods> {
  const key = comparisonKey();
  const [body, settings, faces] = [wants.body.value, wants.settings.value, wantedFaces.value];
  let compared: ComparedMethods = shownComparison.value ?? { key, faces, results: [] };
  for (const name of COMPARED_METHODS.slice(compared.results.length)) {
    // A cancellation comes too late for a method that has just been measured.
    if (comparisonKey() !== key) throw new Error(CANCELLED);
    const result = await client.call<MethodResult>((worker) =>
      worker.methodAtBudget(body, settings, { name, faces }),
    );
    compared = { ...compared, results: [...compared.results, result] };
    comparison.compared.value = compared;
  }
  return compared;
}
