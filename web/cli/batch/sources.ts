/** Which models a batch is about, and what they are called below SRC. */

import { existsSync, readdirSync, realpathSync, statSync } from 'node:fs';
import type { Stats } from 'node:fs';
import { basename, dirname, join, relative, sep } from 'node:path';
import { isModelName } from '../../engine/document/format_names';
import { isPathPattern, matchesPath } from '../../engine/settings/path_pattern';
import { UsageError } from '../failure';
import { fileError } from '../file_error';
import { findAt, identityOf, nameKey } from '../output_files/identity';

export interface Source {
  /** its path below SRC, parted by slashes: what patterns of a configuration and the summary call it */
  name: string;
  path: string;
  bytes: number;
}

/**
 * The models of all words: folders, patterns and files. Hidden files and folders, and all below `out`, are left out. In the order
 * of their names, each file once under each name. Throws UsageError where a word has none, or two would have one name.
 */
export function findSources(words: string[], out: string): Source[] {
  const all = words.flatMap((word) => {
    const found = sourcesOf(word, out);
    if (found.length === 0)
      throw new UsageError(`${word} has no model: name a folder, pattern or file of models.`);
    return found;
  });
  const sorted = eachOnce(all.sort((a, b) => (a.name < b.name ? -1 : Number(a.name > b.name))));
  const twice = sorted.findIndex((source, i) => i > 0 && source.name === sorted[i - 1].name);
  if (twice < 0) return sorted;
  const [a, b] = [sorted[twice - 1], sorted[twice]];
  throw new UsageError(`${a.path} and ${b.path} are both ${a.name} below SRC: process them in two batches.`);
}

/** Several words can lead to one file. */
const eachOnce = (sorted: Source[]): Source[] =>
  sorted.filter(({ name, path }, i) => {
    const before = sorted[i - 1] as Source | undefined;
    return before?.name !== name || identityOf(before.path) !== identityOf(path);
  });

function sourcesOf(word: string, out: string): Source[] {
  // A file can be called like a pattern.
  const found = findAt(word);
  if (found?.isDirectory()) return walk(word, out).map((path) => sourceOf(word, path));
  if (found) return [sourceOf(dirname(word), word)];
  if (!isPathPattern(word)) throw new UsageError(`${word} does not exist: name a folder, pattern or file.`);
  const { base, pattern } = parted(word);
  if (!existsSync(base)) throw new UsageError(`${word} has no model: the folder ${base} does not exist.`);
  if (existsSync(out) && realpathSync(base) === realpathSync(out))
    throw new UsageError(`${out} is also the folder of ${word}: choose another folder for the results.`);
  // A pattern of one part is about its own folder, not about all below.
  const isFlat = !pattern.includes('/');
  return walk(base, out)
    .map((path) => sourceOf(base, path))
    .filter(({ name }) => matchesPath(pattern, name) && !(isFlat && name.includes('/')));
}

/** The folders before the first wildcard of a pattern, and the rest, which is about paths below them. */
function parted(word: string): { base: string; pattern: string } {
  const parts = word.split('/');
  const first = parts.findIndex(isPathPattern);
  const base = parts.slice(0, first).join('/') || (word.startsWith('/') ? '/' : '.');
  return { base, pattern: parts.slice(first).join('/') };
}

const sourceOf = (folder: string, path: string): Source => ({
  name: relative(folder, path).split(sep).join('/') || basename(path),
  path,
  bytes: statSync(path).size,
});

/** Paths of all models in a folder; links are followed, and each folder is entered once. */
function walk(folder: string, out: string, entered = new Set<string>()): string[] {
  const real = realpathSync(folder);
  if (entered.has(real) || (existsSync(out) && real === realpathSync(out))) return [];
  entered.add(real);
  return namesIn(folder)
    .filter((name) => !name.startsWith('.'))
    .sort()
    .flatMap((name) => {
      const path = join(folder, name);
      const found = statOf(path);
      if (found?.isDirectory()) return walk(path, out, entered);
      return found?.isFile() && isModelName(name) ? [path] : [];
    });
}

/** Throws UsageError. */
function namesIn(folder: string): string[] {
  try {
    return readdirSync(folder);
  } catch (error) {
    throw fileError(`${folder} cannot be read`, error);
  }
}

/** Undefined where a link leads nowhere, or back to itself. Throws UsageError where the system cannot look there. */
function statOf(path: string): Stats | undefined {
  try {
    return statSync(path, { throwIfNoEntry: false });
  } catch (error) {
    if ((error as NodeJS.ErrnoException).code === 'ELOOP') return undefined;
    throw fileError(`${path} cannot be reached`, error);
  }
}

/** An asset: a source and what its result is called below OUT. */
export interface Asset extends Source {
  result: string;
}

/**
 * Results have the ending of `endingOf`, without its dot; where two would have one name, each keeps that of its source, too:
 * chair.obj.glb.
 */
export function assetsOf(
  sources: Source[],
  endingOf: (name: string) => string = () => 'glb',
  platform: NodeJS.Platform = process.platform,
): Asset[] {
  const kept = namesThatCollide(sources, platform);
  return sources.map((source) => ({
    ...source,
    result: `${stemOf(source.name, kept)}.${endingOf(source.name)}`,
  }));
}

/** What a result is called before its ending. `kept`: the names that keep their own. */
const stemOf = (name: string, kept: ReadonlySet<string>): string =>
  kept.has(name) ? name : name.replace(/\.[^./]*$/, '');

/** The names whose results would have one name. One that keeps its ending can in turn be another's without its own. */
function namesThatCollide(sources: Source[], platform: NodeJS.Platform): ReadonlySet<string> {
  const kept = new Set<string>();
  for (let known = -1; known < kept.size;) {
    known = kept.size;
    const stems = sources.map(({ name }) => nameKey(stemOf(name, kept), platform));
    const first = new Map<string, string>();
    sources.forEach(({ name }, i) => {
      const other = first.get(stems[i]) ?? name;
      first.set(stems[i], other);
      if (other !== name) kept.add(name).add(other);
    });
  }
  return kept;
}
