/** Where the material libraries of an OBJ and the pictures of a library can be: paths below the folder of the OBJ, first first. */

import { companionPath } from '../../checks/companions';

/** A larger library is not read: one with thousands of materials has a megabyte. */
export const MOST_LIBRARY_BYTES = 2 ** 23;

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

/** Beside one of these files; where the name leads elsewhere, as those of other machines do, the last part of it there. */
function pathsOf(files: string[], name: string): string[] {
  const last = name.split(/[/\\]/).pop()!;
  const paths = [name, last].flatMap((one) => files.map((file) => besides(file, one)));
  return [...new Set([...paths, besides('', last)])].filter((path) => path !== null);
}

/** Null where it is outside. Names in these files are not percent-encoded, as addresses in a glTF are. */
const besides = (file: string, name: string): string | null =>
  companionPath(file, name.replaceAll('%', '%25'));

/** A file's own name as a path. */
export const pathOf = (name: string): string | null => besides('', name);
