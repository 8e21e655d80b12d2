/** Images of a document as files or buffer views: equal ones once, under names inside the folder. */

import type { Document, Texture } from '@gltf-transform/core';
import { ImageUtils } from '@gltf-transform/core';
import { companionPath } from '../checks/companions';

/** Per texture with bytes, the first one with the same bytes and type; itself where it is the first. */
export function firstWithBytes(document: Document): Map<Texture, Texture> {
  const firsts: Texture[] = [];
  return new Map(
    document
      .getRoot()
      .listTextures()
      .filter((texture) => texture.getImage())
      .map((texture) => {
        const first = firsts.find((other) => isSame(texture, other));
        if (!first) firsts.push(texture);
        return [texture, first ?? texture] as const;
      }),
  );
}

function isSame(a: Texture, b: Texture): boolean {
  const [x, y] = [a.getImage()!, b.getImage()!];
  if (x.length !== y.length || a.getMimeType() !== b.getMimeType()) return false;
  return x === y || x.every((byte, i) => byte === y[i]);
}

/**
 * The name of each texture's file, beside a main file with this stem: the address that it came from where that is a path below the
 * folder, otherwise made from the stem and its own name. Equal bytes have one name.
 */
export function imageNames(document: Document, stem: string): Map<Texture, string> {
  const names = new Map<Texture, string>();
  const taken = new Set<string>();
  for (const [texture, first] of firstWithBytes(document)) {
    const known = names.get(first);
    const name = known ?? uniqueName(texture, stem, taken);
    taken.add(name.toLowerCase());
    names.set(texture, name);
  }
  return names;
}

/** A file beside a written model. */
export interface Companion {
  name: string;
  /** the bytes of a picture or library that is copied from the input; null: the file is generated */
  bytes: Uint8Array | null;
}

/** The pictures under their names, each once. */
export function imageFiles(document: Document, stem: string): Companion[] {
  const files = new Map<string, Uint8Array>();
  for (const [texture, name] of imageNames(document, stem)) files.set(name, texture.getImage()!);
  return [...files].map(([name, bytes]) => ({ name, bytes }));
}

function uniqueName(texture: Texture, stem: string, taken: Set<string>): string {
  const own = texture.getURI() === '' ? null : companionPath('', texture.getURI());
  if (own !== null && !taken.has(own.toLowerCase())) return own;
  const ending = ImageUtils.mimeTypeToExtension(texture.getMimeType()) || 'bin';
  const word = texture
    .getName()
    .replace(/\.[a-z0-9]{1,5}$/i, '')
    .replaceAll(/[^\p{L}\p{N}_-]+/gu, '_')
    .slice(0, 60);
  for (let number = 0; ; ++number) {
    const parts = [stem, word, ...(word === '' || number > 0 ? [String(number)] : [])];
    const name = `${parts.filter((part) => part !== '').join('_')}.${ending}`;
    if (!taken.has(name.toLowerCase())) return name;
  }
}

/** The address in a glTF of a file with this name. */
export const addressOf = (name: string): string =>
  name
    .split('/')
    .map((part) => encodeURIComponent(part))
    .join('/');
