// Levels of detail of limber in Babylon.js.
//
//   limber optimize chair.glb lod0.glb --ratio 0.5 --lods 0.25,0.1       writes lod0.glb, lod0_lod1.glb, lod0_lod2.glb

/**
 * Makes `meshes[0]` show coarser meshes from farther away. `meshes`: the same mesh of each level, finest first (loaded with
 * ImportMeshAsync). `pixels`, `deviations`: as in three_levels.mjs; `camera` and `height` too, but Babylon's fov is in radians.
 */
export function addLevels(meshes, { deviations, camera, height, pixels = 1 }) {
  const { boundingSphere } = meshes[0].getBoundingInfo();
  const diagonal = 2 * boundingSphere.radiusWorld;
  const perPixel = (2 * Math.tan(camera.fov / 2)) / height;
  for (let i = 1; i < meshes.length; ++i)
    meshes[0].addLODLevel((deviations[i] * diagonal) / 100 / (perPixel * pixels), meshes[i]);
  return meshes[0];
}
