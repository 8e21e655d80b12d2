/** Reads files as they are; what it needs is little, so that words can be parsed before more is loaded. */

import { readFileSync, statSync } from 'node:fs';
import { UsageError } from '../failure';
import { fileError } from '../file_error';

/** Throws UsageError. */
export const readText = (path: string): string => new TextDecoder().decode(readBytes(path));

/** Throws UsageError. */
export function readBytes(path: string): Uint8Array {
  try {
    if (statSync(path).isDirectory()) throw new UsageError(`${path} is a folder: give the model file in it.`);
    return new Uint8Array(readFileSync(path));
  } catch (error) {
    throw fileError(`${path} cannot be read`, error);
  }
}
