/** The files that a glTF names: buffers, which it cannot do without, and images. */

import type { GLTF, JSONDocument } from '@gltf-transform/core';
import { counted, excerpt } from '../../core/words';
import type { SourceFile } from '../model';

/** At most so many names stand in a sentence. */
const NAMES_SHOWN = 5;

/** An address that names a place outside of the file's own folders, or no file at all. */
const FOREIGN = /^([a-z][a-z0-9+.-]*:|[/\\])/i;

/**
 * Adds the bytes of every external buffer and image to the resources, under the address that the file gives it. Returns the
 * addresses of images that are not there: their textures stay references. Throws an Error with one sentence that names the
 * buffers that are not there.
 */
export function addCompanions(
  main: SourceFile,
  { json, resources }: JSONDocument,
  files: SourceFile[],
): string[] {
  const missing = (definitions: { uri?: string }[] | undefined): string[] => {
    const addresses = new Set((definitions ?? []).map(({ uri }) => uri).filter(isOutside));
    return [...addresses].filter((address) => {
      const companion = findCompanion(main.name, address, files);
      if (companion) resources[address] = new Uint8Array(companion.bytes);
      return !companion;
    });
  };
  const [buffers, images] = [missing(json.buffers), missing(json.images)];
  const escaping = buffers.find((address) => companionPath(main.name, address) === null);
  if (escaping !== undefined)
    throw new Error(
      `${main.name} names ${excerpt(escaping)}, which is outside of its folder and is not read: put the file beside it and name it without a path.`,
    );
  if (buffers.length === 0) return images;
  const verb = buffers.length === 1 ? 'is' : 'are';
  throw new Error(
    `${main.name} needs ${listed(buffers)}, which ${verb} not there: open the whole folder, or put them beside it.`,
  );
}

/** A note on images that are not there; none where all are. */
export function describeMissing(images: string[]): string[] {
  if (images.length === 0) return [];
  const verb = images.length === 1 ? 'is' : 'are';
  return [
    `${counted(images.length, 'texture')} (${listed(images)}) ${verb} not there or outside of the folder: the result only names ${images.length === 1 ? 'it' : 'them'}`,
  ];
}

function listed(names: string[]): string {
  const more = names.length - NAMES_SHOWN;
  return names.slice(0, NAMES_SHOWN).map(excerpt).join(', ') + (more > 0 ? ` and ${more} more` : '');
}

/** Paths below the folder of the file, of the buffers and images that it names; others are not listed. */
export function companionPaths({ buffers, images }: GLTF.IGLTF): string[] {
  const addresses = [...(buffers ?? []), ...(images ?? [])].map(({ uri }) => uri).filter(isOutside);
  const paths = addresses.map((address) => companionPath('', address));
  return [...new Set(paths.filter((path) => path !== null))];
}

/** Whether a definition names a file of its own. */
const isOutside = (uri: string | undefined): uri is string =>
  typeof uri === 'string' && uri !== '' && !/^data:/i.test(uri);

function findCompanion(main: string, uri: string, files: SourceFile[]): SourceFile | undefined {
  const path = companionPath(main, uri);
  if (path === null) return undefined;
  const baseName = path.split('/').pop();
  return (
    files.find((file) => followPath([], decoded(file.name)) === path) ??
    files.find((file) => file.name.split(/[/\\]/).pop() === baseName)
  );
}

/**
 * Resolves `uri`, percent-decoded once, against the folder of `main`; the path has forward slashes and no dot segments. Null
 * where it starts with a scheme, a drive or a slash, leaves the topmost folder that `main` names, or has a character that no
 * file name has.
 */
export function companionPath(main: string, uri: string): string | null {
  const address = decoded(uri);
  if (FOREIGN.test(address) || address.includes('\0')) return null;
  return followPath(main.split(/[/\\]/).slice(0, -1), address);
}

/** A % that starts no escape sequence is a character of the name. */
function decoded(uri: string): string {
  try {
    return decodeURIComponent(uri);
  } catch {
    return uri;
  }
}

function followPath(folder: string[], address: string): string | null {
  const path: string[] = [];
  for (const part of [...folder, ...address.split(/[/\\]/)]) {
    if (part === '..') {
      if (path.length === 0) return null;
      path.pop();
    } else if (part !== '.' && part !== '') path.push(part);
  }
  return path.length > 0 ? path.join('/') : null;
}
