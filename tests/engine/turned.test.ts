import { expect, test } from 'vitest';
import { endNames, turned, turnOf } from '../../web/engine/motion/turned';

const IDENTITY = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
/** Turns by -90 degrees about x, as exporters do where z is up: z becomes y. */
const Z_UP = [1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1];

const rounded = (values: Iterable<number>) => [...values].map((value) => Math.round(1e6 * value) / 1e6 + 0);

test('a node that does not turn its mesh, or scales and moves it alone, has no turn', () => {
  expect(turnOf(IDENTITY)).toBeNull();
  expect(turnOf([2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, 5, 6, 7, 1])).toBeNull();
});

test('what is up in the scene is up after the turn, at the size of the mesh', () => {
  const turn = turnOf(Z_UP.map((value, i) => (i < 12 ? 3 * value : value)));
  expect(rounded(turned(Float32Array.of(0, 0, 1, 1, 2, 3), turn))).toEqual([0, 1, 0, 1, 3, -2]);
});

test('turning back gives the points of before', () => {
  // About (1, 1, 1) by 120 degrees, then squeezed.
  const turn = turnOf([0, 2, 0, 0, 0, 0, 1, 0, 0.5, 0, 0, 0, 0, 0, 0, 1]);
  const points = Float32Array.of(0.25, -1, 4, 7, 0.5, -3);
  const there = turned(points, turn);
  expect(rounded(there)).not.toEqual(rounded(points));
  expect(rounded(turned(there, turn, true))).toEqual(rounded(points));
});

test('the turn of a mirrored node is a rotation that keeps what is up', () => {
  const turn = turnOf([-1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 0, 0, 1])!;
  const [a, b, c, d, e, f, g, h, i] = turn;
  expect(a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)).toBeCloseTo(1);
  // The mesh's y axis goes to z, and -z of the mesh is up.
  expect(rounded(turned(Float32Array.of(0, 1, 0), turn))).toEqual([0, 0, 1]);
});

test('a matrix without extent has no turn', () => {
  expect(turnOf(new Array<number>(16).fill(0))).toBeNull();
  expect(turnOf(new Array<number>(16).fill(NaN))).toBeNull();
});

test('ends are named as the scene shows them', () => {
  expect(endNames(IDENTITY, 1)).toEqual({ low: 'Bottom', high: 'Top' });
  expect(endNames(IDENTITY, 0)).toEqual({ low: 'Left end', high: 'Right end' });
  expect(endNames(Z_UP, 2)).toEqual({ low: 'Bottom', high: 'Top' });
  expect(endNames(Z_UP, 1)).toEqual({ low: 'Front end', high: 'Back end' });
});
