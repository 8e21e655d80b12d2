import { describe, expect, it } from 'vitest';
import { NONE } from '../../web/engine/core/core';
import {
  editPins,
  hasPins,
  pinValue,
  sourcesOfVertices,
  withPins,
} from '../../web/engine/settings/pin_edits';

/** Source vertices 0 and 2 are welded; no face uses source vertex 3. */
const vertexOfSource = Uint32Array.from([0, 1, 0, NONE, 2, 3]);
const edit = (text: string, pinned: number[], isPinning: boolean, vertices: number[]) =>
  editPins(text, Uint32Array.from(pinned), { isPinning, vertices }, vertexOfSource);

describe('the text of the pins', () => {
  it('gains and loses whole terms', () => {
    expect(withPins('', 'low', '6')).toBe('low:6');
    expect(withPins('low:6', 'high', '6')).toBe('low:6+high:6');
    expect(withPins('low:6+vertices:1+low:3', 'low', '')).toBe('vertices:1');
    expect(hasPins('low:6', 'low')).toBe(true);
    expect(hasPins('', 'low')).toBe(false);
    expect(pinValue('low:6+attribute:_FIXED', 'attribute')).toBe('_FIXED');
    expect(pinValue('low:6', 'attribute')).toBe('');
  });

  it('names vertices by their numbers in the file, welded ones by the lowest', () => {
    expect([...sourcesOfVertices(vertexOfSource)]).toEqual([
      [0, 0],
      [1, 1],
      [2, 4],
      [3, 5],
    ]);
    expect(edit('', [], true, [2, 0])).toBe('vertices:0,4');
    expect(edit('vertices:2', [0], true, [3])).toBe('vertices:0,5');
  });

  it('does not name vertices that another term pins already', () => {
    expect(edit('low:6', [0, 1], true, [1, 2])).toBe('low:6+vertices:4');
    expect(edit('low:6', [0, 1], true, [1])).toBe('low:6');
  });

  it('loses vertices that were picked, and keeps the other terms', () => {
    expect(edit('low:6+vertices:4,5', [0, 2, 3], false, [3])).toBe('low:6+vertices:4');
    expect(edit('low:6+vertices:4', [0, 2], false, [2])).toBe('low:6');
    expect(edit('low:6+vertices:4', [0, 2], false, [1])).toBe('low:6+vertices:4');
  });

  it('becomes a list of the vertices left if a vertex of another term is unpinned', () => {
    expect(edit('low:6+vertices:4', [0, 1, 2], false, [1])).toBe('vertices:0,4');
    expect(edit('low:6', [1], false, [1])).toBe('');
  });
});
