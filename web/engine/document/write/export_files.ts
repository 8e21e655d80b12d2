/** Writes a model with some bodies replaced, in any of the output formats. */

import type { Document, Mesh, Primitive } from '@gltf-transform/core';
import { additionsOf, copyForExport, GENERATOR, isSmoothed, replaceBodies } from '../export';
import type { ExportedBody } from '../export';
import type { OpenModel, SourceFile } from '../model';
import { tangentGenerator } from '../shading/tangents';
import { writeZip } from '../archive/write_zip';
import { compress } from './compression';
import type { Stored } from './compression';
import type { Compression } from '../../core/output_choices';
import { gltfCompanions, writeGlb, writeGltf } from './gltf_files';
import { insertLevels } from './level_nodes';
import type { MeshLevels } from './level_nodes';
import { objCompanions, writeObj } from './obj_files';
import { mainName } from './output_form';
import type { OutputForm, OutputManner } from './output_form';
import { writePly } from './ply_file';
import { rememberShared } from './shared_accessors';
import type { Companion } from './shared_images';

/** The levels of a body as they are written. */
export interface ExportedLevels {
  first: ExportedBody;
  /** the further levels that go into the same file, with their largest distances from the original, % of the diagonal */
  further: { exported: ExportedBody; deviation: number }[];
}

export interface FilesRequest {
  /** of the first file, without a folder */
  name: string;
  form: OutputForm;
  manner: OutputManner;
  fields: boolean;
}

/**
 * The file `name` and those beside it. `bodies[i]` replaces model.bodies[i]; null keeps a body as it is. See `exportGlb` for what is
 * kept; OBJ and PLY keep what their formats have. The same input gives the same bytes.
 */
export async function exportFiles(
  model: OpenModel,
  bodies: (ExportedLevels | null)[],
  { name, form, manner, fields }: FilesRequest,
): Promise<SourceFile[]> {
  const files = await filesOf(model, bodies, { name: mainName(name, form), form, manner, fields });
  return form.isZipped ? [{ name, bytes: writeZip(files, GENERATOR) }] : files;
}

/** The files that may be written beside `name`, known before the work. */
export function companionsOf(model: OpenModel, name: string, form: OutputForm): Companion[] {
  if (form.isZipped) return [];
  if (form.format === 'gltf') return gltfCompanions(model.document, name);
  return form.format === 'obj' ? objCompanions(model.document, name, model) : [];
}

async function filesOf(
  model: OpenModel,
  bodies: (ExportedLevels | null)[],
  { name, form: { format }, manner, fields }: FilesRequest,
): Promise<SourceFile[]> {
  const destination = await copyForExport(model);
  const { document } = destination;
  const isGltf = format === 'glb' || format === 'gltf';
  const stored = storedAs(manner.compression, isGltf ? model.stored : undefined);
  const { further, levels } = copiesOf(document, bodies);
  const shareAgain = rememberShared(document);
  const firsts = bodies.map((one) => one && one.first);
  const replaced = replaceBodies(destination, firsts, {
    fields,
    smoothed: isSmoothed(model),
    keepsStored: isGltf && manner.compression === 'like-input',
    keepsNumbers: !!model.foreign,
    tangents: isGltf ? await tangentGenerator(model.document) : null,
    further,
  });
  if (format === 'ply') return [writePly(document, name, GENERATOR)];
  const { libraries, carried } = model;
  if (format === 'obj') return writeObj(document, name, { libraries, carried, mark: GENERATOR });
  const inserted = manner.style === 'files' ? [] : insertLevels(document, levels, manner.style);
  const share = () => shareAgain(replaced);
  await compressFor(model, document, { stored, manner, replaced, share });
  const additions = {
    ...additionsOf(model, firsts),
    levels: inserted,
    isRatified: stored.isRatified ?? false,
    keepsCorners: manner.keepsOrder,
  };
  if (format === 'gltf') return writeGltf(document, name, additions);
  return [{ name, bytes: await writeGlb(document, additions) }];
}

const storedAs = (compression: Compression, input: Stored = { kind: 'none' }): Stored =>
  compression === 'like-input' ? input : { kind: compression };

interface Compressed {
  stored: Stored;
  manner: OutputManner;
  replaced: ReadonlySet<Primitive>;
  share: () => void;
}

function compressFor(
  model: OpenModel,
  document: Document,
  { stored, manner, replaced, share }: Compressed,
): Promise<void> {
  const hasAllBinds = document
    .getRoot()
    .listSkins()
    .every((skin) => skin.getInverseBindMatrices() !== null);
  return compress(document, {
    kind: stored.kind,
    // Attributes that were stored in integers still are.
    quantizes: manner.compression !== 'like-input',
    keepsOrder: manner.keepsOrder,
    replaced,
    share,
    // Files that refer to vertices by index also have positions or distances: settings of a solver, and bindings.
    keepsNodes: !!model.foreign || !hasAllBinds || manner.keepsOrder,
  });
}

/** Copies of the meshes of bodies with further levels in the same file, one for each of these. */
function copiesOf(
  document: Document,
  bodies: (ExportedLevels | null)[],
): { further: { mesh: Mesh; exported: ExportedBody }[]; levels: MeshLevels[] } {
  const meshes = document.getRoot().listMeshes();
  const further: { mesh: Mesh; exported: ExportedBody }[] = [];
  const levels: MeshLevels[] = [];
  for (const one of bodies) {
    if (!one || one.further.length === 0) continue;
    const mesh = meshes[one.first.body.mesh];
    const copies = one.further.map(({ exported }, i) => {
      const copy = copyMesh(mesh).setName(`${mesh.getName()}_LOD${i + 1}`);
      further.push({ mesh: copy, exported });
      return copy;
    });
    levels.push({ mesh, further: copies, deviations: one.further.map(({ deviation }) => deviation) });
  }
  return { further, levels };
}

/**
 * The number in the file of the mesh of further level `level`, from 1, of the body that is replaced as number `replaced`, where each
 * has `levels` further ones.
 */
export const furtherMesh = (
  { document }: OpenModel,
  { levels, replaced, level }: { levels: number; replaced: number; level: number },
): number => document.getRoot().listMeshes().length + levels * replaced + level - 1;

function copyMesh(mesh: Mesh): Mesh {
  const copy = mesh.clone();
  for (const primitive of mesh.listPrimitives())
    copy.removePrimitive(primitive).addPrimitive(primitive.clone());
  return copy;
}
