/**
 * The light of a plain room, for materials that reflect their surroundings. It was filtered once by
 * `scripts/page/room-light.mjs`, because an emulated graphics card takes seconds for that.
 */

import * as THREE from 'three';
import address from './room_light.bin?url';

/** The share of the room's light that is used in addition to a lamp. */
const STRENGTH = 0.55;
/** Texels along an edge of the sharpest level. */
const SIZE = 64;
const LEVELS = 4;

let loading: Promise<THREE.CubeTexture> | null = null;

/** Lights a scene with the room's light as soon as it is loaded. Without it, only lamps light the scene. */
export async function lightByRoom(scene: THREE.Scene): Promise<void> {
  if (scene.environment) return;
  loading ??= load();
  try {
    scene.environment = await loading;
    scene.environmentIntensity = STRENGTH;
  } catch {
    loading = null; // the next scene tries again
  }
}

async function load(): Promise<THREE.CubeTexture> {
  const response = await fetch(address);
  if (!response.ok) throw new Error(`${response.status} ${response.statusText}`);
  return filteredCube(new Uint32Array(await response.arrayBuffer()));
}

/** `words`: the texels of all levels and faces, as `scripts/page/room-light.mjs` describes them. */
function filteredCube(words: Uint32Array<ArrayBuffer>): THREE.CubeTexture {
  const cubes: THREE.CubeTexture[] = [];
  let at = 0;
  // three.js mistakes the number of smaller levels for that of all levels, so one more follows that is never drawn.
  for (let level = 0; level <= LEVELS; level++) {
    const width = SIZE >> level;
    const faces = Array.from({ length: 6 }, () => {
      const texels = new Uint32Array(width * width);
      texels.set(words.subarray(at, (at += texels.length)));
      return new THREE.DataTexture(texels, width, width);
    });
    cubes.push(new THREE.CubeTexture(faces));
  }
  const [cube, ...smaller] = cubes;
  cube.mipmaps = smaller;
  cube.format = THREE.RGBFormat;
  cube.type = THREE.UnsignedInt5999Type;
  cube.colorSpace = THREE.LinearSRGBColorSpace;
  cube.generateMipmaps = false;
  cube.isPMREMTexture = true;
  cube.needsUpdate = true;
  return cube;
}
