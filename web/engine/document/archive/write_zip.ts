/** Packs the files of a result into a ZIP. The same files give the same bytes. */

import { zipSync } from 'fflate';
import type { Zippable } from 'fflate';
import type { SourceFile } from '../model';
import { MARK_FIELD } from './zip_mark';

/** The earliest date that a ZIP can name, in any time zone. */
const NO_DATE = new Date(1980, 0, 1);
/** Files that are compressed already. */
const PACKED = /\.(png|jpe?g|webp|ktx2|avif)$/i;

export function writeZip(files: SourceFile[], mark: string): Uint8Array {
  const entries: Zippable = {};
  files.forEach(({ name, bytes }, i) => {
    const extra = i === 0 ? { extra: { [MARK_FIELD]: new TextEncoder().encode(mark) } } : {};
    entries[name] = [bytes, { level: PACKED.test(name) ? 0 : 6, mtime: NO_DATE, ...extra }];
  });
  return zipSync(entries);
}
