/** The picture of an asset in the summary: before on the left, after on the right. */

import { openAnyModel } from '../../../engine/document/open';
import type { OpenModel, SourceFile } from '../../../engine/document/open';
import { cameraOn } from './camera';
import { encodePng } from './png';
import { beside, draw } from './raster';
import { sceneTriangles } from './triangles';

/** Of each of the two. */
export const PICTURE_SIZE = 144;

/** A PNG. `written`: the files of the result, of which one is its model. Throws an Error where they are none. */
export async function drawAsset(before: OpenModel, written: SourceFile[]): Promise<Uint8Array> {
  const original = sceneTriangles(before);
  const result = sceneTriangles(await openAnyModel(written));
  const camera = cameraOn(original);
  return encodePng(beside([original, result].map((triangles) => draw(triangles, camera, PICTURE_SIZE))));
}
