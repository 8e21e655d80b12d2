import { expect, test } from 'vitest';
import { SCENE_ENDS, endNames, rotated, rotationOf } from '../../web/engine/motion/scene_rotation';

const IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
/** Turns by -90 degrees about x, as exporters do where z is up: z becomes y. */
const Z_UP = [1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1];

const rounded = (values: Iterable<number>) => [...values].map((value) => Math.round(1e6 * value) / 1e6 + 0);

test('a node that does not rotate its mesh, or scales and moves it alone, has no rotation', () => {
  expect(rotationOf(IDENTITY)).toBeNull();
  expect(rotationOf([2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 5, 6, 7, 1])).toBeNull();
});

test('the up direction of the scene is up after the rotation, at the size of the mesh', () => {
  const rotation = rotationOf(Z_UP.map((value, i) => (i < 12 ? 3 * value : value)));
  expect(rounded(rotated(Float32Array.of(0, 0, 1, 1, 2, 3), rotation))).toEqual([0, 1, 0, 1, 3, -2]);
});

test('rotating back gives the original points', () => {
  // About (1, 1, 1) by 120 degrees, then squeezed.
  const rotation = rotationOf([0, 2, 0, 0, 0, 0, 1, 0, 0.5, 0, 0, 0, 0, 0, 0, 1]);
  const points = Float32Array.of(0.25, -1, 4, 7, 0.5, -3);
  const there = rotated(points, rotation);
  expect(rounded(there)).not.toEqual(rounded(points));
  expect(rounded(rotated(there, rotation, true))).toEqual(rounded(points));
});

test('the rotation of a reflected node is a rotation that keeps the up direction', () => {
  const rotation = rotationOf([-1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1])!;
  const [a, b, c, d, e, f, g, h, i] = rotation;
  expect(a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)).toBeCloseTo(1);
  // The mesh's y axis goes to z, and -z of the mesh is up.
  expect(rounded(rotated(Float32Array.of(0, 1, 0), rotation))).toEqual([0, 0, 1]);
});

test('a matrix without extent has no rotation', () => {
  expect(rotationOf(new Array<number>(16).fill(0))).toBeNull();
  expect(rotationOf(new Array<number>(16).fill(NaN))).toBeNull();
});

test('ends of an upright body have the names of those of an unrotated mesh', () => {
  SCENE_ENDS.forEach(({ low, high }, axis) => {
    const subject = (name: string) => `The ${name.toLowerCase()}`;
    const { low: first, high: last } = endNames(IDENTITY, axis);
    expect({ low, high }).toEqual({ low: subject(first), high: subject(last) });
  });
});

test('ends are named as the scene shows them', () => {
  expect(endNames(IDENTITY, 1)).toEqual({ low: 'Bottom', high: 'Top' });
  expect(endNames(IDENTITY, 0)).toEqual({ low: 'Left end', high: 'Right end' });
  expect(endNames(Z_UP, 2)).toEqual({ low: 'Bottom', high: 'Top' });
  expect(endNames(Z_UP, 1)).toEqual({ low: 'Front end', high: 'Back end' });
});
