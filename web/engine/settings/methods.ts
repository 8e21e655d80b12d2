/** What is particular to each method of simplification. No other file asks which method it is. */

import type { Method, Model } from '../core/core';
import { OPTIONS, SETTING_NAMES } from './table';
import type { SettingName, Settings } from './table';

export interface MethodSpec {
  /** Settings that start with other values than the table's. */
  defaults: Partial<Settings>;
  /** Settings that this method reads and some other does not. */
  reads: readonly SettingName[];
  /** The strain of the guiding modes enters the cost of a collapse, so modes are found first. */
  needsGuidance: boolean;
  /** Curvature enters the cost of a collapse. */
  needsCurvature: boolean;
  /** The result can be fitted to the modes of the original. */
  canFit: boolean;
  /** Seams and borders of materials stay closed, and attributes enter the cost of a collapse. */
  keepsAttributes: boolean;
  /** what the model `auto` stands for */
  autoModel: 'auto' | Model;
  /** how many modes guide where they are `auto` */
  autoModes: number;
}

const METHOD_TABLE: Record<Method, MethodSpec> = {
  limber: {
    defaults: {},
    reads: ['strainWeight', 'qualityWeight', 'sizeWeight', 'fit', 'seams'],
    needsGuidance: true,
    needsCurvature: false,
    canFit: true,
    keepsAttributes: true,
    autoModel: 'auto',
    autoModes: 6,
  },
  /** as printed: Eq. 11, guided by the first mode of the Laplacian */
  paper: {
    defaults: { strainWeight: 0.05, curvatureWeight: 1, qualityWeight: 0.01, sizeWeight: 0 },
    reads: ['strainWeight', 'curvatureWeight', 'qualityWeight'],
    needsGuidance: true,
    needsCurvature: true,
    canFit: false,
    keepsAttributes: false,
    autoModel: 'laplacian',
    autoModes: 1,
  },
  qem: {
    defaults: { sizeWeight: 0 },
    reads: ['sizeWeight', 'seams'],
    needsGuidance: false,
    needsCurvature: false,
    canFit: false,
    keepsAttributes: true,
    autoModel: 'auto',
    autoModes: 6,
  },
};

/** Settings that not every method reads. */
const PARTICULAR = new Set(Object.values(METHOD_TABLE).flatMap(({ reads }) => reads));

/** What is particular to the method of these settings. */
export const methodOf = ({ method }: Pick<Settings, 'method'>): MethodSpec => METHOD_TABLE[method];

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
  const names = Object.values(METHOD_TABLE).flatMap((spec) => Object.keys(spec.defaults) as SettingName[]);
  return { method, ...Object.fromEntries(names.map((name) => [name, defaults[name]])) };
}

/** The defaults of the settings that name parts of one file. */
export function fileDefaults(): Partial<Settings> {
  const defaults = defaultSettings();
  const names = SETTING_NAMES.filter((name) => OPTIONS[name].isOfFile);
  return Object.fromEntries(names.map((name) => [name, defaults[name]]));
}

/** Whether results are fitted to the original's modes. */
export const isFitted = (settings: Pick<Settings, 'method' | 'fit'>): boolean =>
  methodOf(settings).canFit && settings.fit === 'on';

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
