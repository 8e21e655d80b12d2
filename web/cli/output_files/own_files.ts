/**
 * Which files limber has written itself, and may replace without --force. Each format carries its mark: GLB and glTF
 * `asset.generator`, OBJ and PLY a comment of the first lines, ZIP a field of its first entry, JSON its schema as the first key.
 */

import { closeSync, openSync, readSync } from 'node:fs';
import { markOfZip } from '../../engine/document/archive/zip_mark';

/** Larger JSON inside a GLB is not read: the file then counts as another's. */
const MAX_BYTES = 1 << 26;
const HEADER_BYTES = 20;

/** Whether limber wrote the file; an empty one is nobody's and counts as well. */
export function isOwnFile(path: string): boolean {
  const file = openSync(path, 'r');
  try {
    const start = readStart(file, HEADER_BYTES);
    const jsonLength = start.length === HEADER_BYTES ? start.readUInt32LE(12) : 0;
    const isGlb = start.toString('latin1', 0, 4) === 'glTF';
    return isOwnContent(readStart(file, isGlb ? HEADER_BYTES + jsonLength : MAX_BYTES));
  } finally {
    closeSync(file);
  }
}

function readStart(file: number, bytes: number): Buffer {
  const buffer = Buffer.alloc(Math.min(bytes, MAX_BYTES));
  return buffer.subarray(0, readSync(file, buffer, 0, buffer.length, 0));
}

/** Whether bytes at the start of a file, of a GLB up to the end of its JSON, carry the mark. */
export function isOwnContent(bytes: Uint8Array): boolean {
  if (bytes.length === 0) return true;
  const text = new TextDecoder().decode(bytes);
  if (text.startsWith('glTF')) return isOwnJson(new TextDecoder().decode(bytes.subarray(HEADER_BYTES)));
  if (/^\s*\{/.test(text)) return /^\s*\{\s*"schema":\s*"limber-[a-z]+\/\d/.test(text) || isOwnJson(text);
  if (text.startsWith('PK')) return /^Limber \d/.test(markOfZip(bytes));
  return /^# Limber \d/.test(text) || /^ply\r?\nformat .*\r?\ncomment Limber \d/.test(text);
}

function isOwnJson(text: string): boolean {
  try {
    const { asset } = JSON.parse(text) as { asset?: { generator?: unknown } };
    return typeof asset?.generator === 'string' && /^Limber \d/.test(asset.generator);
  } catch {
    return false;
  }
}
