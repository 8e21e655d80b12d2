/** What the settings, and the settings file of a tuned body, ask of a simulation. */

import { materialOf } from '../body/material';
import type { PreparedBody } from '../body/prepared_body';
import type { SettingsFile } from '../report/settings_file';
import { solversOfSettings } from '../report/solvers_of_settings';
import type { Settings } from '../settings/options';
import type { SolverPair } from '../solvers/solver_pair';
import { simulatedMaterial, solversAsTheyAre } from '../motion/simulation';

/** What is simulated, for the report. `tuning`: what the other body was tuned with, or null. */
export function askedMotion(settings: Settings, tuning: SettingsFile | null, isPair: boolean) {
  const { scenario, solver: named } = settings;
  const material = simulatedMaterial(settings);
  const solver = tuning?.solver ?? (named === 'none' ? undefined : named);
  return { material, scenario, solver, tuned: solver && isPair ? tuning !== null : undefined };
}

/** What both are simulated with in a solver; null without one. */
export function solversOf(
  settings: Settings,
  original: PreparedBody,
  other: PreparedBody | null,
  tuning: SettingsFile | null,
): SolverPair | null {
  if (tuning && other)
    return solversOfSettings(tuning, original.mesh, other, materialOf(original, settings).unit);
  return solversAsTheyAre(original, { original: original.mesh, result: (other ?? original).mesh }, settings);
}
