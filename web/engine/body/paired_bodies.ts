/** The bodies of another model beside those of the original: in the same order, and in the space of the original's meshes. */

import { inverse, isSimilarity, product, scaleOf, transformed } from '../core/affine';
import type { Matrix } from '../core/affine';
import { boundsOf } from '../core/mesh';
import type { Body, OpenModel } from '../document/model';
import { meshMatrices } from '../document/placements';
import { chosenBodies } from './selection';
import type { SelectionSettings } from './selection';

/**
 * The other model with only its chosen bodies, each at the index of its partner in the original: by name where both have the same
 * names, each once, otherwise by the order of their files. A body that its node scales or moves differently, as with quantized positions, comes
 * into the space of the original's mesh where that brings the two clearly nearer. Nothing is paired where the numbers differ. Throws an
 * Error where the settings choose no body of a model.
 */
export function pairedModel(original: OpenModel, other: OpenModel, settings: SelectionSettings): OpenModel {
  const [originals, others] = [original, other].map((model) =>
    chosenBodies(model, settings).map((i) => model.bodies[i]),
  );
  if (originals.length !== others.length) return { ...other, bodies: others };
  const [here, there] = [original, other].map(({ document }) => meshMatrices(document));
  const ordered = partnersByName(originals, others) ?? others;
  const bodies = originals.map((body, i) => {
    const partner = ordered[i];
    return inSpaceOf(body, partner, product(inverse(here[body.mesh]), there[partner.mesh]));
  });
  return { ...other, bodies };
}

/** null where the names of both are not the same, each once. */
function partnersByName(originals: Body[], others: Body[]): Body[] | null {
  const byName = new Map(others.map((body) => [body.name, body]));
  const names = new Set(originals.map(({ name }) => name));
  if (names.size < originals.length || byName.size < others.length) return null;
  const partners = originals.flatMap(({ name }) => byName.get(name) ?? []);
  return partners.length === others.length ? partners : null;
}

/**
 * The body in the space of the original, into which the matrix maps; unchanged where the matrix would distort it, or where it is there
 * already.
 */
function inSpaceOf(original: Body, body: Body, between: Matrix): Body {
  if (!isSimilarity(between)) return body;
  const positions = transformed(body.positions, between);
  const wanted = original.positions;
  if (2 * boxDistance(positions, wanted) >= boxDistance(body.positions, wanted)) return body;
  return {
    ...body,
    positions,
    scale: original.scale,
    own: { positions: body.positions, scale: scaleOf(between) },
  };
}

/** How far the corners of the bounding boxes are apart, at most along an axis. */
function boxDistance(a: Float32Array, b: Float32Array): number {
  const [one, other] = [boundsOf(a), boundsOf(b)];
  const differences = [0, 1, 2].flatMap((c) => [one.low[c] - other.low[c], one.high[c] - other.high[c]]);
  return Math.max(...differences.map(Math.abs));
}
