/** What an error may say: a sentence for the user, and nothing of the program itself. */

const CODE =
  /undefined|is not a function|is not iterable|Cannot |TypeError|RangeError|Invalid typed array|Invalid array length(?! \d)|out of bounds|\[object|=>|Unexpected token|\bat position\b|offset is out|Maximum call stack|internal error/;
const MAX_LETTERS = 700;

/** What is wrong with an error as the answer to bad input; null if it is a good one. */
export function problemOfRefusal(error: unknown): string | null {
  if (!(error instanceof Error)) return `threw ${String(error)}`;
  // The names of errors that the program makes for its users itself.
  if (!['Error', 'UsageError', 'SettingError'].includes(error.constructor.name)) return String(error.stack);
  const own = error.message.replace(/"[^"]*"/g, '""');
  if (CODE.test(own)) return `speaks of the program: ${error.message}`;
  if (!/[.?]$/.test(error.message)) return `is no sentence: ${error.message}`;
  if (error.message.length > MAX_LETTERS) return `is longer than ${MAX_LETTERS} letters: ${error.message}`;
  return null;
}
