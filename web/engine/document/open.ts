/** Opens the bytes of a GLB, glTF with its files, OBJ, STL, PLY or OFF, or of a ZIP of these, as a document with its bodies. */

import { isZip, unpacked } from './archive/read_zip';
import { describeConversion } from './checks/other_formats';
import { formatOfName } from './format_names';
import { openObj } from './formats/obj/open_obj';
import { withKnownLevels } from './facts/levels_of_detail';
import { isGlb } from './glb';
import { openGltf } from './gltf';
import type { Format, OpenModel, SourceFile } from './model';
import { isOff, readOff } from './off';
import { readPly } from './ply';
import { modelOfSurfaces } from './surface';
import { readSafely } from './checks/reading_failure';
import { loadDecoders } from './textures/pixels';
import { isBinaryStl, readStl } from './stl';

export type { Body, Format, OpenModel, PrimitiveSpan, SourceFile } from './model';

const SURFACE_READERS = { stl: readStl, ply: readPly, off: readOff };
const READABLE = 'a GLB, glTF, OBJ, STL, PLY or OFF file';

/**
 * Opens the only model among `files`; the others are its companions (buffers and textures of a .gltf, material libraries
 * and textures of an OBJ).
 * Throws an Error whose one sentence says what is wrong, where, and what to do; also for a glTF without triangles.
 */
export async function openModel(files: SourceFile[]): Promise<OpenModel> {
  const model = await openAnyModel(files);
  if (model.bodies.length === 0)
    throw new Error(`${model.name} ${describeEmpty(model)}: export it with a triangle mesh.`);
  return model;
}

/** Whether the file is a ZIP by its bytes but a scene format by its name, like USDZ. */
const isPackedScene = ({ name }: SourceFile): boolean =>
  !/\.zip$/i.test(name) && describeConversion(name) !== null;

/** As `openModel`, but a glTF without triangles opens as a model without bodies. */
export async function openAnyModel(files: SourceFile[]): Promise<OpenModel> {
  const archive = files.find((file) => isZip(file) && !isPackedScene(file));
  const all = archive ? await readSafely(archive.name, () => unpacked(files)) : files;
  const { file, format } = chooseModel(all);
  const model = await readSafely(file.name, async () => {
    if (format === 'glb' || format === 'gltf') return openGltf(file, format, all);
    if (format === 'obj') return openObj(file, all);
    return modelOfSurfaces(file.name, format, SURFACE_READERS[format](file));
  });
  await loadDecoders(model.document);
  return withKnownLevels(model);
}

/** Describes a glTF without triangles, in words that follow its name. */
export function describeEmpty({ document, notes }: OpenModel): string {
  if (document.getRoot().listMeshes().length === 0) return 'has no mesh';
  return `has no triangles (${notes.join('; ')})`;
}

function chooseModel(files: SourceFile[]): { file: SourceFile; format: Format } {
  if (files.length === 0) throw new Error(`There is no file: choose ${READABLE}.`);
  const models = files.filter((file) => formatOfName(file.name) !== null);
  if (models.length > 1) {
    const names = models.map((file) => file.name).join(', ');
    throw new Error(`There are ${models.length} models (${names}): open one at a time.`);
  }
  const file = models[0] ?? files[0];
  if (file.bytes.length === 0 && (models.length > 0 || files.length === 1))
    throw new Error(`${file.name} is empty: export it again.`);
  const format = formatOfBytes(file.bytes) ?? formatOfName(file.name) ?? guessFormat(file.bytes);
  if (format === null || (models.length === 0 && files.length > 1)) {
    for (const { name } of files) {
      const way = describeConversion(name);
      if (way !== null) throw new Error(way);
    }
    const what = files.length === 1 ? `${file.name} is not` : `None of the ${files.length} files is`;
    throw new Error(`${what} a mesh that can be read: open ${READABLE}.`);
  }
  return { file, format };
}

/** The format if the first bytes identify it, otherwise null. */
function formatOfBytes(bytes: Uint8Array): Format | null {
  if (isGlb(bytes)) return 'glb';
  return /^ply[\r\n]$/.test(String.fromCharCode(...bytes.subarray(0, 4))) ? 'ply' : null;
}

/** The number of bytes that are examined at the start of a file without an ending, as from a pipe. */
const LOOKED_AT = 1 << 16;

/** Guesses the format of a file without an ending from its first bytes; null if they do not tell. */
function guessFormat(bytes: Uint8Array): Format | null {
  if (isBinaryStl(bytes)) return 'stl';
  const start = new TextDecoder().decode(bytes.subarray(0, LOOKED_AT));
  if (/^\s*\{/.test(start)) return 'gltf';
  if (/^\s*solid\b/i.test(start)) return 'stl';
  if (isOff(start)) return 'off';
  return /^v[ \t]+[-+.\d]/m.test(start) ? 'obj' : null;
}
