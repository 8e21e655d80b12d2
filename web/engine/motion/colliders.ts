/** What a simulated body can touch, from the terms of a text; see settings/collider_text.ts. */

import type { Collider, CollisionScene } from '../core/core';
import { parseColliders } from '../settings/collider_text';
import type { ColliderTerm } from '../settings/collider_text';

/** The scene that a text stands for: nothing for an empty one, the last floor of several. Throws SettingError. */
export function collisionSceneOf(text: string): CollisionScene {
  const terms = parseColliders(text);
  const floors = terms.flatMap((term) => (term.kind === 'ground' ? [term.height] : []));
  return { ground: floors.at(-1) ?? null, colliders: terms.flatMap(collidersOf) };
}

function collidersOf(term: ColliderTerm): Collider[] {
  if (term.kind === 'ground') return [];
  if (term.kind === 'capsule') return [{ from: term.from, to: term.to, radius: term.radius }];
  // A ball is a capsule of no length.
  return [{ from: term.centre, to: [...term.centre], radius: term.radius }];
}
