/** The files on the disk that belong to an OBJ: material libraries, and the pictures that these name. */

import { existsSync, readFileSync, statSync } from 'node:fs';
import { dirname, join } from 'node:path';
import type { SourceFile } from '../../engine/document/open';
import {
  libraryPaths,
  MAX_LIBRARY_BYTES,
  namedLibraries,
  picturePaths,
} from '../../engine/document/formats/obj/companion_paths';
import { READ_MAPS } from '../../engine/document/formats/obj/gltf_materials';
import { picturesNamed, readMtl } from '../../engine/document/formats/obj/mtl';
import { FoundFiles } from './found_files';

/** Bytes of a line that are looked at. */
const MAX_LINE_BYTES = 4096;

export interface ObjCompanions {
  /** paths, from the folder of the OBJ, of libraries and of pictures of the materials that it uses */
  read: string[];
  /** paths, from there, of all pictures that its libraries name */
  pictures: string[];
  /** paths of all that it and its libraries name, also outside of the folder */
  named: string[];
}

/** What is read lies in or below `folders`. Nothing for other formats. */
export function objCompanions(path: string, main: SourceFile, folders: string[]): ObjCompanions {
  if (!main.name.toLowerCase().endsWith('.obj')) return { read: [], pictures: [], named: [] };
  const statements = statementsOf(main, 'mtllib');
  const besides = (name: string) => join(dirname(path), name);
  const files = new FoundFiles(dirname(path), folders);
  const wanted = libraryPaths(main.name, statements);
  const ofStatements = existing(wanted.slice(0, -1).map((paths) => files.find(paths, true)));
  // Nothing names the last one.
  const libraries = existing([...ofStatements, files.find(wanted[wanted.length - 1], false)]);
  const used = new Set(statementsOf(main, 'usemtl'));
  const [read, all] = [new Set(libraries), new Set<string>()];
  const named = [...ofStatements, ...namedLibraries(statements)].map(besides);
  for (const library of libraries) {
    const file = libraryAt(besides(library), library);
    if (!file) continue;
    const pictureAt = (picture: string) => files.find(picturePaths(main.name, library, picture), true);
    existing(picturesRead(file, used).map(pictureAt)).forEach((picture) => read.add(picture));
    if (!ofStatements.includes(library)) continue;
    const pictures = picturesIn(file);
    existing(pictures.map(pictureAt)).forEach((picture) => all.add(picture));
    named.push(...pictures.map((picture) => join(dirname(besides(library)), picture)));
  }
  named.push(...[...all].map(besides));
  return {
    read: [...read],
    pictures: [...all],
    named: [...new Set(named)].filter((one) => existsSync(one)),
  };
}

/** What follows each statement of this keyword, as far as whole lines say: more than those that the reader takes, and never fewer. */
function statementsOf({ bytes }: SourceFile, keyword: string): string[] {
  const content = Buffer.from(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const found = new Set<string>();
  for (let at = content.indexOf(keyword); at >= 0; at = content.indexOf(keyword, at + 1)) {
    const line = content.toString('utf8', at, at + MAX_LINE_BYTES).split(/[\r\n]/, 1)[0];
    found.add(line.slice(keyword.length).trim());
  }
  return [...found];
}

const existing = (paths: (string | null)[]): string[] => [...new Set(paths.filter((path) => path !== null))];

/** Null where it is too large to be read. */
function libraryAt(path: string, name: string): SourceFile | null {
  return statSync(path).size > MAX_LIBRARY_BYTES ? null : { name, bytes: new Uint8Array(readFileSync(path)) };
}

const picturesRead = (library: SourceFile, used: ReadonlySet<string>): string[] =>
  ofText(() =>
    [...readMtl(library, used).values()].flatMap(({ maps }) =>
      READ_MAPS.map((keyword) => maps.get(keyword)?.name).filter((name) => name !== undefined),
    ),
  );

const picturesIn = (library: SourceFile): string[] => ofText(() => picturesNamed(library));

/** Nothing where the library is no text: the reader says so. */
function ofText(read: () => string[]): string[] {
  try {
    return [...new Set(read())];
  } catch {
    return [];
  }
}
