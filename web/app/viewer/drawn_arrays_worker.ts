/** Prepares the drawn arrays of large meshes off the main thread of the page. */

import type { TriangleMesh } from '../../engine/core/core';
import { drawnArrays, quickArrays } from './drawn_arrays';

addEventListener('message', ({ data }: MessageEvent<{ mesh: TriangleMesh; isQuick: boolean }>) => {
  const drawn = data.isQuick ? quickArrays(data.mesh) : drawnArrays(data.mesh);
  const arrays = [drawn.positions, drawn.groups, ...(drawn.normals ? [drawn.normals] : [])];
  postMessage(drawn, { transfer: arrays.map(({ buffer }) => buffer) });
});
