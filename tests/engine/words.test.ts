import { describe, expect, it } from 'vitest';
import { excerpt, quotedJson } from '../../web/engine/core/words';

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
