/** What an export would lose, said before it is done. */

import type { Document, Primitive } from '@gltf-transform/core';
import { counted } from './model';
import type { OpenModel } from './model';

/** Kinds of vertex attributes, in the order they are named. */
const ATTRIBUTES: [RegExp, string][] = [
  [/^TEXCOORD_/, 'UV coordinates'],
  [/^TANGENT$/, 'tangents'],
  [/^COLOR_/, 'vertex colours'],
];

/**
 * What the model has and `exportGlb` leaves out where bodies are replaced, in plain words: "UV coordinates",
 * "2 textures", "1 skin". Empty: nothing is lost.
 */
export function droppedByExport(model: OpenModel): string[] {
  const { document } = model;
  const root = document.getRoot();
  const primitives = optimizedPrimitives(model);
  const custom = new Set(
    primitives.flatMap((one) => one.listSemantics().filter((name) => name.startsWith('_'))),
  );
  const targets = Math.max(0, ...primitives.map((primitive) => primitive.listTargets().length));
  const extensions = new Set(
    primitives.flatMap((one) => one.listExtensions().map((extension) => extension.extensionName)),
  );
  extensions.delete('KHR_materials_variants');
  return [
    ...ATTRIBUTES.filter(([pattern]) => hasAttribute(primitives, pattern)).map(([, name]) => name),
    ...[...custom].map((name) => `attribute ${name}`),
    ...countedWhereAny(texturesOf(document), 'texture'),
    ...countedWhereAny(targets, 'morph target'),
    ...countedWhereAny(root.listSkins().length, 'skin'),
    ...countedWhereAny(root.listAnimations().length, 'animation'),
    ...[...extensions].map((name) => `extension ${name}`),
    ...model.unread,
  ];
}

function optimizedPrimitives({ document, bodies }: OpenModel): Primitive[] {
  const meshes = document.getRoot().listMeshes();
  return bodies.flatMap(({ mesh, spans }) => {
    const primitives = meshes[mesh].listPrimitives();
    return spans.map(({ primitive }) => primitives[primitive]);
  });
}

function hasAttribute(primitives: Primitive[], pattern: RegExp): boolean {
  return primitives.some((primitive) => primitive.listSemantics().some((name) => pattern.test(name)));
}

const countedWhereAny = (count: number, one: string): string[] => (count > 0 ? [counted(count, one)] : []);

const texturesOf = (document: Document): number => document.getRoot().listTextures().length;
