/** Builds the search tree for picking on a large mesh, off the main thread of the page. */

import { MeshBVH } from 'three-mesh-bvh';
import type { TriangleMesh } from '../../engine/core/core';
import { geometryOf, buildTree } from './picker';

addEventListener('message', ({ data }: MessageEvent<TriangleMesh>) => {
  postMessage(MeshBVH.serialize(buildTree(geometryOf(data)), { cloneBuffers: false }));
});
