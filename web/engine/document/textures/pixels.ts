/** The pixels of PNG and JPEG textures. */

import type { Document, Texture } from '@gltf-transform/core';
import { isJpeg } from '../formats/jpeg_mark';
import type { Pixels } from './png';

/** The most pixels that are decoded of a file; they take 0.1 to 0.2 seconds of one processor core. */
export const MAX_PIXELS = 1 << 20;

interface Decoder {
  sizeOf(bytes: Uint8Array): [number, number] | null;
  decode(bytes: Uint8Array, mostPixels: number): Pixels | null;
}

const loaders = {
  png: () => import('./png').then((png): Decoder => ({ sizeOf: png.sizeOfPng, decode: png.decodePng })),
  jpeg: () =>
    import('./jpeg').then((jpeg): Decoder => ({ sizeOf: jpeg.sizeOfJpeg, decode: jpeg.decodeJpeg })),
};

const loaded: { png?: Decoder; jpeg?: Decoder } = {};
const chosenOf = new WeakMap<Document, Set<Texture>>();
const known = new WeakMap<Uint8Array, Pixels | null>();

const formatOf = (image: Uint8Array): keyof typeof loaders => (isJpeg(image) ? 'jpeg' : 'png');

/** Loads the decoders of a document's textures, without which `pixelsOf` returns null. The page loads each with the first such file. */
export async function loadDecoders(document: Document): Promise<void> {
  const images = document
    .getRoot()
    .listTextures()
    .flatMap((texture) => texture.getImage() ?? []);
  for (const format of new Set(images.map(formatOf))) {
    const decoder = loaded[format] ?? (await loaders[format]().catch(() => undefined));
    if (decoder) loaded[format] = decoder;
  }
}

/**
 * Null if one of the textures of a document is broken, neither a PNG nor a JPEG that can be decoded, or not among those that are
 * decoded: the smallest of the file, as long as they have no more than MAX_PIXELS together.
 */
export function pixelsOf(document: Document, textures: Texture[]): Pixels[] | null {
  if (!chosenOf.has(document)) chosenOf.set(document, chosenAmong(document.getRoot().listTextures()));
  if (!textures.every((texture) => chosenOf.get(document)!.has(texture))) return null;
  const pixels = textures.map((texture) => decodedOnce(texture.getImage()!));
  return pixels.every((one) => one !== null) ? pixels : null;
}

function chosenAmong(textures: Texture[]): Set<Texture> {
  const sized = textures.map((texture) => {
    const image = texture.getImage() ?? new Uint8Array();
    const [width, height] = loaded[formatOf(image)]?.sizeOf(image) ?? [Infinity, 1];
    return { texture, count: width * height };
  });
  let room = MAX_PIXELS;
  return new Set(
    sized
      .sort((a, b) => (a.count === b.count ? 0 : a.count - b.count))
      .filter(({ count }) => (room -= count) >= 0)
      .map(({ texture }) => texture),
  );
}

function decodedOnce(image: Uint8Array): Pixels | null {
  if (!known.has(image)) known.set(image, decoded(image));
  return known.get(image)!;
}

function decoded(image: Uint8Array): Pixels | null {
  try {
    return loaded[formatOf(image)]?.decode(image, MAX_PIXELS) ?? null;
  } catch {
    return null;
  }
}
