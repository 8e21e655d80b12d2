/** Grows the tree that a large mesh is picked with, away from the page's main thread. */

import { MeshBVH } from 'three-mesh-bvh';
import type { TriangleMesh } from '../../engine/core/core';
import { geometryOf, growTree } from './picker';

addEventListener('message', ({ data }: MessageEvent<TriangleMesh>) => {
  postMessage(MeshBVH.serialize(growTree(geometryOf(data)), { cloneBuffers: false }));
});
