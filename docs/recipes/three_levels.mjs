// Levels of detail of limber in three.js.
//
//   limber optimize chair.glb lod0.glb --ratio 0.5 --lods 0.25,0.1       writes lod0.glb, lod0_lod1.glb, lod0_lod2.glb

import { Box3, LOD, Vector3 } from 'three';

/**
 * One object that shows coarser levels from farther away. `scenes`: gltf.scene of each level, finest first. `pixels`: the error that an edge of the
 * silhouette may have on a screen of `height` pixels with this camera. `deviations`: of each level, in % of the diagonal, from the
 * reports of limber (surface.hausdorff, and levels[i].surface.hausdorff for further levels).
 */
export function levelsOf(scenes, { deviations, camera, height, pixels = 1 }) {
  const diagonal = new Box3().setFromObject(scenes[0]).getSize(new Vector3()).length();
  // How many units one pixel shows at distance 1.
  const perPixel = (2 * Math.tan((camera.fov * Math.PI) / 360)) / height;
  const lod = new LOD();
  scenes.forEach((scene, i) => {
    const distance = i === 0 ? 0 : (deviations[i] * diagonal) / 100 / (perPixel * pixels);
    lod.addLevel(scene, distance, 0.05);
  });
  return lod;
}
