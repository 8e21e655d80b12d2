/** Which materials say nothing of how a mesh looks. */

import * as THREE from 'three';

const TEXTURES = [
  'map',
  'emissiveMap',
  'metalnessMap',
  'roughnessMap',
  'normalMap',
  'aoMap',
] as const satisfies readonly (keyof THREE.MeshStandardMaterial)[];

/** Whether a material is white and matt and nothing more, as that of a name in an OBJ is: on the light stage it is hardly to be seen. */
export function isBlankMaterial(material: THREE.Material): boolean {
  if (!(material instanceof THREE.MeshStandardMaterial) || material instanceof THREE.MeshPhysicalMaterial)
    return false;
  const { color, emissive, roughness, opacity, vertexColors } = material;
  const hasColour = color.getHex() !== 0xffffff || emissive.getHex() !== 0 || vertexColors;
  const isTextured = TEXTURES.some((name) => material[name] !== null);
  return !hasColour && !isTextured && roughness === 1 && opacity === 1;
}
