/** Lists what an export would lose, before it is made. */

import type { Mesh, Primitive } from '@gltf-transform/core';
import { counted } from '../core/words';
import type { OpenModel } from './model';
import { refusedExtensions } from './extensions/refused';

/**
 * The content of the model that `exportGlb` drops where it replaces bodies, in plain words: "extension EXT_mesh_features",
 * "2 morph targets"; empty if nothing is lost. With `replacesTargets`, shapes replace the bodies' own morph targets.
 */
export function droppedByExport(model: OpenModel, replacesTargets = false): string[] {
  const meshes = meshesOf(model);
  const primitives = optimizedPrimitives(model);
  const targets = Math.max(0, ...primitives.map((primitive) => primitive.listTargets().length));
  const refused = refusedExtensions(
    model,
    model.bodies.map((_, i) => i),
  );
  const isMorphed = (mesh: Mesh | null | undefined) => mesh && meshes.includes(mesh);
  const channels = model.document
    .getRoot()
    .listAnimations()
    .flatMap((animation) => animation.listChannels())
    .filter(
      (channel) => channel.getTargetPath() === 'weights' && isMorphed(channel.getTargetNode()?.getMesh()),
    );
  return [
    ...(replacesTargets ? countedWhereAny(targets, 'morph target') : []),
    ...(replacesTargets
      ? countedWhereAny(channels.length, 'animation of morph targets', 'animations of morph targets')
      : []),
    ...[...new Set(refused.map(({ name }) => name))].map((name) => `extension ${name}`),
    ...model.unread,
  ];
}

function meshesOf({ document, bodies }: OpenModel): Mesh[] {
  const meshes = document.getRoot().listMeshes();
  return bodies.map(({ mesh }) => meshes[mesh]);
}

function optimizedPrimitives(model: OpenModel): Primitive[] {
  return meshesOf(model).flatMap((mesh, i) => {
    const primitives = mesh.listPrimitives();
    return model.bodies[i].spans.map(({ primitive }) => primitives[primitive]);
  });
}

const countedWhereAny = (count: number, one: string, many?: string): string[] =>
  count > 0 ? [counted(count, one, many)] : [];
