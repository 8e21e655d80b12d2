/** The light of a plain room, for materials that mirror what is around them. */

import * as THREE from 'three';
import { RoomEnvironment } from 'three/examples/jsm/environments/RoomEnvironment.js';

const rooms = new WeakMap<THREE.WebGLRenderer, THREE.Texture>();
/** The share of the room's light that is used beside a lamp. */
export const ROOM_LIGHT = 0.55;

/** Radians. */
const BLUR = 0.04;

/** Made once for each renderer. */
export function roomLight(renderer: THREE.WebGLRenderer): THREE.Texture {
  const known = rooms.get(renderer);
  if (known) return known;
  const generator = new THREE.PMREMGenerator(renderer);
  const { texture } = generator.fromScene(new RoomEnvironment(), BLUR);
  generator.dispose();
  rooms.set(renderer, texture);
  return texture;
}

/** To be called when a lost context has come back: pictures that were drawn on the graphics card have to be drawn again. */
export function forgetRoomLight(renderer: THREE.WebGLRenderer): void {
  rooms.delete(renderer);
}
