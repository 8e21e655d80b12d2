/** Models of callers as files for the worker, and results in documents of callers. */

import { Accessor, Format, Logger, PropertyType, WebIO } from '@gltf-transform/core';
import type { Document, Extension, Primitive } from '@gltf-transform/core';
import { quotedValue } from '../engine/core/words';
import { replaceBodies } from '../engine/document/export';
import { isGlb } from '../engine/document/glb';
import { listUnused } from '../engine/document/prune';
import { tangentGenerator } from '../engine/document/shading/tangents';
import { rememberShared } from '../engine/document/write/shared_accessors';
import { rememberTargetNames } from '../engine/document/write/target_names';
import { LimberError } from './options';
import type { Model } from './options';
import { documentName, glbName } from './protocol';
import type { ModelFiles, OptimizeReply, Which } from './protocol';

/** A document in memory is not compressed, whatever its file was. */
const COMPRESSED = /(draco|meshopt)/i;

/** Documents may come from another copy of glTF-Transform. */
export function isDocument(model: unknown): model is Document {
  const { getRoot, getGraph } = (model ?? {}) as Partial<Document>;
  if (typeof getRoot !== 'function' || typeof getGraph !== 'function') return false;
  return (model as Document).getRoot()?.propertyType === PropertyType.ROOT;
}

/** Throws LimberError where it is no model. `which`: one of several. */
export async function filesOf(model: Model, which: Which = ''): Promise<ModelFiles> {
  if (isDocument(model)) return filesOfDocument(model, which);
  if (isBytes(model)) return [namelessFile(model, which)];
  if (isBuffer(model)) return [namelessFile(new Uint8Array(model), which)];
  if (Array.isArray(model)) return (model as ModelFiles).map((file, i) => checkedFile(file, i, which));
  throw new LimberError(
    `The ${which}model is ${quotedValue(model)}: give a glTF-Transform Document, the bytes of a GLB, or files with name and bytes.`,
  );
}

/** The file of bytes that came without a name. Throws LimberError where they are of another format than GLB. */
function namelessFile(bytes: Uint8Array, which: Which): ModelFiles[number] {
  if (bytes.length > 0 && !isGlb(bytes))
    throw new LimberError(
      `The bytes of the ${which}model do not start with "glTF", as those of a GLB do: give a model of another format with its name, as in [{ name: "chair.obj", bytes }].`,
    );
  return { name: glbName(which), bytes };
}

/** Bytes may come from another realm: a frame, or the sandbox of a test runner. */
const isBytes = (value: unknown): value is Uint8Array =>
  ArrayBuffer.isView(value) && (value as Partial<Uint8Array>)[Symbol.toStringTag] === 'Uint8Array';

const isBuffer = (value: unknown): value is ArrayBuffer =>
  Object.prototype.toString.call(value) === '[object ArrayBuffer]';

/** Throws LimberError where it is no file of a model. */
function checkedFile(file: ModelFiles[number], i: number, which: Which): ModelFiles[number] {
  if (typeof file?.name === 'string' && isBytes(file.bytes)) return file;
  throw new LimberError(
    `File ${i + 1} of the ${which}model is none: give its name, and its bytes as a Uint8Array.`,
  );
}

/** The document as a glTF with its buffers and images, exactly as it is in memory. */
async function filesOfDocument(document: Document, which: Which): Promise<ModelFiles> {
  recogniseAccessors(document);
  const used = document.getRoot().listExtensionsUsed();
  const plain = used.filter(({ extensionName }) => !COMPRESSED.test(extensionName));
  const io = new WebIO()
    .setLogger(new Logger(Logger.Verbosity.SILENT))
    .registerExtensions(plain.map((extension) => extension.constructor as typeof Extension));
  const putTargetNames = rememberTargetNames(document);
  const takeBuffers = lendBuffers(document);
  const { json, resources } = await io
    .writeJSON(document, { format: Format.GLTF, basename: 'document' })
    .catch((error: unknown) => refuseDocument(error, which))
    .finally(takeBuffers);
  putTargetNames(json);
  // A document read from a folder can name places that no file of a model may name.
  const names = new Map(Object.keys(resources).map((address, i) => [address, `resource${i}`]));
  const inMemory = <One extends { uri?: string }>(all?: One[]): One[] | undefined =>
    all?.map((one) => ({ ...one, ...(names.has(one.uri!) ? { uri: names.get(one.uri!) } : {}) }));
  const named = { ...json, buffers: inMemory(json.buffers), images: inMemory(json.images) };
  // Data that the worker cannot read stay unchanged in the document.
  const text = new TextEncoder().encode(JSON.stringify({ ...named, extensionsRequired: undefined }));
  const companions = Object.entries(resources).map(([name, bytes]) => ({ name: names.get(name)!, bytes }));
  return [{ name: documentName(which), bytes: text }, ...companions];
}

/** Temporarily gives accessors without a buffer one, because the writer would drop them. Returns the function that undoes it. */
function lendBuffers(document: Document): () => void {
  const root = document.getRoot();
  const loose = root.listAccessors().filter((accessor) => accessor.getBuffer() === null);
  const [first = null] = root.listBuffers();
  const lent = first || loose.length === 0 ? null : document.createBuffer();
  for (const accessor of loose) accessor.setBuffer(first ?? lent);
  return () => {
    for (const accessor of loose) accessor.setBuffer(null);
    lent?.dispose();
  };
}

function refuseDocument(error: unknown, which: Which): never {
  const why = error instanceof Error ? error.message : String(error);
  throw new LimberError(
    `The ${which}document cannot be written as a glTF (${why}): mend it, or give the bytes of a model.`,
  );
}

/** Makes the writer accept accessors of another copy of glTF-Transform: bundles for browsers contain their own copy. */
function recogniseAccessors(document: Document): void {
  const [accessor] = document.getRoot().listAccessors();
  if (!accessor || accessor instanceof Accessor) return;
  const isAccessor = (value: { propertyType?: string } | null) =>
    value?.propertyType === PropertyType.ACCESSOR;
  Object.defineProperty(Accessor, Symbol.hasInstance, { value: isAccessor });
}

/** Replaces the geometry of the document's meshes by that of the bodies; null leaves one unchanged. */
export async function applyBodies(
  document: Document,
  bodies: OptimizeReply['bodies'],
  fields: boolean,
): Promise<void> {
  const buffer = document.getRoot().listBuffers()[0] ?? document.createBuffer();
  separatePrimitives(document);
  const spared = listUnused(document);
  const shareAgain = rememberShared(document);
  // Meshes without normals stay without, as in every glTF.
  const replaced = replaceBodies({ document, buffer }, bodies, {
    fields,
    spared,
    smoothed: false,
    tangents: await tangentGenerator(document),
  });
  shareAgain(replaced);
}

/** Ends the sharing of primitives and morph targets between copies of a mesh, as in a file. */
function separatePrimitives(document: Document): void {
  const taken = new Set<Primitive>();
  for (const mesh of document.getRoot().listMeshes())
    for (const primitive of mesh.listPrimitives()) {
      if (taken.has(primitive)) mesh.swap(primitive, ownCopy(primitive));
      taken.add(primitive);
    }
}

function ownCopy(primitive: Primitive): Primitive {
  const copy = primitive.clone();
  for (const target of copy.listTargets()) copy.swap(target, target.clone());
  return copy;
}
