/** Reads GLB and glTF files into a document and its bodies. */

import type { Document, GLTF, JSONDocument } from '@gltf-transform/core';
import { bodiesOfDocument } from './bodies';
import { findWrongMesh } from './checks/gltf_meshes';
import { addCompanions, companionPaths, describeMissing } from './checks/companions';
import { inBase64 } from './checks/data_addresses';
import { glbParts, describeFirstVersion, isGlb } from './glb';
import { checkDraco } from './checks/draco_bounds';
import {
  checkBounds,
  findWrongList,
  GLB_BUFFER,
  mostCorners,
  mostElements,
  sizeOf,
} from './checks/gltf_bounds';
import { canBeCarried, foreignOf } from './extensions/foreign';
import { restoreSkippedProperties } from './extensions/skipped_properties';
import { innerExtrasOf } from './extensions/inner_extras';
import { textureTextsOf } from './extensions/texture_texts';
import { createGltfIo, SUPPORTED_EXTENSIONS } from './gltf_io';
import { describeFallbacks, requireFormats } from './checks/fallback_images';
import { withoutImageless } from './checks/imageless';
import { withoutShear } from './checks/sheared';
import { describeJsonPosition } from '../core/json_position';
import { counted } from '../core/words';
import type { OpenModel, SourceFile } from './model';
import { describeFailure } from './checks/reading_failure';
import { checkEncoding } from './checks/text_encoding';
import { firstProblem } from './validate';
import { storedIn, withKnownNames } from './write/compression';
import { setInfiniteFarPlanes } from './write/infinite_cameras';

/**
 * Opens `file` with its companions among `files`; it may have no body. Missing images stay references. Throws an
 * Error with one sentence.
 */
export async function openGltf(
  file: SourceFile,
  format: 'glb' | 'gltf',
  files: SourceFile[],
): Promise<OpenModel> {
  const jsonDocument = jsonDocumentOf(file, format);
  const stored = storedIn(jsonDocument.json);
  const foreign = foreignOf(jsonDocument.json);
  const textureTexts = textureTextsOf(jsonDocument.json);
  const innerExtras = innerExtrasOf(jsonDocument.json);
  const { json, notes: imageless } = withoutImageless(inBase64(withKnownNames(jsonDocument.json)));
  // The reader refuses any required extension that it does not know, including those that can be carried over without it.
  const required = json.extensionsRequired?.filter((extension) => SUPPORTED_EXTENSIONS.has(extension));
  checkNodes(file.name, json.nodes);
  const { json: unsheared, notes: sheared } = withoutShear(json);
  jsonDocument.json = required ? { ...unsheared, extensionsRequired: required } : unsheared;
  const fallbacks = describeFallbacks(json);
  const missing = addCompanions(file, jsonDocument, files);
  const size = sizeOf(file.bytes.length, jsonDocument);
  const document = await readDocument(file, jsonDocument, size);
  requireFormats(document);
  setInfiniteFarPlanes(document, json);
  const { bodies, notes } = bodiesOfDocument(file.name, document, mostCorners(size));
  return {
    name: file.name,
    format,
    document,
    bodies,
    notes: [
      ...notes,
      ...restPoseNotes(document),
      ...describeMissing(missing),
      ...sheared,
      ...imageless,
      ...fallbacks,
    ],
    unread: [],
    stored,
    foreign,
    textureTexts,
    innerExtras,
  };
}

function jsonDocumentOf(file: SourceFile, format: 'glb' | 'gltf'): JSONDocument {
  if (format === 'gltf') return { json: parseJson(file.name, file.bytes), resources: {} };
  const { json, binary } = glbParts(file);
  const resources: JSONDocument['resources'] = {};
  if (binary !== null) resources[GLB_BUFFER] = new Uint8Array(binary);
  return { json: parseJson(file.name, json), resources };
}

/** The JSON of a glTF 2.0 file. Throws an Error with one sentence. */
export function parseJson(name: string, bytes: Uint8Array): GLTF.IGLTF {
  checkEncoding(name, bytes);
  const json = parseText(name, new TextDecoder().decode(bytes));
  if (typeof json !== 'object' || json === null)
    throw new Error(`${name} is not glTF (it has no "asset"): check that it is a mesh file.`);
  if (isFirstVersion(json)) throw new Error(describeFirstVersion(name));
  if (!('asset' in json))
    throw new Error(`${name} is not glTF (it has no "asset"): check that it is a mesh file.`);
  checkJson(name, json as GLTF.IGLTF);
  return json as GLTF.IGLTF;
}

function checkJson(name: string, json: GLTF.IGLTF): void {
  const given: unknown = json.asset?.version;
  const version =
    typeof given === 'string' || typeof given === 'number' ? String(given) : 'without a version';
  if (version.split('.')[0] !== '2') throw new Error(`${name} is glTF ${version}: convert it to glTF 2.0.`);
  const wrong = findWrongList(json) ?? findWrongMesh(json);
  if (wrong !== null) throw new Error(`${name} is not a valid glTF file (${wrong}): export it again.`);
  const unknown = (json.extensionsRequired ?? []).filter(
    (extension) => !SUPPORTED_EXTENSIONS.has(extension) && !canBeCarried(extension),
  );
  if (unknown.length > 0)
    throw new Error(
      `${name} requires ${unknown.join(', ')}, which cannot be read: export it without this extension.`,
    );
}

function parseText(name: string, text: string): unknown {
  try {
    return JSON.parse(text);
  } catch (error) {
    throw new Error(
      `${name} is not glTF (its text is not JSON${describeJsonPosition(text, error)}): check that it is a mesh file.`,
    );
  }
}

/** In glTF 1.0, collections were objects and the asset could be left out. */
function isFirstVersion(json: object): boolean {
  const { asset, accessors, meshes, nodes } = json as Record<string, unknown>;
  const version = (asset as { version?: unknown } | undefined)?.version;
  const areNamed = [accessors, meshes, nodes].some(
    (list) => typeof list === 'object' && list !== null && !Array.isArray(list),
  );
  const isFirst = typeof version === 'string' && version.startsWith('1');
  return isFirst || (version === undefined && areNamed);
}

/** Paths, relative to the file, of the buffers and images that a GLB or glTF names; empty for other formats. */
export function companionNames(file: SourceFile): string[] {
  const isBinary = isGlb(file.bytes);
  if (!isBinary && !file.name.toLowerCase().endsWith('.gltf')) return [];
  return companionPaths(parseJson(file.name, isBinary ? glbParts(file).json : file.bytes));
}

/** The deepest nesting of nodes; only malicious files go deeper, and the work on a node grows with its depth. */
const DEEPEST = 1000;

/** Refuses nodes that are their own descendants, since every traversal would loop forever, and nodes that are nested too deeply. */
function checkNodes(name: string, nodes: GLTF.INode[] = []): void {
  const parents = new Map<number, number>();
  nodes.forEach(({ children }, parent) => {
    for (const child of Array.isArray(children) ? children : []) parents.set(child, parent);
  });
  const depths = new Map<number, number>();
  for (const start of parents.keys()) {
    const path = pathUp(start, parents, depths);
    if (path === null)
      throw new Error(
        `${name} is not a valid glTF file (node ${start} is its own descendant): export it again.`,
      );
    const top = parents.get(path[path.length - 1] ?? start);
    let depth = top === undefined ? -1 : depths.get(top)!;
    for (const node of path.reverse()) depths.set(node, ++depth);
    if (depth > DEEPEST)
      throw new Error(`${name} has nodes more than ${DEEPEST} levels deep: flatten it and export it again.`);
  }
}

/** The node and those above it up to the first whose depth is known; null if it comes back to one of them. */
function pathUp(start: number, parents: Map<number, number>, depths: Map<number, number>): number[] | null {
  const path = new Set<number>();
  for (
    let node: number | undefined = start;
    node !== undefined && !depths.has(node);
    node = parents.get(node)
  ) {
    if (path.has(node)) return null;
    path.add(node);
  }
  return [...path];
}

/** Reads checked JSON; remaining errors are reported in the words of the validator. */
async function readDocument(file: SourceFile, jsonDocument: JSONDocument, size: number): Promise<Document> {
  const refuse = (reason: string) =>
    new Error(`${file.name} is not a valid glTF file (${reason}): check it with the glTF validator.`);
  try {
    checkBounds(jsonDocument, size);
    checkDraco(jsonDocument, mostElements(size));
  } catch (error) {
    throw refuse((error as Error).message);
  }
  const io = await createGltfIo(jsonDocument.json.extensionsUsed);
  let document: Document;
  try {
    document = await io.readJSON(jsonDocument);
    restoreSkippedProperties(document, jsonDocument.json);
  } catch (error) {
    throw refuse((await firstProblem(jsonDocument.json)) ?? describeFailure(error).replace(/:.*/, ''));
  }
  const shortened = findShortened(jsonDocument.json, document);
  if (shortened !== null) throw refuse(shortened);
  return document;
}

/** The reader silently shortens an accessor whose buffer is too short, so element counts are checked here. */
function findShortened(json: GLTF.IGLTF, document: Document): string | null {
  const accessors = document.getRoot().listAccessors();
  for (const [i, { count }] of (json.accessors ?? []).entries()) {
    const found = accessors[i]?.getArray() ? accessors[i].getCount() : count;
    if (found !== count) return `accessor ${i} declares ${count} elements but has data for ${found}`;
  }
  return null;
}

function restPoseNotes(document: Document): string[] {
  const root = document.getRoot();
  const [skins, animations] = [root.listSkins().length, root.listAnimations().length];
  const moving = [
    ...(skins > 0 ? [counted(skins, 'skin')] : []),
    ...(animations > 0 ? [counted(animations, 'animation')] : []),
  ];
  const isMorphed = [...root.listNodes(), ...root.listMeshes()].some((one) =>
    one.getWeights().some((weight) => weight !== 0),
  );
  return [
    ...(moving.length > 0 ? [`${moving.join(' and ')}: the rest pose is used`] : []),
    ...(isMorphed ? ['default weights of morph targets: measurements and motion use weights of 0'] : []),
  ];
}
