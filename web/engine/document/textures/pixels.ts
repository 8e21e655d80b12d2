/** The pixels of textures, for what depends on how they look. PNG alone. */

import type { Document, Texture } from '@gltf-transform/core';
import type { Pixels } from './png';

/** What is decoded of a file, at most: so many pixels take 0.1 to 0.2 seconds of a processor. */
export const MOST_PIXELS = 1 << 20;

type Png = typeof import('./png');

let png: Png | null = null;
const chosenOf = new WeakMap<Document, Set<Texture>>();
const known = new WeakMap<Uint8Array, Pixels | null>();

/** Loads the decoder if a document has textures; `pixelsOf` finds nothing before. The page loads it with the first such file. */
export async function loadDecoder(document: Document): Promise<void> {
  if (document.getRoot().listTextures().length > 0) png ??= await import('./png').catch(() => null);
}

/**
 * Null if one of the textures of a document is broken, no PNG that can be decoded, or not among those that are decoded: the smallest of
 * the file, as long as they have no more than MOST_PIXELS together.
 */
export function pixelsOf(document: Document, textures: Texture[]): Pixels[] | null {
  if (!png) return null;
  const { decodePng, sizeOfPng } = png;
  if (!chosenOf.has(document))
    chosenOf.set(document, chosenAmong(document.getRoot().listTextures(), sizeOfPng));
  if (!textures.every((texture) => chosenOf.get(document)!.has(texture))) return null;
  const pixels = textures.map((texture) => decodedOnce(texture.getImage()!, decodePng));
  return pixels.every((one) => one !== null) ? pixels : null;
}

function chosenAmong(textures: Texture[], sizeOfPng: Png['sizeOfPng']): Set<Texture> {
  const sized = textures.map((texture) => {
    const [width, height] = sizeOfPng(texture.getImage() ?? new Uint8Array()) ?? [Infinity, 1];
    return { texture, count: width * height };
  });
  let room = MOST_PIXELS;
  return new Set(
    sized
      .sort((a, b) => (a.count === b.count ? 0 : a.count - b.count))
      .filter(({ count }) => (room -= count) >= 0)
      .map(({ texture }) => texture),
  );
}

function decodedOnce(image: Uint8Array, decodePng: Png['decodePng']): Pixels | null {
  if (!known.has(image)) known.set(image, decoded(image, decodePng));
  return known.get(image)!;
}

function decoded(image: Uint8Array, decodePng: Png['decodePng']): Pixels | null {
  try {
    return decodePng(image, MOST_PIXELS);
  } catch {
    return null;
  }
}
