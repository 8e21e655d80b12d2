/** The properties of each method of simplification. No other file compares method names. */

import type { Model } from '../core/core';
import { METHODS } from '../core/methods';
import type { Method } from '../core/methods';
import { OPTIONS, SETTING_NAMES } from './table';
import type { SettingName, Settings } from './table';
import type { OptionSpec } from './types';

/** A row of METHODS with typed names of settings. */
export interface MethodSpec extends Omit<(typeof METHODS)[number], 'defaults' | 'reads' | 'autoModel'> {
  defaults: Partial<Settings>;
  reads: readonly SettingName[];
  autoModel: 'auto' | Model;
}

const SPECS: readonly MethodSpec[] = METHODS;

/** Settings that not every method reads. */
const PARTICULAR = new Set(SPECS.flatMap(({ reads }) => reads));

/** The properties of the method of these settings. */
export const methodOf = ({ method }: Pick<Settings, 'method'>): MethodSpec =>
  SPECS.find(({ name }) => name === method)!;

/** Whether the method of these settings reads the setting. */
export const readsSetting = (settings: Pick<Settings, 'method'>, setting: SettingName): boolean =>
  !PARTICULAR.has(setting) || methodOf(settings).reads.includes(setting);

/** A fresh copy of a method's defaults. */
export function defaultSettings(method: Method = 'limber'): Settings {
  const entries = SETTING_NAMES.map((name) => [name, structuredClone(OPTIONS[name].default)]);
  const settings = Object.fromEntries(entries) as unknown as Settings;
  return { ...settings, method, ...methodOf({ method }).defaults };
}

/** The settings that change with the method: the method itself, and every setting whose default depends on it. */
export function methodChange(method: Method): Partial<Settings> {
  const defaults = defaultSettings(method);
  const names = SPECS.flatMap((spec) => Object.keys(spec.defaults) as SettingName[]);
  return { method, ...Object.fromEntries(names.map((name) => [name, defaults[name]])) };
}

/** The defaults of the settings that name parts of one file. */
export const fileDefaults = (): Partial<Settings> => defaultsWhere(({ isOfFile }) => isOfFile);

/** The defaults of the settings that name parts of one file or say what one model is for. */
export const modelDefaults = (): Partial<Settings> =>
  defaultsWhere(({ isOfFile, isOfUse }) => isOfFile ?? isOfUse);

const defaultsWhere = (isMeant: IsMeant): Partial<Settings> => settingsWhere(isMeant, defaultSettings());

/** `others`, with the settings that name parts of a file from `ofFile`. */
export const fileSettings = (ofFile: Settings, others: Settings): Settings => ({
  ...others,
  ...settingsWhere(({ isOfFile }) => isOfFile, ofFile),
});

/** `ofFile`, with the settings of a person or machine from `person`; null: with their defaults. */
export const withPerson = (ofFile: Settings, person: Settings | null): Settings => ({
  ...ofFile,
  ...settingsWhere(({ isOfPerson, isOfMachine }) => isOfPerson ?? isOfMachine, person ?? defaultSettings()),
});

type IsMeant = (option: OptionSpec) => true | undefined;

function settingsWhere(isMeant: IsMeant, settings: Settings): Partial<Settings> {
  const names = SETTING_NAMES.filter((name) => isMeant(OPTIONS[name]));
  return Object.fromEntries(names.map((name) => [name, settings[name]]));
}

/** The fit of the settings, or 'off' if the method cannot be fitted. */
export const fitOf = (settings: Pick<Settings, 'method' | 'fit'>): Settings['fit'] =>
  methodOf(settings).canFit ? settings.fit : 'off';

/** The elastic model for guidance; `auto` is resolved by the method. */
export const resolveModel = (settings: Pick<Settings, 'method' | 'model'>): 'auto' | Model =>
  settings.model === 'auto' ? methodOf(settings).autoModel : settings.model;

/** The numbers, from 1, of the guiding elastic modes; `all` and `auto` are resolved, `auto` by the method. */
export function resolveModes(settings: Pick<Settings, 'method' | 'modes' | 'modeCount'>): number[] {
  const { modes, modeCount } = settings;
  if (Array.isArray(modes)) return modes;
  const autoCount = Math.min(methodOf(settings).autoModes, modeCount);
  return Array.from({ length: modes === 'all' ? modeCount : autoCount }, (_, index) => index + 1);
}
