/** What stays in the picture where it becomes narrower, and where a body moves out of it. */

import { Vector3 } from 'three';
import { beforeEach, expect, test, vi } from 'vitest';
import { FrameKeeper } from '../../web/app/viewer/frame_keeper';
import { OrbitCamera } from '../../web/app/viewer/orbit_camera';

/** The corners of a bar that is wider than high. */
const corners = [-2, 2].flatMap((x) =>
  [-0.5, 0.5].flatMap((y) => [-0.5, 0.5].map((z) => new Vector3(x, y, z))),
);
const positions = (lift: number): Float32Array =>
  Float32Array.from(corners.flatMap(({ x, y, z }) => [x, y + lift, z]));

// The controls of the camera keep the rectangle of their canvas.
vi.stubGlobal('DOMRect', class {});

let orbit: OrbitCamera;
let keeper: FrameKeeper;
const across = () => orbit.spreadOf(corners).across;
const setAspect = (aspect: number) => keeper.keepWidth(corners, () => orbit.setAspect(aspect));
const distance = () => orbit.camera.position.length();
const settle = () => Array.from({ length: 200 }, () => orbit.update(0.05));

beforeEach(() => {
  // Without a canvas nobody turns the view.
  orbit = new OrbitCamera(undefined as never);
  keeper = new FrameKeeper(orbit);
  orbit.setAspect(2);
  orbit.fit(corners, false);
  settle();
});

test('in a narrower picture a body stays in it from side to side, and in a wider one it is as near as before', () => {
  const [near, direction] = [distance(), orbit.camera.position.clone().normalize()];
  expect(across()).toBeLessThan(0.81);
  for (const aspect of [1.5, 1, 0.6]) setAspect(aspect);
  expect(across()).toBeLessThan(0.95);
  expect(across()).toBeGreaterThan(0.7);
  expect(orbit.camera.position.clone().normalize().distanceTo(direction)).toBeLessThan(1e-6);
  setAspect(2);
  settle();
  expect(distance()).toBeCloseTo(near, 6);
});

test('what the user has zoomed to is as wide in a narrower picture, and no wider', () => {
  orbit.zoom(2);
  settle();
  const before = across();
  expect(before).toBeGreaterThan(1.2);
  setAspect(1);
  settle();
  expect(across()).toBeLessThan(before);
  expect(across()).toBeGreaterThan(before / 2);
});

test('a body that moves out of the picture makes the eye step back, and it comes back after the motion', () => {
  const near = distance();
  keeper.keepMotion(corners, [positions(0)]);
  settle();
  expect(distance()).toBeCloseTo(near, 6);
  for (let i = 0; i < 20; i++) {
    keeper.keepMotion(corners, [positions(0), positions(1.5)]);
    orbit.update(1 / 60);
  }
  settle();
  const far = distance();
  expect(far).toBeGreaterThan(1.1 * near);
  // On its way it does not step back again and again.
  expect(
    orbit.spreadOf([0, 1, 2, 3].map((i) => corners[2 * i + 1].clone().setY(corners[2 * i + 1].y + 1.5))).up,
  ).toBeGreaterThan(0.6);
  keeper.keepMotion(corners, [positions(NaN), positions(1e9)]);
  settle();
  expect(distance()).toBeLessThan(3.01 * near);
  keeper.endMotion();
  settle();
  expect(distance()).toBeCloseTo(near, 6);
});

test('the eye stays where the user has put it while bodies move', () => {
  keeper.keepMotion(corners, [positions(0)]);
  orbit.zoom(2);
  settle();
  const chosen = distance();
  keeper.keepMotion(corners, [positions(3)]);
  settle();
  expect(distance()).toBeCloseTo(chosen, 6);
});
