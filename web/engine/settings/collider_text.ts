/**
 * What a simulated body can touch, as text: `ground:HEIGHT` (a floor across y), `ball:x,y,z,R`,
 * `capsule:x0,y0,z0,x1,y1,z1,R` (around a segment), joined by `+`; in units of the body.
 */

import { numbersIn, parseTerms } from './terms';

type Point = [number, number, number];

export type ColliderTerm =
  | { kind: 'ground'; height: number }
  | { kind: 'ball'; centre: Point; radius: number }
  | { kind: 'capsule'; from: Point; to: Point; radius: number };

const FORMS = 'ground:HEIGHT, ball:x,y,z,R or capsule:x0,y0,z0,x1,y1,z1,R, joined by +';

/** The terms of a text; none for an empty one. Throws SettingError with the forms. */
export const parseColliders = (text: string): ColliderTerm[] =>
  parseTerms(text, { setting: 'colliders', forms: FORMS, termOf });

/** See TermRules. */
function termOf(kind: string, value: string): ColliderTerm | string | null {
  const numbers = numbersIn(value);
  if (numbers === null) return null;
  if (kind === 'ground' && numbers.length === 1) return { kind, height: numbers[0] };
  const point = (i: number): Point => [numbers[i], numbers[i + 1], numbers[i + 2]];
  const isBall = kind === 'ball' && numbers.length === 4;
  if (!isBall && !(kind === 'capsule' && numbers.length === 7)) return null;
  const radius = numbers[numbers.length - 1];
  if (!(radius > 0)) return 'a radius above 0';
  return isBall
    ? { kind: 'ball', centre: point(0), radius }
    : { kind: 'capsule', from: point(0), to: point(3), radius };
}
