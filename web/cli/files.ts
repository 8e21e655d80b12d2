/** Files of the command line: a model with its companions in, whole files out. */

import {
  chmodSync,
  existsSync,
  mkdirSync,
  realpathSync,
  renameSync,
  rmSync,
  statSync,
  writeFileSync,
} from 'node:fs';
import { basename, dirname, join } from 'node:path';
import { companionNames } from '../engine/document/gltf';
import type { SourceFile } from '../engine/document/open';
import { fileError } from './file_error';
import { readBytes } from './input_files/read_file';
import { objCompanions } from './input_files/obj_companions';
import { followLinks, isSpecial, isWithin } from './output_files/identity';
import { partialOf, removeStalePartials } from './output_files/partial_files';
import { readStandard, STANDARD } from './standard';

/** A model and what belongs to it. */
export interface ModelFiles {
  files: SourceFile[];
  /** paths of the model and of all that it names, read or not: nothing may be written over them */
  paths: string[];
}

/**
 * The model file; for a glTF or an OBJ also the files that it names, as far as they exist in its folder. `from`: the format of stdin, null
 * where its bytes tell. `carries`: whether an OBJ comes with all pictures of its libraries, as they are written again, and not with those of
 * its materials alone. Throws UsageError.
 */
export async function readModelFiles(
  path: string,
  from: string | null = null,
  carries = false,
): Promise<ModelFiles> {
  // A model from a pipe has no folder.
  if (path === STANDARD)
    return {
      files: [{ name: from === null ? 'stdin' : `stdin.${from}`, bytes: await readStandard(process.stdin) }],
      paths: [],
    };
  const main = { name: basename(path), bytes: readBytes(path) };
  // A link may stand beside links to the companions, or lead to where the companions are.
  const folders = [dirname(path), dirname(realpathSync(path))];
  const companions = companionNames(main)
    .map((name) => ({ name, path: join(dirname(path), name) }))
    .filter((companion) => existsSync(companion.path) && isWithin(companion.path, folders))
    .map((companion) => ({ ...companion, bytes: readBytes(companion.path) }));
  const { read, pictures, named } = objCompanions(path, main, folders);
  const all = carries ? [...new Set([...read, ...pictures])] : read;
  const ofObj = all.map((name) => ({ name, bytes: readBytes(join(dirname(path), name)) }));
  return {
    files: [main, ...companions.map(({ name, bytes }) => ({ name, bytes })), ...ofObj],
    paths: [
      path,
      ...companions.map((companion) => companion.path),
      ...read.map((name) => join(dirname(path), name)),
      ...named,
    ],
  };
}

/** Paths of the files that the model file at `path` names, of a material library also its pictures. */
export function pathsNamedBy(path: string): string[] {
  const main = { name: basename(path), bytes: readBytes(path) };
  const ofGltf = companionNames(main).map((name) => join(dirname(path), name));
  return [...ofGltf, ...objCompanions(path, main, [dirname(path)]).named];
}

/** Makes a folder with those above it, unless it is there. */
export function makeFolder(path: string): void {
  try {
    mkdirSync(path, { recursive: true });
  } catch (error) {
    throw fileError(`${path} cannot be created`, error);
  }
}

/**
 * Writes all or nothing: into a file in the same folder, which then takes the place of `path` and its permissions. A link
 * stays, and the file that it leads to is replaced; a device or pipe is written to.
 */
export function writeWhole(path: string, content: Uint8Array | string): void {
  const end = followLinks(path);
  const partial = partialOf(end);
  try {
    if (isSpecial(end)) {
      writeFileSync(end, content);
      return;
    }
    removeStalePartials(dirname(end));
    const old = statSync(end, { throwIfNoEntry: false });
    writeFileSync(partial, content);
    if (old) chmodSync(partial, old.mode & 0o7777);
    renameSync(partial, end);
  } catch (error) {
    rmSync(partial, { force: true });
    throw fileError(`${path} cannot be written`, error);
  }
}
