/** Opens an OBJ with its material libraries and their pictures. */

import type { Document, Material } from '@gltf-transform/core';
import type { OpenModel, SourceFile } from '../../model';
import { readObj } from '../../obj';
import { modelOfSurfaces, plainMaterial } from '../../surface';
import type { MaterialMaker, SurfaceFile } from '../../surface';
import { carriedFiles } from './carried';
import { applyMtl, hasMaps } from './gltf_materials';
import { Omissions } from './omissions';
import { findMaterials } from './libraries';
import type { FoundMaterial } from './libraries';
import { NamedFiles } from './named_files';
import { Pictures } from './pictures';

/** The libraries and pictures are looked for among `files`. Throws an Error that names the line of the OBJ. */
export function openObj(file: SourceFile, files: SourceFile[]): OpenModel {
  const surfaces = readObj(file);
  const { libraries: statements = [] } = surfaces;
  const [named, omissions] = [new NamedFiles(files), new Omissions()];
  const asked = { main: file.name, statements, used: usedMaterials(surfaces) };
  const { found, unnamed } = findMaterials(asked, named, omissions);
  const model = modelOfSurfaces(file.name, 'obj', surfaces, (document) =>
    materialMaker(document, found, {
      pictures: new Pictures(document, file.name, named, omissions),
      omissions,
    }),
  );
  const libraries = unnamed !== null && statements.length > 0 ? [...statements, unnamed] : statements;
  const { files: carried, outside } = carriedFiles(file.name, libraries, named);
  return {
    ...model,
    notes: [...model.notes, ...omissions.notes()],
    libraries,
    carried,
    outside,
  };
}

/** A material with textures is another one where the surface has no UVs. */
function materialMaker(
  document: Document,
  found: Map<string, FoundMaterial>,
  context: { pictures: Pictures; omissions: Omissions },
): MaterialMaker {
  const made = new Map<string, Material>();
  return (name, hasUvs) => {
    const known = found.get(name);
    const isTextured = hasUvs && known !== undefined && hasMaps(known);
    const key = `${isTextured ? 'textured' : 'plain'} ${name}`;
    if (!made.has(key)) {
      const material = plainMaterial(document, name);
      if (known) applyMtl(material, known, { ...context, hasUvs });
      made.set(key, material);
    }
    return made.get(key)!;
  };
}

const usedMaterials = ({ surfaces }: SurfaceFile): Set<string> =>
  new Set(
    surfaces.flatMap(({ parts = [] }) => parts.map(({ material }) => material)).filter((name) => name !== ''),
  );
