/** What is particular to each method of simplification. No other file asks which method it is. */

import type { Model } from '../core/core';
import { METHODS } from '../core/methods';
import type { Method } from '../core/methods';
import { OPTIONS, SETTING_NAMES } from './table';
import type { SettingName, Settings } from './table';
import type { OptionSpec } from './types';

/** A row of METHODS; its settings are checked to be settings. */
export interface MethodSpec extends Omit<(typeof METHODS)[number], 'defaults' | 'reads' | 'autoModel'> {
  defaults: Partial<Settings>;
  reads: readonly SettingName[];
  autoModel: 'auto' | Model;
}

const SPECS: readonly MethodSpec[] = METHODS;

/** Settings that not every method reads. */
const PARTICULAR = new Set(SPECS.flatMap(({ reads }) => reads));

/** What is particular to the method of these settings. */
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

/** What changes with the method: itself, and every setting that some method starts differently. */
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

/** Settings that name parts of one file, and `others`. */
export const fileSettings = (ofFile: Settings, others: Settings): Settings => ({
  ...others,
  ...settingsWhere(({ isOfFile }) => isOfFile, ofFile),
});

/** Settings of a file with those of a person or machine from `person`; null: with their defaults. */
export const withPerson = (ofFile: Settings, person: Settings | null): Settings => ({
  ...ofFile,
  ...settingsWhere(({ isOfPerson, isOfMachine }) => isOfPerson ?? isOfMachine, person ?? defaultSettings()),
});

type IsMeant = (option: OptionSpec) => true | undefined;

function settingsWhere(isMeant: IsMeant, settings: Settings): Partial<Settings> {
  const names = SETTING_NAMES.filter((name) => isMeant(OPTIONS[name]));
  return Object.fromEntries(names.map((name) => [name, settings[name]]));
}

/** How results are fitted: as the settings say, where the method can. */
export const fitOf = (settings: Pick<Settings, 'method' | 'fit'>): Settings['fit'] =>
  methodOf(settings).canFit ? settings.fit : 'off';

/** The model that guides: the one asked for, or what the method takes for `auto`. */
export const resolveModel = (settings: Pick<Settings, 'method' | 'model'>): 'auto' | Model =>
  settings.model === 'auto' ? methodOf(settings).autoModel : settings.model;

/** The elastic modes that guide, from 1: those asked for, all that are computed, or as many as the method takes for `auto`. */
export function resolveModes(settings: Pick<Settings, 'method' | 'modes' | 'modeCount'>): number[] {
  const { modes, modeCount } = settings;
  if (Array.isArray(modes)) return modes;
  const autoCount = Math.min(methodOf(settings).autoModes, modeCount);
  return Array.from({ length: modes === 'all' ? modeCount : autoCount }, (_, index) => index + 1);
}
