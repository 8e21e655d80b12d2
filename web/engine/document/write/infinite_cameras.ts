/** Perspective cameras without a far plane: the reader gives them one at 100, and the writer writes what it is given. */

import type { Document, GLTF } from '@gltf-transform/core';

/** Sets the far plane of cameras that have none in the file to infinity, which copies of the document keep. */
export function setInfiniteFarPlanes(document: Document, { cameras = [] }: GLTF.IGLTF): void {
  const read = document.getRoot().listCameras();
  cameras.forEach(({ perspective }, i) => {
    if (perspective && perspective.zfar === undefined) read[i].setZFar(Infinity);
  });
}

/**
 * Removes infinite far planes, which JSON cannot express, from the JSON that was written for the document. Returns whether there was
 * any.
 */
export function removeInfiniteFarPlanes(document: Document, json: GLTF.IGLTF): boolean {
  const areEndless = document
    .getRoot()
    .listCameras()
    .map((camera) => camera.getZFar() === Infinity);
  areEndless.forEach((isEndless, i) => {
    if (isEndless) delete json.cameras![i].perspective?.zfar;
  });
  return areEndless.includes(true);
}
