/** What other folders may import of the settings; the forms of texts are in pin_text.ts, paint_text.ts, collider_text.ts and engine_text.ts. */

export { checkAllUsed, checkSetting, checkSettings, SOLVER_SETTINGS } from './check';
export { COMMAND_DEFAULTS, settingsOf } from './commands';
export type { CommandSettings } from './commands';
export { SettingError, wordNote, wordSentence } from './errors';
export type { Note, Sentence } from './errors';
export {
  defaultSettings,
  fileDefaults,
  fileSettings,
  fitOf,
  methodChange,
  methodOf,
  modelDefaults,
  readsSetting,
  resolveModel,
  resolveModes,
  withPerson,
} from './methods';
export { OPTIONS, SETTING_NAMES } from './table';
export type { SettingName, Settings } from './table';
export { COMMANDS } from './types';
export type { Command, OptionOf, OptionSpec, PageSection } from './types';
