/** The paths at which the material libraries of an OBJ and the pictures of a library are searched, below the folder of the OBJ, in order. */

import { companionPath } from '../../checks/companions';

/** A larger library is not read: one with thousands of materials has a megabyte. */
export const MAX_LIBRARY_BYTES = 2 ** 23;

/**
 * Per library its paths. `statements`: what follows each `mtllib`. A library with the name of the OBJ comes last, as Blender's importer
 * takes it: files are renamed, and not all programs write `mtllib`.
 */
export function libraryPaths(main: string, statements: readonly string[]): string[][] {
  const own = main.replace(/^.*[/\\]/, '').replace(/(\.[^.]*)?$/, '.mtl');
  return [...namedLibraries(statements), own].map((name) => pathsOf([main], name));
}

/** Names can have blanks, and several can stand in one statement. */
export const namedLibraries = (statements: readonly string[]): string[] => [
  ...new Set(
    statements
      .flatMap((statement) => statement.match(/.+?(\.mtl"?(?=\s|$)|$)/gi) ?? [])
      .map((name) => name.replaceAll('"', '').trim())
      .filter((name) => name !== ''),
  ),
];

/** Libraries name pictures from their own folder, and some programs from that of the OBJ. */
export const picturePaths = (main: string, library: string, name: string): string[] =>
  pathsOf([library, main], name);

/** Paths beside one of these files; of a name with a foreign path, as from other machines, its last part there. */
function pathsOf(files: string[], name: string): string[] {
  const last = name.split(/[/\\]/).pop()!;
  const paths = [name, last].flatMap((one) => files.map((file) => besides(file, one)));
  return [...new Set([...paths, besides('', last)])].filter((path) => path !== null);
}

/** A path beside a file; null outside of the folder. Unlike addresses in a glTF, names here are not percent-encoded. */
const besides = (file: string, name: string): string | null =>
  companionPath(file, name.replaceAll('%', '%25'));

/** A file's own name as a path. */
export const pathOf = (name: string): string | null => besides('', name);
