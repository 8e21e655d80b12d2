// The pictures of the gallery of modes.

import { PerspectiveCamera, Vector3 } from 'three';
import { expect, test } from 'vitest';
import { frameSwing } from '../../web/app/viewer/picture/frame_swing';

/** A bar of two vertices that stretches, and bends out of the picture's plane. */
const swing = {
  positions: Float32Array.of(0, -1, 0, 0, 1, 0),
  shapes: [Float32Array.of(0, -1, 0, 0, 1, 0), Float32Array.of(0, 0, 1, 0, 0, 1)],
  amplitude: 0.5,
};

/** How far a point is from the middle of the picture, 1 at its edge. */
function reach(camera: PerspectiveCamera, x: number, y: number, z: number): number {
  camera.updateMatrixWorld();
  const seen = new Vector3(x, y, z).project(camera);
  return Math.max(Math.abs(seen.x), Math.abs(seen.y));
}

test('a body that stretches or swings towards the eye stays in the frame and nearly fills it', () => {
  for (const aspect of [0.5, 1.4]) {
    const camera = new PerspectiveCamera(30, aspect);
    frameSwing(camera, 1, new Vector3(0, 0, 2), swing);
    const ends = [reach(camera, 0, 1.5, 0), reach(camera, 0, 1, 0.5), reach(camera, 0, -1.5, 0)];
    expect(Math.max(...ends)).toBeCloseTo(0.94);
  }
});

test('a narrow frame shows a wide body from farther away', () => {
  const wide = { ...swing, positions: Float32Array.of(-1, 0, 0, 1, 0, 0) };
  const distances = [0.5, 1].map((aspect) => {
    const camera = new PerspectiveCamera(30, aspect);
    frameSwing(camera, 1, new Vector3(0, 0, 1), wide);
    return camera.position.z;
  });
  expect(distances[0]).toBeGreaterThan(1.5 * distances[1]);
});
