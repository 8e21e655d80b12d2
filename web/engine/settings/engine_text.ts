/** The user's own parameters of an engine as text: name=value, separated by commas. */

import { profileOf } from '../solvers/profiles';
import type { SolverName } from '../solvers/profiles';
import type { NativeParameter, NativeValues } from '../solvers/profile';
import { SettingError } from './errors';

const FORM = 'name=value,name=value';

/** The values by name; none for ''. Throws SettingError where the text has not this form. */
export function parseEngine(text: string): NativeValues {
  const values = new Map<string, number>();
  for (const term of text.split(',').filter((part) => part.trim() !== '')) {
    const [, name, number] = /^\s*([\w-]+)\s*=\s*(\S+)\s*$/.exec(term) ?? [];
    if (name === undefined) throw new SettingError('engine', `has “${term.trim()}”: give ${FORM}.`);
    const value = Number(number);
    if (!Number.isFinite(value))
      throw new SettingError('engine', `has ${number} for ${name}: give a number.`);
    if (values.has(name)) throw new SettingError('engine', `names ${name} twice: give it once.`);
    values.set(name, value);
  }
  return Object.fromEntries(values);
}

/**
 * The user's own values of a solver's parameters, under the names of the profile. Throws SettingError where the solver lacks a
 * parameter or a value is out of its range.
 */
export function engineValues(solver: SolverName, text: string): NativeValues {
  const { parameters } = profileOf(solver);
  const values: Record<string, number> = {};
  for (const [name, value] of Object.entries(parseEngine(text))) {
    const parameter = parameters.find((one) => one.name === name || one.alias === name);
    if (!parameter) throw unknownParameter(name, solver, parameters);
    if (parameter.name in values)
      throw new SettingError('engine', `names ${parameter.name} twice: give it once.`);
    if (value < parameter.min || value > parameter.max)
      throw new SettingError('engine', `has ${value} for ${name}: give a number ${rangeOf(parameter)}.`);
    values[parameter.name] = value;
  }
  return values;
}

const rangeOf = ({ min, max, unit }: NativeParameter): string =>
  `from ${min} to ${max}${unit === '' ? '' : ` ${unit}`}`;

function unknownParameter(name: string, solver: SolverName, known: readonly NativeParameter[]): SettingError {
  const names = known.map((parameter) => parameter.name).join(', ');
  return new SettingError('engine', `names ${name}, which ${solver} does not have: it has ${names}.`);
}

/** The text of values, in their order; the inverse of `parseEngine`. */
export const engineText = (values: NativeValues): string =>
  Object.entries(values)
    .map(([name, value]) => `${name}=${value}`)
    .join(',');
