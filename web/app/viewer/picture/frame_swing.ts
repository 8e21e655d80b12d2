/** Places a camera so that a body stays in its picture while it swings. */

import { Vector3 } from 'three';
import type { PerspectiveCamera } from 'three';
import { Framing } from '../camera/framing';

/** The largest fraction of half the picture that the body reaches. */
const FILL = 0.94;
/** The number of sampled vertices. */
const SAMPLES = 600;

export interface Swing {
  /** `[3 v + c]` */
  positions: Float32Array;
  /** displacements at an amplitude of 1, `[3 v + c]`, one array per mode */
  shapes: readonly Float32Array[];
  amplitude: number;
}

/**
 * Looks from the direction `toEye`, as close as possible with the body in the picture at both ends of each of its
 * swings. Field of view, aspect and `up` are those of the camera; `radius` is that of the body at rest.
 */
export function frameSwing(camera: PerspectiveCamera, radius: number, toEye: Vector3, swing: Swing): void {
  const framing = new Framing(camera, toEye, FILL);
  forEachEnd(swing, (point) => framing.take(point));
  const { eye, centre } = framing.view();
  camera.position.copy(eye);
  camera.near = radius / 50;
  camera.far = radius * 50;
  camera.lookAt(centre);
  camera.updateProjectionMatrix();
}

/** Calls `take` with positions that vertices reach. */
function forEachEnd({ positions, shapes, amplitude }: Swing, take: (point: Vector3) => void) {
  const count = positions.length / 3;
  const step = Math.max(1, Math.floor(count / SAMPLES));
  const [rest, way, end] = [new Vector3(), new Vector3(), new Vector3()];
  for (let v = 0; v < count; v += step) {
    rest.fromArray(positions, 3 * v);
    take(rest);
    for (const shape of shapes) {
      way.fromArray(shape, 3 * v);
      for (const part of [-amplitude, amplitude]) take(end.copy(rest).addScaledVector(way, part));
    }
  }
}
