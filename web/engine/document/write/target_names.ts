/** Keeps the names of morph targets: the reader names unnamed targets by their numbers, and the writer would write these names. */

import type { Document, GLTF, Mesh } from '@gltf-transform/core';

/**
 * To be called before the document is written, since writing changes the extras of its meshes. The function that it returns puts the
 * names of the file in place of those that the reader made up, and says whether there was any.
 */
export function rememberTargetNames(document: Document): (json: GLTF.IGLTF) => boolean {
  const remembered = document.getRoot().listMeshes().map(madeUpNames);
  return (json) => {
    remembered.forEach((names, i) => {
      if (names) putNames(json.meshes![i], names.before);
    });
    return remembered.some((names) => names !== null);
  };
}

/** The names in the extras of the mesh if the reader replaced some of them; null otherwise. */
function madeUpNames(mesh: Mesh): { before: unknown } | null {
  const before = mesh.getExtras().targetNames;
  const own: unknown[] = Array.isArray(before) ? before : [];
  const primitive = mesh.listPrimitives().find((one) => one.listTargets().length > 0);
  const names = primitive?.listTargets().map((target) => target.getName()) ?? [];
  const isSame = own.length === names.length && names.every((name, i) => name === own[i]);
  const areReaders = names.every((name, i) => name === (own[i] || String(i)));
  return !isSame && areReaders && names.length > 0 ? { before } : null;
}

function putNames(mesh: GLTF.IMesh, names: unknown): void {
  const extras = { ...mesh.extras };
  if (names === undefined) delete extras.targetNames;
  else extras.targetNames = names;
  if (Object.keys(extras).length > 0) mesh.extras = extras;
  else delete mesh.extras;
}
