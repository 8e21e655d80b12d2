/**
 * The writer of binary files assumes that images with bytes come before those without, which are references to missing files and
 * duplicates of other images. Otherwise it fails, or assigns images the bytes of others.
 */

import { Extension, PropertyType } from '@gltf-transform/core';
import type { Document, GLTF, WebIO, WriterContext } from '@gltf-transform/core';

const NAME = 'LIMBER_image_order';

/** Sorts images while buffers are written; it leaves no trace in the file. */
class ImageOrder extends Extension {
  static override readonly EXTENSION_NAME = NAME;
  override readonly extensionName = NAME;
  override readonly prewriteTypes = [PropertyType.BUFFER];

  override prewrite({ jsonDoc: { json } }: WriterContext): this {
    const images = json.images ?? [];
    json.images = bytesFirst(images.map(({ bufferView }) => bufferView !== undefined)).map((i) => images[i]);
    return this;
  }

  read = (): this => this;
  write = (): this => this;
}

/** The indices of all images, those with bytes first. */
function bytesFirst(hasBytes: boolean[]): number[] {
  const all = [...hasBytes.keys()];
  return [...all.filter((i) => hasBytes[i]), ...all.filter((i) => !hasBytes[i])];
}

/**
 * To be called before the document is written by `io` as a GLB. The function that it returns gives the images of the written JSON their
 * own order again.
 */
export function sortImages(io: WebIO, document: Document): (json: GLTF.IGLTF) => void {
  const hasBytes = document
    .getRoot()
    .listTextures()
    .map((texture) => !!texture.getImage());
  const order = bytesFirst(hasBytes);
  if (order.every((from, to) => from === to)) return () => {};
  io.registerExtensions([ImageOrder]);
  const extension = document.createExtension(ImageOrder);
  return (json) => {
    extension.dispose();
    const sorted = json.images!;
    json.images = [];
    order.forEach((own, i) => (json.images![own] = sorted[i]));
    json.extensionsUsed = json.extensionsUsed!.filter((name) => name !== NAME);
    if (json.extensionsUsed.length === 0) delete json.extensionsUsed;
  };
}
