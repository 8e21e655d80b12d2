// The dots on pinned vertices.

import { expect, test } from 'vitest';
import { Dots } from '../../web/app/viewer/dots';

test('dots are smaller in a low picture, and as large as ever in a high one', () => {
  const dots = new Dots(2);
  dots.setPoints(new Float32Array(3));
  const size = () => dots.points.material.uniforms.size.value as number;
  dots.fit(600);
  expect(size()).toBe(20);
  dots.fit(225);
  expect(size()).toBe(15);
  dots.fit(50);
  expect(size()).toBe(10);
  dots.fit(300);
  expect(size()).toBe(20);
});
