/** The request for each asset: the configuration and the flags as arguments of limber optimize. */

import { join } from 'node:path';
import { MATERIALS } from '../../engine/settings/materials';
import { settingsOfPreset } from '../../engine/settings/presets';
import { OPTIONS, checkSettings, settingsOf } from '../../engine/settings/options';
import type { SettingName } from '../../engine/settings/options';
import { optionsFor, settingsFor } from '../../engine/settings/batch_config';
import type { AssetOptions, BatchConfig } from '../../engine/settings/batch_config';
import { checkForm, outputForm } from '../../engine/document/write/output_form';
import type { Arguments } from '../arguments';
import { describeFailure, UsageError } from '../failure';
import { describeYielded } from '../output_files/preset_compression';
import { sentenceOn } from './progress';
import { assetsOf } from './sources';
import type { Asset, Source } from './sources';

/** The options from the flags of the command line and its presets. */
export function optionsOfFlags(args: Arguments): AssetOptions {
  const { asked, settings, faces, ratio, batch } = args;
  const ofPresets = namesOfPresets(args);
  const names = settingsOf('optimize').filter(
    (name) => !OPTIONS[name].isOfMachine && (asked.has(OPTIONS[name].flag) || ofPresets.includes(name)),
  );
  const switches = {
    soft: args.soft,
    fields: args.fields,
    reports: batch.reports,
    bindings: batch.bindings,
    settingsFiles: batch.settingsFiles,
    frequencies: batch.frequencies,
  };
  return {
    ...Object.fromEntries(names.map((name) => [name, settings[name]])),
    ...(faces !== null ? { faces } : {}),
    ...(ratio !== null ? { ratio } : {}),
    ...Object.fromEntries(Object.entries(switches).filter(([, isOn]) => isOn)),
  };
}

/** The settings that have their values from --preset or --material-preset alone. */
function namesOfPresets({ asked, preset }: Arguments): SettingName[] {
  const names = [
    ...(asked.has('material-preset') ? Object.keys(MATERIALS.rubber) : []),
    ...(preset ? Object.keys(settingsOfPreset(preset)) : []),
  ] as SettingName[];
  return names.filter((name) => !asked.has(OPTIONS[name].flag));
}

export interface AssetRequest {
  asset: Asset;
  options: AssetOptions;
  /** options that only a preset sets, not the user by name: a limit among them is no target */
  fromPreset: SettingName[];
}

/**
 * The request of every source; `notes`: what of a preset gives way. Throws SettingError or UsageError where settings that are allowed each
 * do not go together.
 */
export function requestsOf(
  config: BatchConfig,
  args: Arguments,
  sources: Source[],
): { requests: AssetRequest[]; notes: string[] } {
  const flags = optionsOfFlags(args);
  const ofPresets = namesOfPresets(args);
  const notes = new Set<string>();
  const asked = new Map(
    sources.map(({ name }) => {
      const named = optionsFor(config, name, {});
      const fromPreset = ofPresets.filter((one) => named[one] === undefined);
      const options = optionsFor(config, name, flags);
      const note = fromPreset.includes('compress') ? noteOnCompression(options, args) : null;
      if (note === null) return [name, { options, fromPreset }];
      notes.add(note);
      return [name, { options: { ...options, compress: undefined }, fromPreset }];
    }),
  );
  checkOptions(new Map([...asked].map(([name, { options }]) => [name, options])));
  const assets = assetsOf(sources, (name) => endingOf(asked.get(name)!.options));
  return { requests: assets.map((asset) => ({ asset, ...asked.get(asset.name)! })), notes: [...notes] };
}

/** What is said where the compression of a preset gives way; null: it does not. */
function noteOnCompression(options: AssetOptions, { preset }: Arguments): string | null {
  const { format } = outputForm(`.${endingOf(options)}`, 'auto', 'glb');
  return describeYielded(format, settingsFor(options), preset);
}

/** Throws where settings of an asset do not go together, or its format cannot have them. Each combination is looked at once. */
function checkOptions(optionsOf: Map<string, AssetOptions>): void {
  const distinct = new Map(
    [...optionsOf].map(([name, options]) => [JSON.stringify(options), { name, options }]),
  );
  for (const { name, options } of distinct.values())
    try {
      const settings = settingsFor(options);
      checkSettings(settings);
      checkForm(outputForm(`.${endingOf(options)}`, settings.format, 'glb'), {
        compression: settings.compress,
        style: settings.lodStyle,
        levels: settings.lods.length,
      });
    } catch (error) {
      // Where all have the same options, no asset is to blame.
      throw distinct.size === 1 ? error : new UsageError(sentenceOn(name, describeFailure(error).line));
    }
}

/** The ending of a result: GLB, unless another format is asked for. */
function endingOf(options: AssetOptions): string {
  const { format = 'auto' } = options as { format?: string };
  return format === 'auto' ? 'glb' : format;
}

/** An asset as it is given to limber optimize. `out`: the folder of the results. */
export function argumentsFor(
  args: Arguments,
  { asset, options, fromPreset }: AssetRequest,
  { out, threads }: { out: string; threads: number },
): Arguments {
  const result = join(out, asset.result);
  const beside = (ending: string) => result.replace(/\.[^./\\]*$/, `.${ending}.json`);
  const settings = { ...settingsFor(options), threads };
  const given = settingsOf('optimize').filter(
    (name) => options[name] !== undefined && !fromPreset.includes(name),
  );
  return {
    ...args,
    command: 'optimize',
    operands: [asset.path, result],
    settings,
    formerWords: [],
    faces: options.faces ?? null,
    ratio: options.ratio ?? null,
    fields: options.fields ?? false,
    soft: options.soft ?? false,
    bind: options.bindings ? beside('bind') : null,
    settingsFile: options.settingsFiles && settings.solver !== 'none' ? beside('settings') : null,
    reports: options.reports ? [beside('report')] : [],
    asked: new Set(given.map((name) => OPTIONS[name].flag)),
    quiet: true,
  };
}
