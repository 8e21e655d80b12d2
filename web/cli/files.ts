/** Files of the command line: a model with its companions in, whole files out. */

import { existsSync, readFileSync, renameSync, rmSync, statSync, writeFileSync } from 'node:fs';
import { basename, dirname, join, resolve } from 'node:path';
import { companionNames } from '../engine/document/gltf';
import type { SourceFile } from '../engine/document/open';
import { UsageError } from './failure';

/** The model file; for a glTF also the files that it names, as far as they exist. Throws UsageError. */
export function readModelFiles(path: string): SourceFile[] {
  const main = { name: basename(path), bytes: readBytes(path) };
  const companions = companionNames(main)
    .map((name) => ({ name, path: join(dirname(path), name) }))
    .filter((companion) => existsSync(companion.path))
    .map((companion) => ({ name: companion.name, bytes: readBytes(companion.path) }));
  return [main, ...companions];
}

/** Throws UsageError. */
export const readText = (path: string): string => new TextDecoder().decode(readBytes(path));

function readBytes(path: string): Uint8Array {
  try {
    if (statSync(path).isDirectory()) throw new UsageError(`${path} is a folder: name the model file in it.`);
    return new Uint8Array(readFileSync(path));
  } catch (error) {
    throw fileError(`${path} cannot be read`, error);
  }
}

/** Throws UsageError where the output could not be written, before any work is done. */
export function checkOutput(path: string, input: string): void {
  if (!path.toLowerCase().endsWith('.glb'))
    throw new UsageError(`${path} is not a .glb: GLB is what can be written, so let the name end in .glb.`);
  if (resolve(path) === resolve(input))
    throw new UsageError(`${path} is also the input: choose another name.`);
  checkFolder(path);
}

export function checkFolder(path: string): void {
  const folder = dirname(path);
  if (!existsSync(folder)) throw new UsageError(`The folder ${folder} does not exist: make it first.`);
  if (existsSync(path) && statSync(path).isDirectory())
    throw new UsageError(`${path} is a folder: name a file.`);
}

/** Writes all or nothing: into a file in the same folder, which is then renamed to `path`. */
export function writeWhole(path: string, content: Uint8Array | string): void {
  const partial = join(dirname(path), `.${basename(path)}.${process.pid}.part`);
  try {
    writeFileSync(partial, content);
    renameSync(partial, path);
  } catch (error) {
    rmSync(partial, { force: true });
    throw fileError(`${path} cannot be written`, error);
  }
}

const REASONS: Record<string, string> = {
  ENOENT: 'there is no such file',
  EACCES: 'permission is denied',
  EPERM: 'permission is denied',
  ENOSPC: 'the disk is full',
  EROFS: 'the disk is read-only',
  ERR_FS_FILE_TOO_LARGE: 'it is larger than 2 GB',
};

function fileError(what: string, error: unknown): Error {
  if (error instanceof UsageError) return error;
  const { code, message } = error as NodeJS.ErrnoException;
  return new UsageError(`${what}: ${REASONS[code ?? ''] ?? message}.`);
}
