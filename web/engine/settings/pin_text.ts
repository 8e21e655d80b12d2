/**
 * Sets of vertices as text, for the settings `pins` and `lock`: `low:6`, `high:6` (the lowest, highest 6 %
 * along the longest axis of the bounding box), `box:x0,y0,z0,x1,y1,z1` (units of the body), `attribute:NAME` (where its
 * first component is above one half), `vertices:i,j` (numbers in the file, from 0), joined by `+`.
 */

import type { SettingName } from './table';
import { numbersIn, parseTerms } from './terms';

export type PinTerm =
  | { kind: 'low' | 'high'; percent: number }
  /** `low[c] <= high[c]` for each coordinate */
  | { kind: 'box'; low: number[]; high: number[] }
  | { kind: 'attribute'; name: string }
  | { kind: 'vertices'; vertices: number[] };

export type PinTerms = readonly PinTerm[];

const FORMS = 'low:PCT, high:PCT, box:x0,y0,z0,x1,y1,z1, attribute:NAME or vertices:i,j, joined by +';

/** The last text of each setting and its terms: every stage that resolves the same pins gets the same terms. */
const parsed = new Map<SettingName, { text: string; terms: PinTerms }>();

/** The terms of a text; none for an empty one. Throws SettingError about `setting`, with the forms. */
export function parsePins(text: string, setting: SettingName = 'pins'): PinTerms {
  const last = parsed.get(setting);
  if (last?.text === text) return last.terms;
  const terms = parseTerms(text, { setting, forms: FORMS, termOf });
  parsed.set(setting, { text, terms });
  return terms;
}

/** See TermRules. */
function termOf(kind: string, value: string): PinTerm | string | null {
  if (value === '') return null;
  if (kind === 'attribute') return { kind, name: value };
  const numbers = numbersIn(value);
  if (numbers === null) return null;
  if (kind === 'low' || kind === 'high') {
    const [percent] = numbers;
    if (numbers.length !== 1) return null;
    return percent >= 0 && percent <= 100 ? { kind, percent } : 'a percentage from 0 to 100';
  }
  if (kind === 'box') return numbers.length === 6 ? boxOf(numbers.slice(0, 3), numbers.slice(3)) : null;
  if (kind !== 'vertices') return null;
  const areVertices = numbers.every((n) => Number.isInteger(n) && n >= 0);
  return areVertices ? { kind, vertices: numbers } : 'numbers of vertices, which are whole and begin at 0';
}

/** The box of two opposite corners, in either order. */
const boxOf = (a: number[], b: number[]): PinTerm => ({
  kind: 'box',
  low: a.map((x, c) => Math.min(x, b[c])),
  high: a.map((x, c) => Math.max(x, b[c])),
});
