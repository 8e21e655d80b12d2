/** How similarly the bodies of two models vibrate. */

import type { Fidelity } from '../core/core';
import { knownErrors } from './settings_file';
import type { FidelityReport } from './solver_report';

/** `fidelity` is null if the frequencies cannot be compared; `failure` then says why in one sentence, and is empty otherwise. */
export interface BodyFidelity {
  fidelity: Fidelity | null;
  failure: string;
}

/** The part of a report that `compare` fills. */
export type VibrationReport = Omit<FidelityReport, 'solvers'>;

/** Of the body with the largest mean frequency error among those that can be compared. `names[i]`: the body's name. */
export function fidelityReport(bodies: BodyFidelity[], names: string[]): VibrationReport {
  const failures = bodies.flatMap(({ failure }, i) => {
    if (failure === '') return [];
    return bodies.length > 1 ? `"${names[i]}": ${failure}` : failure;
  });
  return {
    ...knownErrors(worstFidelity(bodies.flatMap(({ fidelity }) => fidelity ?? [])) ?? {}),
    ...(failures.length > 0 ? { failure: failures[0] } : {}),
  };
}

/** The fidelity of the worst body, which has the largest mean frequency error; null without bodies. */
export function worstFidelity(fidelities: Fidelity[]): Fidelity | null {
  if (fidelities.length === 0) return null;
  return fidelities.reduce((worst, one) => (one.frequencyErrorMean > worst.frequencyErrorMean ? one : worst));
}
