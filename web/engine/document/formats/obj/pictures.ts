/** The pictures of materials as textures of a document, if glTF supports their format. */

import { TextureInfo } from '@gltf-transform/core';
import type { Document, Texture } from '@gltf-transform/core';
import { KHRTextureTransform } from '@gltf-transform/extensions';
import { addressOf } from '../../write/shared_images';
import type { SourceFile } from '../../model';
import { isJpeg } from '../jpeg_mark';
import { isPng, pngChunks } from '../png_chunks';
import { picturePaths } from './companion_paths';
import type { Omissions } from './omissions';
import type { MtlMap } from './mtl_map';
import type { NamedFiles } from './named_files';

/** Bytes of the signature and the first chunk of a PNG. */
const PNG_HEADER_BYTES = 33;
/** The offset of the colour type in the first chunk of a PNG, and the types with alpha. */
const PNG_COLOUR_TYPE = 25;
const PNG_TYPES_WITH_ALPHA = [4, 6];

export class Pictures {
  private readonly textures = new Map<SourceFile, Texture | null>();

  constructor(
    private readonly document: Document,
    private readonly main: string,
    private readonly files: NamedFiles,
    private readonly omissions: Omissions,
  ) {}

  /** The texture of a file, made once; null, with a note, for files that are missing or of a format that glTF does not support. */
  textureOf(library: string, name: string): Texture | null {
    const file = this.files.find(picturePaths(this.main, library, name));
    if (!file) {
      this.omissions.add('missing', name);
      return null;
    }
    if (!this.textures.has(file)) this.textures.set(file, this.create(file));
    return this.textures.get(file)!;
  }

  /**
   * Maps a texture as the options of its line say. MTL counts v from the lower edge and glTF from the upper one: 1 - v becomes
   * 1 - (scale v + offset).
   */
  lay(info: TextureInfo, { scale, offset, isClamped }: MtlMap): void {
    const { CLAMP_TO_EDGE } = TextureInfo.WrapMode;
    if (isClamped) info.setWrapS(CLAMP_TO_EDGE).setWrapT(CLAMP_TO_EDGE);
    const [[scaleU, scaleV], [offsetU, offsetV]] = [scale, offset];
    if (scaleU === 1 && scaleV === 1 && offsetU === 0 && offsetV === 0) return;
    const transform = this.document
      .createExtension(KHRTextureTransform)
      .createTransform()
      .setScale([scaleU, scaleV])
      .setOffset([offsetU, 1 - scaleV - offsetV]);
    info.setExtension(KHRTextureTransform.EXTENSION_NAME, transform);
  }

  private create({ name, bytes }: SourceFile): Texture | null {
    const type = mimeTypeOf(bytes);
    if (type === null) {
      this.omissions.add('format', name);
      return null;
    }
    return this.document
      .createTexture(name.replace(/^.*[/\\]/, '').replace(/\.[^.]*$/, ''))
      .setMimeType(type)
      .setURI(addressOf(name.replaceAll('\\', '/')))
      .setImage(new Uint8Array(bytes));
  }
}

/** By its first bytes: names do not always tell. */
function mimeTypeOf(bytes: Uint8Array): 'image/png' | 'image/jpeg' | null {
  if (isPng(bytes) && bytes.length >= PNG_HEADER_BYTES) return 'image/png';
  return isJpeg(bytes) ? 'image/jpeg' : null;
}

/** Whether it is a PNG with an alpha channel, or with a list of colours of which some are transparent. */
export function hasAlpha(texture: Texture): boolean {
  const bytes = texture.getImage();
  if (!bytes || texture.getMimeType() !== 'image/png') return false;
  return PNG_TYPES_WITH_ALPHA.includes(bytes[PNG_COLOUR_TYPE]) || hasTransparentColours(bytes);
}

/** Whether there is a chunk tRNS before the pixels. */
function hasTransparentColours(bytes: Uint8Array): boolean {
  for (const { type } of pngChunks(bytes)) {
    if (type === 'tRNS') return true;
    if (type === 'IDAT') return false;
  }
  return false;
}
