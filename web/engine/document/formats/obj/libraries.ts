/** The materials that an OBJ uses, from the libraries that came with it. */

import { isSentence } from '../../checks/reading_failure';
import type { SourceFile } from '../../model';
import { libraryPaths, MAX_LIBRARY_BYTES, namedLibraries } from './companion_paths';
import type { Omissions } from './omissions';
import { readMtl } from './mtl';
import type { MtlMaterial } from './mtl';
import type { NamedFiles } from './named_files';

/** A material with the name of its library, from which its pictures are resolved. */
export interface FoundMaterial {
  material: MtlMaterial;
  library: string;
}

interface MaterialRequest {
  /** the name of the OBJ */
  main: string;
  /** what follows each `mtllib` */
  statements: readonly string[];
  /** names of the materials that faces have */
  used: ReadonlySet<string>;
}

/**
 * The materials by name, each from the first library that defines it. If none defines a material, a note says which libraries are
 * missing, or that none of those found has it. `unnamed`: the library with the OBJ's own name, where
 * it has materials and no statement names it.
 */
export function findMaterials(
  { main, statements, used }: MaterialRequest,
  files: NamedFiles,
  omissions: Omissions,
): { found: Map<string, FoundMaterial>; unnamed: string | null } {
  const found = new Map<string, FoundMaterial>();
  const libraries = libraryPaths(main, statements).map((paths) => files.find(paths));
  for (const library of new Set(libraries)) {
    if (!library) continue;
    for (const [name, material] of readLibrary(library, used, omissions))
      if (!found.has(name)) found.set(name, { material, library: library.name });
  }
  const unknown = [...used].filter((name) => !found.has(name));
  // The last one may be missing, since nothing names it.
  const missing = namedLibraries(statements).filter((_, i) => libraries[i] === null);
  if (unknown.length > 0) omissions.addMissingLibraries(missing);
  if (missing.length === 0 && libraries.some((library) => library !== null))
    for (const name of unknown) omissions.add('undefined', name);
  const last = libraries[libraries.length - 1];
  const isUnnamed = last !== null && libraries.indexOf(last) === libraries.length - 1;
  const hasMaterials = [...found.values()].some(({ library }) => library === last?.name);
  return {
    found,
    unnamed: isUnnamed && hasMaterials ? last.name.replace(/^.*[/\\]/, '') : null,
  };
}

/** Empty where it is too large or not text. */
function readLibrary(
  library: SourceFile,
  used: ReadonlySet<string>,
  omissions: Omissions,
): Map<string, MtlMaterial> {
  try {
    if (library.bytes.length <= MAX_LIBRARY_BYTES) return readMtl(library, used);
  } catch (error) {
    if (!isSentence(error)) throw error;
  }
  omissions.add('library', library.name);
  return new Map();
}
