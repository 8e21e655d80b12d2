/** Writes a document as GLB, or as glTF with a buffer and images beside it. */

import type { Document, GLTF, Texture } from '@gltf-transform/core';
import { Format } from '@gltf-transform/core';
import { carryForeign } from '../extensions/carry_foreign';
import type { Foreign } from '../extensions/foreign';
import { restoreInnerExtras } from '../extensions/inner_extras';
import type { InnerExtras } from '../extensions/inner_extras';
import { restoreTextureTexts } from '../extensions/texture_texts';
import type { TextureTexts } from '../extensions/texture_texts';
import { glbParts, withJson } from '../glb';
import { createGltfWriter, INDICES_MODE, MESHOPT, RATIFIED_MESHOPT, TRIANGLES_MODE } from '../gltf_io';
import type { SourceFile } from '../model';
import { renameExtension } from './compression';
import { removeInfiniteFarPlanes } from './infinite_cameras';
import { sortImages } from './image_order';
import type { LevelNodes } from './level_nodes';
import { addLevels } from './level_nodes';
import { addressOf, firstWithBytes, imageFiles, imageNames } from './shared_images';
import type { Companion } from './shared_images';
import { rememberTargetNames } from './target_names';

/** What is added to the JSON of the document. */
export interface Additions {
  foreign: Foreign | null;
  textureTexts: TextureTexts | null;
  innerExtras: InnerExtras[];
  /** numbers of the meshes whose primitives have new vertices */
  replaced: ReadonlySet<number>;
  /** meshopt under its ratified name */
  isRatified: boolean;
  /** whether triangles keep the order of their corners */
  keepsCorners: boolean;
  levels: LevelNodes[];
}

export const NO_ADDITIONS: Additions = {
  foreign: null,
  textureTexts: null,
  innerExtras: [],
  replaced: new Set(),
  isRatified: false,
  keepsCorners: false,
  levels: [],
};

/** The document as a GLB; equal images are written once. */
export async function writeGlb(document: Document, additions: Additions): Promise<Uint8Array> {
  const firsts = firstWithBytes(document);
  const textures = document.getRoot().listTextures();
  const copies = textures.filter((texture) => firsts.has(texture) && firsts.get(texture) !== texture);
  // A texture without bytes gets no buffer view.
  for (const texture of copies) texture.setImage(null as unknown as Uint8Array<ArrayBuffer>);
  const putTargetNames = rememberTargetNames(document);
  const io = await createGltfWriter(document, additions.keepsCorners);
  const putImages = sortImages(io, document);
  const bytes = await io.writeBinary(document);
  const json = JSON.parse(new TextDecoder().decode(glbParts({ name: '', bytes }).json)) as GLTF.IGLTF;
  putImages(json);
  textures.forEach((texture, i) => {
    if (copies.includes(texture))
      json.images![i].bufferView = json.images![textures.indexOf(firsts.get(texture)!)].bufferView;
    else if (!texture.getImage()) keepAddress(json.images![i], texture);
  });
  const isMended = [putTargetNames(json), removeInfiniteFarPlanes(document, json)].includes(true);
  const isChanged = isMended || textures.some((texture) => !texture.getImage()) || hasAdditions(additions);
  return isChanged ? withJson(bytes, withAdditions(json, additions)) : bytes;
}

/** Restores the address of an image whose bytes were missing, so that it stays a reference. */
function keepAddress(image: GLTF.IImage, texture: Texture): void {
  if (texture.getURI() !== '') image.uri = texture.getURI();
}

/** `name`.gltf, its buffer `stem`.bin and its images, those with addresses of their own under these. */
export async function writeGltf(
  document: Document,
  name: string,
  additions: Additions,
): Promise<SourceFile[]> {
  const stem = name.replace(/\.gltf$/i, '');
  const textures = document.getRoot().listTextures();
  const names = imageNames(document, stem);
  for (const [texture, own] of names) texture.setURI(own);
  const putTargetNames = rememberTargetNames(document);
  const io = await createGltfWriter(document, additions.keepsCorners);
  const written = await io.writeJSON(document, { format: Format.GLTF, basename: stem });
  const buffers = written.json.buffers ?? [];
  for (const buffer of buffers) if (buffer.uri !== undefined) buffer.uri = addressOf(buffer.uri);
  textures.forEach((texture, i) => {
    const image = written.json.images![i];
    if (texture.getImage()) image.uri = addressOf(texture.getURI());
    else keepAddress(image, texture);
  });
  putTargetNames(written.json);
  removeInfiniteFarPlanes(document, written.json);
  const json = withAdditions(written.json, additions);
  const text = new TextEncoder().encode(JSON.stringify(json));
  const companions = Object.entries(written.resources).map(([own, bytes]) => ({ name: own, bytes }));
  return [{ name, bytes: text }, ...companions];
}

/** The files that `writeGltf` writes beside the main one, all known before the work. */
export function gltfCompanions(document: Document, name: string): Companion[] {
  const stem = name.replace(/\.gltf$/i, '');
  return [{ name: `${stem}.bin`, bytes: null }, ...imageFiles(document, stem)];
}

const hasAdditions = (additions: Additions): boolean => {
  const { foreign, textureTexts, innerExtras, isRatified, keepsCorners, levels } = additions;
  const isAny = foreign !== null || textureTexts !== null || isRatified || keepsCorners;
  return isAny || innerExtras.length > 0 || levels.length > 0;
};

function withAdditions(json: GLTF.IGLTF, additions: Additions): GLTF.IGLTF {
  const { foreign, textureTexts, innerExtras, replaced, isRatified, keepsCorners, levels } = additions;
  if (textureTexts) restoreTextureTexts(json, textureTexts);
  restoreInnerExtras(json, innerExtras);
  if (foreign) carryForeign(json, foreign, replaced);
  addLevels(json, levels);
  if (keepsCorners) namePackedInOrder(json);
  return isRatified ? renameExtension(json, MESHOPT, RATIFIED_MESHOPT) : json;
}

/** Declares the mode in which triangles were packed, see `packedInOrder`. */
function namePackedInOrder({ bufferViews = [] }: GLTF.IGLTF): void {
  for (const { extensions } of bufferViews) {
    const packed = extensions?.[MESHOPT] as { mode: string } | undefined;
    if (packed?.mode === TRIANGLES_MODE) packed.mode = INDICES_MODE;
  }
}
