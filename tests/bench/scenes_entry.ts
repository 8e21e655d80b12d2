// The entry of the bundle of scenes.mjs: the generators of scenes, and how files are read.

export { Document } from '@gltf-transform/core';
export { createGltfIo } from '../../web/engine/document/gltf_io';
export { openModel } from '../../web/engine/document/open';
export { glbFile } from '../engine/support/gltf';
export {
  boxScene,
  palmScene,
  partsScene,
  roomScene,
  tableScene,
  twoSidedLeaf,
} from '../engine/support/scenes';
export { posesInAnimations } from '../../web/engine/body/skinning';
