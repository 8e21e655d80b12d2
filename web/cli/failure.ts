/** Exit codes, and the line that a failure prints. */

import { OPTIONS, SettingError, wordNote, wordSentence } from '../engine/settings/options';
import type { Note, SettingName } from '../engine/settings/options';
import { inOneLine } from './words';

export const EXIT = {
  ...{ done: 0, badInput: 1, missedTarget: 2, internal: 3 },
  /** as shells call a program that SIGPIPE has ended */
  brokenPipe: 141,
} as const;

/** An error that the user can fix: a wrong flag, file or mesh. The engine throws SettingError and plain Errors for these. */
export class UsageError extends Error {}

/** The exit code and the one line for anything that was thrown. */
export function describeFailure(error: unknown): { code: number; line: string } {
  const isSentence =
    error instanceof UsageError ||
    error instanceof SettingError ||
    (error instanceof Error && error.constructor === Error);
  const line = inOneLine(messageOf(error).trim());
  if (isSentence) return { code: EXIT.badInput, line };
  return {
    code: EXIT.internal,
    line: `internal error: ${line}; please report it with the file and the command`,
  };
}

/** The name of a setting on the command line. */
export const flagOf = (setting: SettingName): string => `--${OPTIONS[setting].flag}`;

/** A note of the engine; on the command line settings are flags. */
export const inFlags = (note: Note): string => wordNote(note, flagOf);

function messageOf(error: unknown): string {
  if (error instanceof SettingError) return wordSentence(flagOf(error.setting), error.sentence, flagOf);
  return error instanceof Error ? error.message : String(error);
}
