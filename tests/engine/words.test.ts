import { describe, expect, it } from 'vitest';
import { facesChange } from '../../web/cli/words';
import { besideLimit, excerpt, grouped, quotedJson } from '../../web/engine/core/words';

describe('a whole number', () => {
  it.each([0, 7, 999, 1000, 12345, 123456, 1234567, -999, -1000, -1234567, Number.MAX_SAFE_INTEGER])(
    'is written as toLocaleString writes it: %d',
    (value) => expect(grouped(value)).toBe(value.toLocaleString('en-US')),
  );
});

it('has its noun in the plural only if it is not one', () => {
  expect(facesChange(1800, 1200)).toBe('1,800 -> 1,200 faces (-33.3 %)');
  expect(facesChange(800, 1)).toBe('800 -> 1 face (-99.9 %)');
});

it('has enough decimals beside a limit to tell the two apart', () => {
  expect([0.5, 4, 0.1].map((limit) => besideLimit(0.0987, limit))).toEqual(['0.10', '0.10', '0.10']);
  expect(besideLimit(0.00012, 0.0001)).toBe('0.00012');
  expect(besideLimit(0.2479, 0.25)).toBe('0.248');
  expect(besideLimit(1.5, 1e-30)).toMatch(/^1\.50+$/);
});

describe('what a sentence quotes of a file', () => {
  it('is whole where it is short', () => {
    expect(excerpt('a.bin')).toBe('a.bin');
    expect(excerpt('x'.repeat(100))).toBe('x'.repeat(100));
  });

  it('is the beginning of a long text, and never half a letter', () => {
    expect(excerpt('x'.repeat(101))).toBe(`${'x'.repeat(100)}...`);
    expect(excerpt(`${'x'.repeat(99)}😀y`)).toBe(`${'x'.repeat(99)}...`);
    expect(excerpt('😀'.repeat(60))).toBe(`${'😀'.repeat(50)}...`);
  });

  it('keeps its quotation marks where it is a text in JSON', () => {
    expect(quotedJson('x'.repeat(101))).toBe(`"${'x'.repeat(100)}..."`);
    expect(quotedJson({ a: [1] })).toBe('{"a":[1]}');
    expect(quotedJson(['x'.repeat(200)])).toBe(`["${'x'.repeat(98)}...`);
  });
});
