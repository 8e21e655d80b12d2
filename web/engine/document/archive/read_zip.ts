/** Reads the files of a ZIP: a model with its companions. Declared sizes are checked before anything is unpacked. */

import { unzipSync } from 'fflate';
import type { SourceFile } from '../model';

/** The largest ratio at which deflate can compress. */
const MAX_PER_BYTE = 1032;
/** The most bytes that an archive may unpack to. */
const MAX_BYTES = 2 ** 31;
/** Entries to skip: folders, hidden files, and metadata that operating systems add. */
const IGNORED = /(^|\/)(\.[^/]*|__MACOSX|Thumbs\.db|desktop\.ini)(\/|$)|\/$/i;
/** Paths that lead out of the folder, are absolute, or are invalid. */
const ESCAPING = /(^|[/\\])\.\.([/\\]|$)|^[/\\]|^[a-z]:|\0|\\/i;

export const isZip = ({ bytes }: SourceFile): boolean =>
  bytes[0] === 0x50 && bytes[1] === 0x4b && bytes[2] === 0x03 && bytes[3] === 0x04;

/** Throws an Error with one sentence where an entry leads out of the folder or asks for more than it can hold. */
export function readZip({ name, bytes }: SourceFile): SourceFile[] {
  let [unpacked, packed] = [0, 0];
  const entries = readEntries(name, bytes, (entry) => {
    if (ESCAPING.test(entry.name))
      throw new Error(
        `${name} has a file that leads out of its folder (${excerptOf(entry.name)}): pack it again without that file.`,
      );
    if (IGNORED.test(entry.name)) return false;
    packed += entry.size;
    unpacked += entry.originalSize;
    if (packed > bytes.length || entry.originalSize > MAX_PER_BYTE * entry.size + 1024)
      throw new Error(
        `${name} declares more data than it can contain (${excerptOf(entry.name)}): pack it again.`,
      );
    if (unpacked > MAX_BYTES)
      throw new Error(`${name} unpacks to more than 2 GB: split it into several files.`);
    return true;
  });
  const files = Object.entries(entries).map(([own, content]) => ({ name: own, bytes: content }));
  if (files.length === 0) throw new Error(`${name} has no file in it: pack the model with its files.`);
  return files;
}

/** The files with archives replaced by their contents. */
export const unpacked = (files: SourceFile[]): SourceFile[] =>
  files.flatMap((file) => (isZip(file) ? readZip(file) : [file]));

interface Entry {
  name: string;
  /** bytes as packed */
  size: number;
  originalSize: number;
}

function readEntries(
  name: string,
  bytes: Uint8Array,
  isWanted: (entry: Entry) => boolean,
): Record<string, Uint8Array> {
  try {
    return unzipSync(bytes, { filter: isWanted });
  } catch (error) {
    // Errors of the library have a code.
    if (error instanceof Error && !('code' in error) && error.constructor === Error) throw error;
    throw new Error(
      `${name} is damaged, encrypted or compressed by another method than deflate: pack it again.`,
    );
  }
}

const excerptOf = (text: string): string => {
  const plain = text.replaceAll(/[^\x20-\x7e]/g, '?');
  return plain.length > 60 ? `${plain.slice(0, 57)}...` : plain;
};
