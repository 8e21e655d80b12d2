import { expect, it } from 'vitest';
import { spanOf } from '../../web/engine/document/facts/spans';

const bodyOf = (firsts: number[]) => ({
  spans: firsts.map((first, primitive) => ({ primitive, first, firstVertex: 0, vertexCount: 0 })),
});

it('the span of a triangle is the last one that begins at or before it, as spans can be empty', () => {
  const body = bodyOf([0, 3, 3, 7, 7, 7, 8]);
  const found = Array.from({ length: 10 }, (_, t) => spanOf(body, t));
  expect(found).toEqual([0, 0, 0, 2, 2, 2, 2, 5, 6, 6]);
  expect(spanOf(bodyOf([0]), 5)).toBe(0);
});

it('the span of a triangle is found in few steps among many', () => {
  const body = bodyOf(Array.from({ length: 300_000 }, (_, i) => i));
  const found = Array.from({ length: 300_000 }, (_, t) => spanOf(body, t));
  expect(found.every((span, t) => span === t)).toBe(true);
}, 10_000);
