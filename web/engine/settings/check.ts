/** Validates settings, one by one and in combination. */

import { METHOD_NAMES } from '../core/methods';
import { counted, excerpt, quotedJson, quotedValue } from '../core/words';
import { engineValues } from './engine_text';
import { SettingError } from './errors';
import { rulesOf } from './kinds';
import type { Notation } from './kinds';
import { readsSetting, resolveModes } from './methods';
import { OPTIONS, SETTING_NAMES } from './table';
import type { SettingName, Settings } from './table';
import { profileOf } from '../solvers/profiles';
import type { OptionSpec } from './types';

/** Settings that do nothing without a solver. */
export const SOLVER_SETTINGS = ['engine', 'tune', 'bendRatio', 'massRule'] as const satisfies SettingName[];

/**
 * Throws SettingError, whose sentence names the first refused value, the allowed ones and the cure. `notation`: where values come
 * from.
 */
export function checkSettings(settings: Settings, notation: Notation = 'text'): void {
  for (const setting of SETTING_NAMES) checkSetting(setting, settings[setting], notation);
  checkModes(settings);
  checkSolver(settings);
}

/**
 * Throws SettingError for the first of the given settings that has no effect, because the method of `settings` does not use it.
 * Weights of 0 and a fit that is off are accepted: they ask for nothing. `notation`: where values come from.
 */
export function checkAllUsed(
  settings: Settings,
  given: readonly SettingName[],
  notation: Notation = 'text',
): void {
  const { method } = settings;
  const unused = given.find((name) => !NOTHING.includes(settings[name]) && !readsSetting(settings, name));
  if (unused === undefined) return;
  const users = METHOD_NAMES.filter((other) => readsSetting({ method: other }, unused));
  throw new SettingError(unused, [
    `is ${SHOWN[notation](settings[unused])}, but ${method} does not use it: leave it out, or give `,
    { setting: 'method' },
    ` ${users.join(' or ')}.`,
  ]);
}

const NOTHING: readonly unknown[] = [0, 'off'];

function checkModes(settings: Settings): void {
  const { modes, modeCount, modeWeights } = settings;
  const highest = Array.isArray(modes) ? Math.max(...modes) : 0;
  const computed = { setting: 'modeCount' } as const;
  if (highest > modeCount)
    throw new SettingError('modes', [
      `names mode ${highest}, but `,
      computed,
      ` computes only ${modeCount}: raise `,
      computed,
      ` to ${highest} or name lower modes.`,
    ]);
  const guiding = resolveModes(settings).length;
  if (modeWeights.length > 0 && modeWeights.length !== guiding)
    throw new SettingError('modeWeights', [
      `has ${counted(modeWeights.length, 'number')} for ${counted(guiding, 'guiding mode')}: give one for each mode of `,
      { setting: 'modes' },
      '.',
    ]);
}

/** Whether the solver has the given parameters, and supports the kind of tuning. */
function checkSolver({ solver, engine, tune, massRule }: Settings): void {
  if (solver === 'none') return;
  engineValues(solver, engine);
  const { takes } = profileOf(solver);
  if (tune === 'constraint' && !takes.constraintValues)
    throw new SettingError(
      'tune',
      `is constraint, but ${solver} takes maps of vertices at best: give global or vertex.`,
    );
  if (massRule === 'area' && !takes.vertexMasses)
    throw new SettingError(
      'massRule',
      `is area, but ${solver} has one mass for all vertices: give vertex or auto.`,
    );
}

/** Throws SettingError with the value, what is allowed, and the default. */
export function checkSetting(setting: SettingName, value: unknown, notation: Notation = 'text'): void {
  const option = OPTIONS[setting];
  const rules = rulesOf(option);
  if (!rules.isAllowed(value, option)) {
    const allowed = `${rules.describe(option, notation)} (default: ${describeDefault(option)})`;
    throw new SettingError(setting, `is ${SHOWN[notation](value)}: give ${allowed}.`);
  }
  rules.parse?.(String(value), setting);
}

const SHOWN: Record<Notation, (value: unknown) => string> = {
  text: shownText,
  // "inf" has been read as the number that it stands for.
  json: (value) => (typeof value === 'number' ? String(value) : quotedJson(value)),
  script: quotedValue,
};

/** Lists as they are typed; objects, which nobody can type, as JSON. */
function shownText(value: unknown): string {
  const isList = Array.isArray(value) && value.every((one) => typeof one !== 'object');
  if (isList) return excerpt(value.join(',')) || 'an empty list';
  return typeof value === 'object' ? quotedJson(value) : excerpt(String(value));
}

function describeDefault(option: OptionSpec): string {
  if (option.kind === 'numbers') return option.emptyMeans ?? 'none';
  return option.default === '' ? 'none' : String(option.default);
}
