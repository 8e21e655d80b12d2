/** What a file has besides its triangles, as counts. */

import type { OpenModel } from '../model';

export interface FileContents {
  /** of the mesh with the most */
  uvSets: number;
  /** whether any vertex has a colour */
  vertexColours: boolean;
  materials: number;
  textures: number;
  skins: number;
  animations: number;
  /** of the mesh with the most */
  morphTargets: number;
}

export function contentsOf({ document }: OpenModel): FileContents {
  const root = document.getRoot();
  const primitives = root.listMeshes().flatMap((mesh) => mesh.listPrimitives());
  const most = (counts: number[]): number => counts.reduce((largest, one) => Math.max(largest, one), 0);
  const named = (prefix: string): number[] =>
    primitives.map(
      (primitive) => primitive.listSemantics().filter((semantic) => semantic.startsWith(prefix)).length,
    );
  return {
    uvSets: most(named('TEXCOORD_')),
    vertexColours: most(named('COLOR_')) > 0,
    materials: root.listMaterials().length,
    textures: root.listTextures().length,
    skins: root.listSkins().length,
    animations: root.listAnimations().length,
    morphTargets: most(primitives.map((primitive) => primitive.listTargets().length)),
  };
}
