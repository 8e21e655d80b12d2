/** Which bodies of a file are worked on; all others are left unchanged. */

import type { Body, OpenModel } from '../document/model';
import { matchesPattern } from '../settings/name_pattern';
import type { Settings } from '../settings/options';

export type SelectionSettings = Pick<Settings, 'mesh' | 'materialName' | 'exclude'>;

/** At most so many names stand in a sentence. */
const NAMES_SHOWN = 20;

/**
 * The numbers of the bodies that are chosen, ascending. A body with several materials is chosen by material only where all of
 * them agree, and excluded where one does, so that nothing changes that was not meant. Throws an Error with one sentence where
 * no body is left.
 */
export function chosenBodies(model: OpenModel, settings: SelectionSettings): number[] {
  const { mesh, materialName, exclude } = settings;
  const all = model.bodies.map((body, i) => ({ i, name: body.name, materials: materialsOf(model, body) }));
  const ofName = all.filter(({ name }) => mesh === '' || matchesPattern(mesh, name));
  if (ofName.length === 0)
    throw refusal(
      model,
      `"${mesh}"`,
      all.map(({ name }) => name),
    );
  const ofMaterial = ofName.filter(
    ({ materials }) => materialName === '' || materials.every((name) => matchesPattern(materialName, name)),
  );
  if (ofMaterial.length === 0)
    throw refusal(
      model,
      `of material "${materialName}" alone`,
      ofName.flatMap(({ materials }) => materials),
    );
  const chosen = ofMaterial.filter(
    ({ name, materials }) =>
      exclude === '' || ![name, ...materials].some((one) => matchesPattern(exclude, one)),
  );
  if (chosen.length === 0)
    throw refusal(
      model,
      `besides "${exclude}"`,
      ofMaterial.map(({ name }) => name),
    );
  return chosen.map(({ i }) => i);
}

/** Distinct names of the materials of a body; '' for faces without one. */
function materialsOf({ document }: OpenModel, { mesh, spans }: Body): string[] {
  const primitives = document.getRoot().listMeshes()[mesh].listPrimitives();
  return [...new Set(spans.map(({ primitive }) => primitives[primitive].getMaterial()?.getName() ?? ''))];
}

function refusal({ name }: OpenModel, what: string, found: string[]): Error {
  const names = [...new Set(found)].map((one) => (one === '' ? 'faces without a material' : `"${one}"`));
  const more = names.length > NAMES_SHOWN ? `, and ${names.length - NAMES_SHOWN} more` : '';
  return new Error(`${name} has no body ${what}: it has ${names.slice(0, NAMES_SHOWN).join(', ')}${more}.`);
}
