/** Textures with an image in a newer format and another for viewers that do not know it: the reader keeps the newer one alone. */

import type { Document, GLTF } from '@gltf-transform/core';
import { counted } from '../../core/words';

const NEWER = ['EXT_texture_webp', 'EXT_texture_avif', 'KHR_texture_basisu'];

/** A note on the images that are not kept; none where there are none. */
export function describeFallbacks({ textures = [] }: GLTF.IGLTF): string[] {
  const count = textures.filter(hasFallback).length;
  if (count === 0) return [];
  const has = count === 1 ? 'has' : 'have';
  return [`${counted(count, 'texture')} ${has} a second image for older viewers, which is left out`];
}

const hasFallback = ({ source, extensions }: GLTF.ITexture): boolean =>
  source !== undefined && NEWER.some((name) => Object.hasOwn(extensions ?? {}, name));

/** Without another image, the format has to be known. */
export function requireFormats(document: Document): void {
  for (const extension of document.getRoot().listExtensionsUsed())
    if (NEWER.includes(extension.extensionName)) extension.setRequired(true);
}
