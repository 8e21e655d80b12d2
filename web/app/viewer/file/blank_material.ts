/** Detects materials that do not define the look of a mesh. */

import * as THREE from 'three';

const TEXTURES = [
  'map',
  'emissiveMap',
  'metalnessMap',
  'roughnessMap',
  'normalMap',
  'aoMap',
] as const satisfies readonly (keyof THREE.MeshStandardMaterial)[];

/** Whether a material is just white and matt, like one of which an OBJ only has the name: on the light stage it would be hardly visible. */
export function isBlankMaterial(material: THREE.Material): boolean {
  if (!(material instanceof THREE.MeshStandardMaterial) || material instanceof THREE.MeshPhysicalMaterial)
    return false;
  const { color, emissive, roughness, opacity, vertexColors } = material;
  const hasColour = color.getHex() !== 0xffffff || emissive.getHex() !== 0 || vertexColors;
  const isTextured = TEXTURES.some((name) => material[name] !== null);
  return !hasColour && !isTextured && roughness === 1 && opacity === 1;
}
