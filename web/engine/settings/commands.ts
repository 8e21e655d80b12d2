/** Which settings each command takes. */

import { OPTIONS, SETTING_NAMES } from './table';
import type { SettingName } from './table';
import type { Command, OptionGroup } from './types';

/** Groups of which a command takes every setting; a row can name further commands. */
export const COMMAND_GROUPS: Record<Command, readonly OptionGroup[]> = {
  optimize: ['target', 'method', 'motion', 'material', 'solver', 'common'],
  tune: ['solver', 'material', 'common'],
  modes: ['motion', 'material', 'common'],
  compare: ['material', 'common'],
  simulate: ['simulation', 'material', 'common'],
  inspect: ['common'],
};

/** The settings that a command takes as flags, in the order of the table. */
export const settingsOf = (command: Command): SettingName[] =>
  SETTING_NAMES.filter(
    (name) =>
      COMMAND_GROUPS[command].includes(OPTIONS[name].group) || OPTIONS[name].commands?.includes(command),
  );
