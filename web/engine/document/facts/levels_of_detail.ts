/** Recognises levels of detail in a file: by the extension MSFT_lod, or nodes named NAME_LOD0, NAME_LOD1 and so on. */

import type { Document } from '@gltf-transform/core';
import type { OpenModel } from '../model';

const NUMBERED = /^(.*)[_-]LOD(\d+)$/i;

const NOTE =
  'levels of detail: each keeps the same share of its faces, and the settings for when it is shown stay unchanged';

/** The model, with `hasLevels` and a note where meshes of its file are levels of detail of others. */
export function withKnownLevels(model: OpenModel): OpenModel {
  const { document, foreign, notes } = model;
  const isExtended = foreign?.extensions.some(({ name }) => name === 'MSFT_lod');
  return isExtended || hasNumberedNodes(document)
    ? { ...model, hasLevels: true, notes: [...notes, NOTE] }
    : model;
}

/** Whether nodes with meshes differ only in the level number of their names. */
function hasNumberedNodes(document: Document): boolean {
  const levels = new Map<string, string>();
  return document
    .getRoot()
    .listNodes()
    .some((node) => {
      const [, name, level] = (node.getMesh() && NUMBERED.exec(node.getName())) ?? [];
      if (name === undefined) return false;
      const other = levels.get(name) ?? level;
      levels.set(name, other);
      return other !== level;
    });
}
