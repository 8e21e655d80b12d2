/** The solvers of a simulation, from the settings or the settings file of a tuned body. */

import { materialOf } from '../body/material';
import type { PreparedBody } from '../body/prepared_body';
import type { SettingsFile } from '../report/settings_file';
import { solversOfSettings } from '../report/solvers_of_settings';
import { OPTIONS, SettingError } from '../settings/options';
import type { Settings } from '../settings/options';
import type { SolverPair } from '../solvers/solver_pair';
import { simulatedMaterial, untouchedSolversOf } from '../motion/simulation';

const OF_SETTINGS_FILE = ['engine', 'bendRatio', 'massRule'] as const;

/** The simulated solver or material, for the report. `tuning`: the settings file of the other body, or null. */
export function motionModel(settings: Settings, tuning: SettingsFile | null, isPair: boolean) {
  const { scenario, solver: named } = settings;
  const material = simulatedMaterial(settings);
  const solver = tuning?.solver ?? (named === 'none' ? undefined : named);
  return { material, scenario, solver, tuned: solver && isPair ? tuning !== null : undefined };
}

/** Throws SettingError where a parameter of the solver is given beside a settings file, which has those of both bodies. */
export function checkBesideTuning(settings: Settings): void {
  const setting = OF_SETTINGS_FILE.find((name) => settings[name] !== OPTIONS[name].default);
  if (setting)
    throw new SettingError(
      setting,
      'is given together with a settings file, which already has the parameters of the original: leave one of them out.',
    );
}

/** The solvers of both bodies; null where none is chosen. */
export function solversOf(
  settings: Settings,
  original: PreparedBody,
  other: PreparedBody | null,
  tuning: SettingsFile | null,
): SolverPair | null {
  if (tuning && other)
    return solversOfSettings(tuning, original.mesh, other, materialOf(original, settings).unit);
  return untouchedSolversOf(
    original,
    { original: original.mesh, result: (other ?? original).mesh },
    settings,
  );
}
