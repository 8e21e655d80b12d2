/** The files that an OBJ needs beside it when it is written to another folder and still refers to the libraries of its input. */

import { isSentence } from '../../checks/reading_failure';
import type { SourceFile } from '../../model';
import { MAX_LIBRARY_BYTES, namedLibraries, libraryPaths, pathOf, picturePaths } from './companion_paths';
import { picturesNamed } from './mtl';
import type { NamedFiles } from './named_files';

export interface Carried {
  /** libraries and the pictures that these name, under their paths from the folder of the OBJ */
  files: SourceFile[];
  /** names of libraries and pictures that came from outside of its folder, and have no such path */
  outside: string[];
}

/** `main`: the name of the OBJ. `statements`: what follows each `mtllib`. */
export function carriedFiles(main: string, statements: readonly string[], files: NamedFiles): Carried {
  const paths = libraryPaths(main, statements);
  const carried = new Map<string, SourceFile>();
  const outside = new Set<string>();
  const add = (file: SourceFile): void => {
    const path = pathBelow(main, file.name);
    if (file.name === main) return;
    if (path === null) outside.add(file.name);
    else carried.set(path, { name: path, bytes: file.bytes });
  };
  namedLibraries(statements).forEach((_, i) => {
    const library = files.find(paths[i]);
    if (!library) return;
    add(library);
    for (const picture of picturesOf(library)) {
      const file = files.find(picturePaths(main, library.name, picture));
      if (file) add(file);
    }
  });
  return { files: [...carried.values()], outside: [...outside] };
}

/** The path of a file from the folder of `main`; null where it is not below. */
function pathBelow(main: string, name: string): string | null {
  const [own, path] = [pathOf(main), pathOf(name)];
  const folder = own?.replace(/[^/]*$/, '') ?? '';
  return path?.startsWith(folder) ? path.slice(folder.length) : null;
}

/** None where the library is too large or not text, since it is not read then. */
function picturesOf(library: SourceFile): string[] {
  if (library.bytes.length > MAX_LIBRARY_BYTES) return [];
  try {
    return picturesNamed(library);
  } catch (error) {
    if (!isSentence(error)) throw error;
    return [];
  }
}
