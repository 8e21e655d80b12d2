/** Which file a path leads to: by device and inode where it exists, since names can differ and links can lead there. */

import { existsSync, lstatSync, readlinkSync, realpathSync, statSync } from 'node:fs';
import type { BigIntStats, Stats } from 'node:fs';
import { basename, dirname, join, resolve } from 'node:path';
import { UsageError } from '../failure';
import { fileError } from '../file_error';

/** As many links in a row as Linux follows. */
const MAX_LINKS = 40;

/** The path that writing to `path` has to replace: that of the file at the end of its links, which need not exist yet. */
export function followLinks(path: string): string {
  let end = resolve(path);
  for (let links = 0; isLink(end); ++links) {
    if (links === MAX_LINKS) throw new UsageError(`${path} is a link that leads back to itself: remove it.`);
    end = resolve(dirname(end), readlinkSync(end));
  }
  // What the link of an open pipe says, as /dev/stdout is one, is no path.
  return !existsSync(end) && isSpecial(path) ? resolve(path) : end;
}

function isLink(path: string): boolean {
  return reached(path, () => lstatSync(path, { throwIfNoEntry: false }))?.isSymbolicLink() ?? false;
}

/** What is at a path, all links followed; undefined where nothing is. Throws UsageError where the system cannot look there. */
export const findAt = (path: string): Stats | undefined =>
  reached(path, () => statSync(path, { throwIfNoEntry: false }));

function reached<Found>(path: string, look: () => Found): Found {
  try {
    return look();
  } catch (error) {
    throw fileError(`${path} cannot be reached`, error);
  }
}

/** Equal for two paths just where they lead to the same file, or would do once it exists. Its folder has to exist. */
export function identityOf(path: string): string {
  const end = followLinks(path);
  const found = statSync(end, { bigint: true, throwIfNoEntry: false });
  if (found) return keyOf(found, end);
  const folder = dirname(end);
  return `${keyOf(statSync(folder, { bigint: true }), folder)}/${nameKey(basename(end), process.platform)}`;
}

/** Some file systems of Windows have no inodes. */
const keyOf = ({ dev, ino }: BigIntStats, path: string): string =>
  ino === 0n ? nameKey(realpathSync(path), process.platform) : `${dev}:${ino}`;

/** File names of Windows and macOS are the same in either case, and in either form of Unicode. */
export const nameKey = (name: string, platform: NodeJS.Platform): string =>
  platform === 'win32' || platform === 'darwin' ? name.normalize('NFC').toLowerCase() : name;

/** Whether the file that `path` leads to lies in or below one of the folders, all links followed. */
export function isWithin(path: string, folders: string[]): boolean {
  const real = realpathSync(path);
  return folders.some((folder) => real.startsWith(join(realpathSync(folder), '/')));
}

/** Whether it is a device or pipe, such as /dev/null, which is written to and never replaced. */
export function isSpecial(path: string): boolean {
  const found = statSync(path, { throwIfNoEntry: false });
  return found !== undefined && !found.isFile() && !found.isDirectory();
}
