/** Extensions of a file that cannot be carried over to a result. */

import type { OpenModel } from '../model';
import { uncarriedExtensions } from '../prune';
import { describePath, meshOfForeign } from './foreign';

export interface RefusedExtension {
  name: string;
  /** the object that has it, in words: "mesh 3, primitive 0" */
  where: string;
  /** a clause: "whose vertices change" */
  why: string;
  /** the body whose change rules it out; null where it belongs to no body */
  body: string | null;
}

/** One for each extension and body. `chosen`: numbers of the bodies that change. */
export function refusedExtensions(model: OpenModel, chosen: readonly number[]): RefusedExtension[] {
  const refused: RefusedExtension[] = [];
  const add = (one: RefusedExtension) => {
    if (!refused.some(({ name, body }) => name === one.name && body === one.body)) refused.push(one);
  };
  const nameOfMesh = new Map(chosen.map((i) => [model.bodies[i].mesh, model.bodies[i].name]));
  for (const extension of model.foreign?.extensions ?? []) {
    const { name, path, obstacle } = extension;
    const body = nameOfMesh.get(meshOfForeign(extension) ?? -1) ?? null;
    const where = describePath(path);
    if (body !== null) add({ name, where, why: 'whose vertices change', body });
    else if (obstacle !== null) add({ name, where, why: obstacle, body });
  }
  const meshes = model.document.getRoot().listMeshes();
  for (const i of chosen) {
    const { mesh, spans, name: body } = model.bodies[i];
    const primitives = meshes[mesh].listPrimitives();
    for (const { primitive } of spans)
      for (const name of uncarriedExtensions(primitives[primitive]))
        add({ name, where: `mesh ${mesh}, primitive ${primitive}`, why: 'whose vertices change', body });
  }
  return refused;
}
