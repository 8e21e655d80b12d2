/** Textures with an image in a newer format and a fallback for older viewers: the reader keeps only the newer one. */

import type { Document, GLTF } from '@gltf-transform/core';
import { counted } from '../../core/words';

const NEWER = ['EXT_texture_webp', 'EXT_texture_avif', 'KHR_texture_basisu'];

/** A note on the fallback images, which are dropped; none without any. */
export function describeFallbacks({ textures = [] }: GLTF.IGLTF): string[] {
  const count = textures.filter(hasFallback).length;
  if (count === 0) return [];
  const has = count === 1 ? 'has' : 'have';
  return [`${counted(count, 'texture')} ${has} a second image for older viewers, which is left out`];
}

const hasFallback = ({ source, extensions }: GLTF.ITexture): boolean =>
  source !== undefined && NEWER.some((name) => Object.hasOwn(extensions ?? {}, name));

/** Requires the newer formats from viewers, since the fallback images are gone. */
export function requireFormats(document: Document): void {
  for (const extension of document.getRoot().listExtensionsUsed())
    if (NEWER.includes(extension.extensionName)) extension.setRequired(true);
}
