/** The bodies of another model beside those of the original: in the same order, and in the space of the original's meshes. */

import { inverse, isSimilarity, product, scaleOf, transformed } from '../core/affine';
import { boundsOf } from '../core/mesh';
import type { Body, OpenModel } from '../document/model';
import { nodeMatrixOf } from '../document/placements';

/** A model with the bodies of it that take part. */
export interface ChosenModel {
  model: OpenModel;
  bodies: Body[];
}

export const chosenOf = (model: OpenModel, chosen: readonly number[]): ChosenModel => ({
  model,
  bodies: chosen.map((i) => model.bodies[i]),
});

/**
 * The other model with its chosen bodies alone, each at the place of its partner in the original: by name where both have the same
 * names, each once, otherwise by the order of their files. A body that its node scales or moves otherwise, as one of integers is, comes
 * into the space of the original's mesh where that brings the two clearly nearer. Nothing is paired where the numbers differ.
 */
export function pairedModel(original: ChosenModel, other: ChosenModel): OpenModel {
  const { model } = other;
  if (original.bodies.length !== other.bodies.length) return { ...model, bodies: other.bodies };
  const ordered = partnersByName(original.bodies, other.bodies) ?? other.bodies;
  const bodies = original.bodies.map((body, i) =>
    inSpaceOf({ model: original.model, body }, { model, body: ordered[i] }),
  );
  return { ...model, bodies };
}

/** null where the names of both are not the same, each once. */
function partnersByName(originals: Body[], others: Body[]): Body[] | null {
  const byName = new Map(others.map((body) => [body.name, body]));
  const names = new Set(originals.map(({ name }) => name));
  if (names.size < originals.length || byName.size < others.length) return null;
  const partners = originals.flatMap(({ name }) => byName.get(name) ?? []);
  return partners.length === others.length ? partners : null;
}

interface OfModel {
  model: OpenModel;
  body: Body;
}

/** The body as it is where its shape would not survive, or where it is there already. */
function inSpaceOf(original: OfModel, { model, body }: OfModel): Body {
  const [here, there] = [original, { model, body }].map(({ model: { document }, body: { mesh } }) =>
    nodeMatrixOf(document, document.getRoot().listMeshes()[mesh]),
  );
  const between = product(inverse(here), there);
  if (!isSimilarity(between)) return body;
  const positions = transformed(body.positions, between);
  const wanted = original.body.positions;
  if (2 * boxDistance(positions, wanted) >= boxDistance(body.positions, wanted)) return body;
  return {
    ...body,
    positions,
    scale: original.body.scale,
    own: { positions: body.positions, scale: scaleOf(between) },
  };
}

/** How far the corners of the bounding boxes are apart, at most along an axis. */
function boxDistance(a: Float32Array, b: Float32Array): number {
  const [one, other] = [boundsOf(a), boundsOf(b)];
  const differences = [0, 1, 2].flatMap((c) => [one.low[c] - other.low[c], one.high[c] - other.high[c]]);
  return Math.max(...differences.map(Math.abs));
}
