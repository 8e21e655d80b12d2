/** Going from step to step. Steps are entries of the browser's history: Back goes to the step before, and leaves the page from the first. */

import { batch, effect } from '@preact/signals';
import { view, wants } from '../store';
import type { Step } from '../store';

export const STEP_NAMES: readonly Step[] = ['model', 'motion', 'reduce', 'test'];

/** What an entry of the history knows. */
interface Entry {
  /** absent of an entry that the page has not made, as of a link that was opened in it */
  step?: Step;
  /** whether the link of its address still waits for its file, while another file is open */
  isOtherOpen?: boolean;
}

export const entry = (): Entry => (history.state as Entry | null) ?? {};

/** Changes the current entry in its place. */
export function changeEntry(change: Entry, address = location.href): void {
  history.replaceState({ ...entry(), ...change }, '', address);
}

/** Shows a step, and nothing over it. */
export function goToStep(step: Step): void {
  batch(() => {
    view.step.value = step;
    view.picking.value = false;
    wants.exportOpen.value = false;
  });
}

/** Makes entries of steps from now on. Call this before anything is opened: a reload begins with the step of its entry. */
export function followSteps(): void {
  const stepOfEntry = (): Step => STEP_NAMES.find((name) => name === entry().step) ?? STEP_NAMES[0];
  view.step.value = stepOfEntry();
  changeEntry({ step: view.step.value });
  effect(() => {
    const step = view.step.value;
    if (step !== stepOfEntry()) history.pushState({ ...entry(), step }, '');
  });
  addEventListener('popstate', () => goToStep(stepOfEntry()));
}
