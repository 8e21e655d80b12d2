/** Opens the bytes of a GLB, glTF with its files, OBJ, STL or PLY as a document with its bodies. */

import { openGltf } from './gltf';
import type { Format, OpenModel, SourceFile } from './model';
import { readObj } from './obj';
import { readPly } from './ply';
import { modelOfSurfaces } from './surface';
import { readStl } from './stl';

export type { Body, Format, OpenModel, PrimitiveSpan, SourceFile } from './model';

const FORMATS: readonly Format[] = ['glb', 'gltf', 'obj', 'stl', 'ply'];
const READABLE = 'a GLB, glTF, OBJ, STL or PLY file';

/**
 * Opens the only model among `files`; the others are its companions (buffers and textures of a .gltf).
 * Throws an Error whose one sentence says what is wrong, where, and what to do.
 */
export async function openModel(files: SourceFile[]): Promise<OpenModel> {
  const { file, format } = chooseModel(files);
  if (format === 'glb' || format === 'gltf') return openGltf(file, format, files);
  if (format === 'obj') return modelOfSurfaces(file.name, format, readObj(file));
  return modelOfSurfaces(file.name, format, format === 'stl' ? readStl(file) : readPly(file));
}

function chooseModel(files: SourceFile[]): { file: SourceFile; format: Format } {
  if (files.length === 0) throw new Error(`There is no file: choose ${READABLE}.`);
  const models = files.filter((file) => formatOfName(file.name) !== null);
  if (models.length > 1) {
    const names = models.map((file) => file.name).join(', ');
    throw new Error(`There are ${models.length} models (${names}): open one at a time.`);
  }
  const file = models[0] ?? files[0];
  const format = formatOfBytes(file.bytes) ?? formatOfName(file.name);
  if (format === null || (models.length === 0 && files.length > 1)) {
    const what = files.length === 1 ? `${file.name} is not` : `None of the ${files.length} files is`;
    throw new Error(`${what} a mesh that can be read: open ${READABLE}.`);
  }
  if (file.bytes.length === 0) throw new Error(`${file.name} is empty: export it again.`);
  return { file, format };
}

function formatOfName(name: string): Format | null {
  const ending = name.toLowerCase().split('.').pop()!;
  return FORMATS.find((format) => format === ending) ?? null;
}

/** The format if the first bytes identify it, otherwise null. */
function formatOfBytes(bytes: Uint8Array): Format | null {
  const start = String.fromCharCode(...bytes.subarray(0, 4));
  if (start === 'glTF') return 'glb';
  return /^ply[\r\n]$/.test(start) ? 'ply' : null;
}
