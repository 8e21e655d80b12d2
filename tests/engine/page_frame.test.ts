/** What stays in the picture where it becomes narrower, and where a body moves out of it. */

import { Vector3 } from 'three';
import { beforeEach, expect, test, vi } from 'vitest';
import { FrameKeeper } from '../../web/app/viewer/camera/frame_keeper';
import { OrbitCamera } from '../../web/app/viewer/camera/orbit_camera';
import { outermost } from '../../web/app/viewer/camera/outermost';

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
const distance = () => orbit['controls'].distance;
const ahead = () => orbit.camera.getWorldDirection(new Vector3());
const atOnce = { from: 'front', isAnimated: false } as const;
const settle = () => Array.from({ length: 200 }, () => orbit.update(0.05));

beforeEach(() => {
  // Without a canvas nobody turns the view.
  orbit = new OrbitCamera(undefined as never);
  keeper = new FrameKeeper(orbit);
  orbit.setAspect(2);
  orbit.fit(corners, atOnce);
  keeper.fitted();
  settle();
});

test('in a narrower picture a body stays in it from side to side, and in a wider one it is as near as before', () => {
  const [near, direction] = [distance(), ahead()];
  expect(across()).toBeLessThan(0.81);
  for (const aspect of [1.5, 1, 0.6]) setAspect(aspect);
  expect(across()).toBeLessThan(0.95);
  expect(across()).toBeGreaterThan(0.7);
  expect(ahead().distanceTo(direction)).toBeLessThan(1e-6);
  setAspect(2);
  settle();
  expect(distance()).toBeCloseTo(near, 6);
});

test('a body framed in a narrow picture fills a wide one', () => {
  setAspect(0.4);
  orbit.fit(corners, atOnce);
  keeper.fitted();
  setAspect(2);
  expect(across()).toBeCloseTo(0.8, 5);
});

test('a whole body that the user has framed stays in a narrower picture', () => {
  orbit.zoom(0.9);
  settle();
  setAspect(0.5);
  settle();
  expect(across()).toBeCloseTo(0.9, 5);
});

test('what the user has zoomed to is as wide in a narrower picture, and no wider', () => {
  orbit.zoom(2);
  settle();
  const [before, chosen] = [across(), distance()];
  expect(before).toBeGreaterThan(1.2);
  setAspect(1);
  settle();
  expect(across()).toBeLessThan(before);
  expect(distance()).toBeCloseTo(2 * chosen, 6);
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

test('a slanted bar reaches the same margin at both sides of the picture that it fills', () => {
  const bar = [-2, 2].flatMap((t) => [-0.1, 0.1].map((y) => new Vector3(t + 5, t + y, t)));
  for (const aspect of [0.6, 2]) {
    orbit.setAspect(aspect);
    orbit.fit(bar, atOnce);
    settle();
    const seen = bar.map((point) => point.clone().project(orbit.camera));
    const ends = (['x', 'y'] as const).map((c) => seen.map((point) => point[c])).map(endsOf);
    expect(Math.max(...ends.flat())).toBeCloseTo(0.8, 5);
    for (const [low, high] of ends) expect(low + high).toBeLessThan(0.25);
    const tight = ends.find(([, high]) => high > 0.799)!;
    expect(tight[0]).toBeCloseTo(-0.8, 5);
  }
});

test('fitting keeps the direction to which the user has turned the view', () => {
  orbit.rotate(1, 0.2);
  orbit.zoom(4);
  settle();
  const direction = ahead();
  expect(across()).toBeGreaterThan(1);
  orbit.fit(corners, { from: 'here', isAnimated: true });
  settle();
  expect(ahead().distanceTo(direction)).toBeLessThan(1e-3);
  const { across: aside, up } = orbit.spreadOf(corners);
  expect(Math.max(aside, up)).toBeCloseTo(0.8, 3);
});

const endsOf = (values: number[]): [number, number] => [Math.min(...values), Math.max(...values)];

test('the outermost points of a slanted needle are its ends, not the corners of its box', () => {
  const needle = Float32Array.from({ length: 3 * 50_000 }, (_, i) => Math.floor(i / 3) / 50_000);
  const points = outermost(needle);
  for (const { x, y, z } of points) expect(Math.max(x, y, z) - Math.min(x, y, z)).toBeLessThan(1e-6);
  expect(Math.min(...points.map(({ x }) => x))).toBe(0);
  expect(Math.max(...points.map(({ x }) => x))).toBeCloseTo(1, 4);
  expect(outermost(new Float32Array())).toEqual([]);
});
