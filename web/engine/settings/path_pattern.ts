/** Patterns of paths, as batches take them: `props/**` + `/*.obj`, `*.{obj,ply}`. Paths are parted by slashes on every system. */

import { matchesPattern } from './name_pattern';

/**
 * Whether the pattern matches the whole `path`. `**` stands for any number of folders, `*` for any characters of a name or none, `?`
 * for one character, `{a,b}` for either. A pattern without a slash is compared with the file name alone, in any folder.
 */
export function matchesPath(pattern: string, path: string): boolean {
  const names = path.split('/');
  return expandBraces(pattern).some((plain) => {
    const parts = plain.replace(/^\.\//, '').split('/');
    return parts.length === 1 ? matchesPattern(parts[0], names[names.length - 1]) : agree(parts, names);
  });
}

/** Whether a word of the command line is a pattern and not a name. */
export const isPathPattern = (text: string): boolean => /[*?{]/.test(text);

/** Tracks, name by name, which parts may have been matched so far; takes time up to the product of the lengths. */
function agree(parts: string[], names: string[]): boolean {
  let open = afterFolders(parts, new Set([0]));
  for (const name of names) {
    const next = new Set<number>();
    for (const at of open) {
      if (parts[at] === '**') next.add(at);
      else if (at < parts.length && matchesPattern(parts[at], name)) next.add(at + 1);
    }
    open = afterFolders(parts, next);
  }
  return open.has(parts.length);
}

/** Adds the states that follow because `**` may stand for no folder. */
function afterFolders(parts: string[], open: Set<number>): Set<number> {
  for (const at of open) if (parts[at] === '**') open.add(at + 1);
  return open;
}

/** The most patterns that braces may expand to; nested braces are not expanded. */
const MAX_PATTERNS = 1000;

function expandBraces(pattern: string): string[] {
  const found = /\{([^{}]*)\}/.exec(pattern);
  if (!found) return [pattern];
  const [before, after] = [pattern.slice(0, found.index), pattern.slice(found.index + found[0].length)];
  const ends = expandBraces(after);
  const all = found[1].split(',').flatMap((word) => ends.map((end) => `${before}${word}${end}`));
  if (all.length > MAX_PATTERNS)
    throw new Error(`The pattern ${pattern} has more than ${MAX_PATTERNS} forms: give several patterns.`);
  return all;
}
