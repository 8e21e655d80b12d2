/** The textures that a material shows through its texture coordinates. */

import type { Document, Material, Texture, TextureInfo } from '@gltf-transform/core';
import type { Transform } from '@gltf-transform/extensions';
import { pixelsOf } from '../document/textures/pixels';
import type { Pixels } from '../document/textures/png';

export interface ShownTexture {
  pixels: Pixels;
  /** whether its alpha channel is visible: the material blends or masks */
  isCut: boolean;
  /** in texture coordinates: (u, v) shows the texture at scale * (u, v) + offset */
  scale: [number, number];
  offset: [number, number];
}

/**
 * The textures that a material shows through TEXCOORD_0; null where there are none, or one of them cannot be decoded (see `pixelsOf`),
 * is rotated, or belongs to an extension.
 */
export function texturesShownBy(document: Document, material: Material | null): ShownTexture[] | null {
  if (!material || hasForeignTexture(material)) return null;
  const pairs: [Texture | null, TextureInfo | null][] = [
    [material.getBaseColorTexture(), material.getBaseColorTextureInfo()],
    [material.getNormalTexture(), material.getNormalTextureInfo()],
    [material.getMetallicRoughnessTexture(), material.getMetallicRoughnessTextureInfo()],
    [material.getOcclusionTexture(), material.getOcclusionTextureInfo()],
    [material.getEmissiveTexture(), material.getEmissiveTextureInfo()],
  ];
  const shown = pairs.flatMap(([texture, info]) =>
    texture && info && info.getTexCoord() === 0 ? [{ texture, info }] : [],
  );
  const transforms = shown.map(({ info }) => transformOf(info));
  if (shown.length === 0 || transforms.includes(null)) return null;
  const pixels = pixelsOf(
    document,
    shown.map(({ texture }) => texture),
  );
  if (!pixels) return null;
  const isOpaque = material.getAlphaMode() === 'OPAQUE';
  return shown.map(({ texture }, i) => ({
    ...transforms[i]!,
    pixels: pixels[i],
    isCut: !isOpaque && texture === material.getBaseColorTexture(),
  }));
}

function hasForeignTexture(material: Material): boolean {
  const graph = material.getGraph();
  return material
    .listExtensions()
    .some((extension) => graph.listChildren(extension).some((child) => child.propertyType === 'Texture'));
}

/** Null where the texture is rotated: sines differ between JavaScript engines. */
function transformOf(info: TextureInfo): Pick<ShownTexture, 'scale' | 'offset'> | null {
  const transform = info.getExtension<Transform>('KHR_texture_transform');
  if (!transform) return { scale: [1, 1], offset: [0, 0] };
  if (transform.getRotation() !== 0 || (transform.getTexCoord() ?? 0) !== 0) return null;
  const [[su, sv], [u, v]] = [transform.getScale(), transform.getOffset()];
  return { scale: [su, sv], offset: [u, v] };
}
