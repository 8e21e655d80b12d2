/** Which settings each command takes. */

import { OPTIONS, SETTING_NAMES } from './table';
import type { SettingName, SettingRows, Settings } from './table';
import type { Command, OptionGroup } from './types';

const GROUPS = {
  optimize: ['target', 'method', 'motion', 'material', 'solver', 'output', 'common'],
  tune: ['solver', 'material', 'common'],
  modes: ['motion', 'material', 'common'],
  compare: ['material', 'common'],
  simulate: ['simulation', 'material', 'common'],
  inspect: ['common'],
} as const satisfies Record<Command, readonly OptionGroup[]>;

/** The groups whose settings a command takes; the row of a setting can add further commands. */
export const COMMAND_GROUPS: Record<Command, readonly OptionGroup[]> = GROUPS;

type NamedBy<Row> = Row extends { commands: readonly (infer Named)[] } ? Named : never;

type NameIfTaken<
  Name extends SettingName,
  Taker extends Command,
> = SettingRows[Name]['group'] extends (typeof GROUPS)[Taker][number]
  ? Name
  : Taker extends NamedBy<SettingRows[Name]>
    ? Name
    : never;

/** The settings that a command takes: those whose names `settingsOf` gives. */
export type CommandSettings<Taker extends Command> = Pick<
  Settings,
  { [Name in SettingName]: NameIfTaken<Name, Taker> }[SettingName]
>;

/** Defaults of a command that differ from those of the table. With qem the model `auto` stays what suits each part. */
export const COMMAND_DEFAULTS: Record<Command, Readonly<Partial<Settings>>> = {
  optimize: {},
  tune: {},
  modes: { modes: 'all', method: 'qem' },
  compare: { modeCount: 10, model: 'shell' },
  simulate: {},
  inspect: {},
};

/** The settings that a command takes as flags, in the order of the table. */
export const settingsOf = (command: Command): SettingName[] =>
  SETTING_NAMES.filter(
    (name) =>
      COMMAND_GROUPS[command].includes(OPTIONS[name].group) || OPTIONS[name].commands?.includes(command),
  );
