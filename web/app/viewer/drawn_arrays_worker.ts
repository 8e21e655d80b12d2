/** Prepares what is drawn of large meshes, away from the main thread of the page. */

import type { TriangleMesh } from '../../engine/core/core';
import { drawnArrays } from './drawn_arrays';

addEventListener('message', ({ data }: MessageEvent<TriangleMesh>) => {
  const drawn = drawnArrays(data);
  const arrays = [drawn.positions, drawn.groups, ...(drawn.normals ? [drawn.normals] : [])];
  postMessage(drawn, { transfer: arrays.map(({ buffer }) => buffer) });
});
