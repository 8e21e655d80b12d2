/** Places a camera so that a body stays in its picture while it swings. */

import { MathUtils, Vector3 } from 'three';
import type { PerspectiveCamera, Sphere } from 'three';

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
 * Looks at the centre of `sphere`, which encloses the body at rest, from the direction `toEye`, as close as possible
 * with the body in the picture at both ends of each of its swings. Field of view, aspect and `up` are those of the
 * camera.
 */
export function frameSwing(camera: PerspectiveCamera, sphere: Sphere, toEye: Vector3, swing: Swing): void {
  const back = toEye.clone().normalize();
  const right = camera.up.clone().cross(back).normalize();
  const up = back.clone().cross(right);
  const high = FILL * Math.tan(MathUtils.degToRad(camera.fov / 2));
  const wide = high * camera.aspect;
  let distance = 0;
  forEachEnd(sphere.center, swing, (q) => {
    const aside = Math.max(Math.abs(q.dot(right)) / wide, Math.abs(q.dot(up)) / high);
    distance = Math.max(distance, q.dot(back) + aside);
  });
  camera.position.copy(sphere.center).addScaledVector(back, distance);
  camera.near = sphere.radius / 50;
  camera.far = sphere.radius * 50;
  camera.lookAt(sphere.center);
  camera.updateProjectionMatrix();
}

/** Calls `take` with positions that vertices reach, relative to `centre`. */
function forEachEnd(centre: Vector3, { positions, shapes, amplitude }: Swing, take: (q: Vector3) => void) {
  const count = positions.length / 3;
  const step = Math.max(1, Math.floor(count / SAMPLES));
  const [rest, way, q] = [new Vector3(), new Vector3(), new Vector3()];
  for (let v = 0; v < count; v += step) {
    rest.fromArray(positions, 3 * v).sub(centre);
    take(rest);
    for (const shape of shapes) {
      way.fromArray(shape, 3 * v);
      for (const end of [-amplitude, amplitude]) take(q.copy(rest).addScaledVector(way, end));
    }
  }
}
