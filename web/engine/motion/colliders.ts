/**
 * What a simulated body can touch, as text: `ground:HEIGHT` (a floor across y), `ball:x,y,z,R`,
 * `capsule:x0,y0,z0,x1,y1,z1,R` (around a segment), joined by `+`; in units of the body.
 */

import type { Collider, CollisionScene } from '../core/core';

const FORMS = 'ground:HEIGHT, ball:x,y,z,R or capsule:x0,y0,z0,x1,y1,z1,R, joined by +';

/** Nothing for an empty text; of several floors the last one. Throws one sentence that shows the forms. */
export function parseColliders(text: string): CollisionScene {
  const collisionScene: CollisionScene = { ground: null, colliders: [] };
  if (text === '') return collisionScene;
  for (const term of text.split('+')) {
    const found = parseTerm(term);
    if (typeof found === 'number') collisionScene.ground = found;
    else collisionScene.colliders.push(found);
  }
  return collisionScene;
}

function parseTerm(term: string): number | Collider {
  const colon = term.indexOf(':');
  const kind = term.slice(0, Math.max(0, colon));
  const words = term.slice(colon + 1).split(',');
  const numbers = words.map((word) => (word.trim() === '' ? NaN : Number(word)));
  const isGood = numbers.every(Number.isFinite);
  if (isGood && kind === 'ground' && numbers.length === 1) return numbers[0];
  const radius = numbers[numbers.length - 1];
  const vector = (i: number): [number, number, number] => [numbers[i], numbers[i + 1], numbers[i + 2]];
  if (isGood && radius > 0) {
    if (kind === 'ball' && numbers.length === 4) return { from: vector(0), to: vector(0), radius };
    if (kind === 'capsule' && numbers.length === 7) return { from: vector(0), to: vector(3), radius };
  }
  throw new Error(`--colliders has "${term}": give ${FORMS}.`);
}
