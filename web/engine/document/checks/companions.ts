/** The files that a glTF names: buffers, which it needs, and images. */

import type { GLTF, JSONDocument } from '@gltf-transform/core';
import { counted, excerpt } from '../../core/words';
import type { SourceFile } from '../model';

/** The most names that a sentence lists. */
const NAMES_SHOWN = 5;

/** An address outside of the file's own folders, or of no file. */
const FOREIGN = /^([a-z][a-z0-9+.-]*:|[/\\])/i;

/**
 * Adds the bytes of every external buffer and image to the resources, under the address that the file gives it. Returns the
 * addresses of missing images: their textures stay references. Throws an Error with one sentence that names the
 * missing buffers.
 */
export function addCompanions(
  main: SourceFile,
  { json, resources }: JSONDocument,
  files: SourceFile[],
): string[] {
  const found = findCompanions(main.name, [...addressesOf(json.buffers), ...addressesOf(json.images)], files);
  for (const [address, { bytes }] of found) resources[address] = new Uint8Array(bytes);
  const missing = (definitions: Definitions): string[] =>
    addressesOf(definitions).filter((address) => !found.has(address));
  const [buffers, images] = [missing(json.buffers), missing(json.images)];
  const escaping = buffers.find((address) => companionPath(main.name, address) === null);
  if (escaping !== undefined)
    throw new Error(
      `${main.name} refers to ${excerpt(escaping)}, which is outside its folder and is therefore not read: put the file beside it and refer to it without a path.`,
    );
  if (buffers.length === 0) return images;
  const verb = buffers.length === 1 ? 'is' : 'are';
  throw new Error(
    `${main.name} needs ${listed(buffers)}, which ${verb} missing: open the whole folder, or put the missing files beside it.`,
  );
}

/** A note on missing images; none without any. */
export function describeMissing(images: string[]): string[] {
  if (images.length === 0) return [];
  const verb = images.length === 1 ? 'is' : 'are';
  return [
    `${counted(images.length, 'texture')} (${listed(images)}) ${verb} missing or outside the folder: the result only refers to ${images.length === 1 ? 'it' : 'them'}`,
  ];
}

function listed(addresses: string[]): string {
  const more = addresses.length - NAMES_SHOWN;
  return addresses.slice(0, NAMES_SHOWN).map(shownAddress).join(', ') + (more > 0 ? ` and ${more} more` : '');
}

/** The name of the file at an address, as a folder shows it; the address itself where that has control characters. */
const shownAddress = (address: string): string =>
  excerpt(/\p{Cc}/u.test(decoded(address)) ? address : decoded(address));

/** Paths below the folder of the file, of the buffers and images that it names; others are not listed. */
export function companionPaths({ buffers, images }: GLTF.IGLTF): string[] {
  const paths = [...addressesOf(buffers), ...addressesOf(images)].map((address) =>
    companionPath('', address),
  );
  return [...new Set(paths.filter((path) => path !== null))];
}

type Definitions = { uri?: string }[] | undefined;

/** Addresses of files, each once. */
const addressesOf = (definitions: Definitions): string[] => [
  ...new Set((definitions ?? []).map(({ uri }) => uri).filter(isOutside)),
];

/** Whether a definition refers to a separate file. */
const isOutside = (uri: string | undefined): uri is string =>
  typeof uri === 'string' && uri !== '' && !/^data:/i.test(uri);

/**
 * Per address the file at its path; otherwise a file of that name without a folder, as files that are dropped one by
 * one have none, unless it is at the path of another address.
 */
function findCompanions(main: string, addresses: string[], files: SourceFile[]): Map<string, SourceFile> {
  const found = new Map<string, SourceFile>();
  const lacking = addresses.filter((address) => {
    const path = companionPath(main, address);
    const file = path === null ? null : fileNamed(path, files);
    if (file) found.set(address, file);
    return !file;
  });
  const meant = new Set(found.values());
  for (const address of lacking) {
    const baseName = companionPath(main, address)?.split('/').pop();
    const file = files.find((one) => decoded(one.name) === baseName && !meant.has(one));
    if (file) found.set(address, file);
  }
  return found;
}

/** The file of this name; otherwise one with a percent-encoded name, as some programs write them. */
const fileNamed = (path: string, files: SourceFile[]): SourceFile | undefined =>
  files.find(({ name }) => followPath([], name) === path) ??
  files.find(({ name }) => followPath([], decoded(name)) === path);

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
