/** Reads GLB and glTF files into their own document and its bodies. */

import type { Document, GLTF, JSONDocument } from '@gltf-transform/core';
import { bodiesOfDocument } from './bodies';
import { createGltfIo, SUPPORTED_EXTENSIONS } from './gltf_io';
import { counted } from '../core/words';
import type { OpenModel, SourceFile } from './model';

const GLB_HEADER_BYTES = 20;
const CHUNK_HEADER_BYTES = 8;
const JSON_CHUNK = 0x4e4f534a;
/** glTF-Transform's name for the buffer inside a GLB. */
const GLB_BUFFER = '@glb.bin';

/** Opens `file` with its companions among `files`. Throws an Error with one sentence. */
export async function openGltf(
  file: SourceFile,
  format: 'glb' | 'gltf',
  files: SourceFile[],
): Promise<OpenModel> {
  const jsonDocument =
    format === 'glb' ? parseGlb(file) : { json: parseJson(file.name, file.bytes), resources: {} };
  const { json } = jsonDocument;
  checkJson(file.name, json);
  checkNodes(file.name, json.nodes);
  addCompanions(file, jsonDocument, files);
  const document = await readDocument(file.name, jsonDocument);
  const { bodies, notes } = bodiesOfDocument(file.name, document);
  const unknown = (json.extensionsUsed ?? []).filter((extension) => !SUPPORTED_EXTENSIONS.has(extension));
  const unread = unknown.map((extension) => `extension ${extension}`);
  return { name: file.name, format, document, bodies, notes: [...notes, ...restPoseNotes(document)], unread };
}

function parseGlb({ name, bytes }: SourceFile): JSONDocument {
  const broken = (problem: string) => new Error(`${name} is not a usable GLB: ${problem}: export it again.`);
  if (bytes.length < GLB_HEADER_BYTES) throw broken('it is cut off');
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  if (view.getUint32(0, true) !== 0x46546c67) throw broken('it does not start with "glTF"');
  if (view.getUint32(4, true) !== 2) throw broken(`it has version ${view.getUint32(4, true)}, not 2`);
  const jsonLength = view.getUint32(12, true);
  const binaryAt = GLB_HEADER_BYTES + jsonLength;
  if (view.getUint32(16, true) !== JSON_CHUNK) throw broken('its first chunk is not JSON');
  if (view.getUint32(8, true) > bytes.length || binaryAt > bytes.length)
    throw broken(`it is cut off: ${view.getUint32(8, true)} bytes are announced, ${bytes.length} are there`);
  const json = parseJson(name, bytes.subarray(GLB_HEADER_BYTES, binaryAt));
  if (binaryAt + CHUNK_HEADER_BYTES > bytes.length) return { json, resources: {} };
  const start = binaryAt + CHUNK_HEADER_BYTES;
  const end = start + view.getUint32(binaryAt, true);
  if (end > bytes.length) throw broken('its binary chunk is cut off');
  return { json, resources: { [GLB_BUFFER]: new Uint8Array(bytes.slice(start, end)) } };
}

function parseJson(name: string, bytes: Uint8Array): GLTF.IGLTF {
  try {
    const json = JSON.parse(new TextDecoder().decode(bytes)) as unknown;
    if (typeof json === 'object' && json !== null && 'asset' in json) return json as GLTF.IGLTF;
  } catch (error) {
    throw new Error(`${name} is not glTF: ${(error as Error).message}: is it a mesh?`);
  }
  throw new Error(`${name} is not glTF: it has no "asset": is it a mesh?`);
}

function checkJson(name: string, json: GLTF.IGLTF): void {
  if (String(json.asset?.version ?? '').split('.')[0] !== '2')
    throw new Error(`${name} is glTF ${json.asset?.version ?? 'without a version'}: convert it to glTF 2.0.`);
  const unknown = (json.extensionsRequired ?? []).filter((extension) => !SUPPORTED_EXTENSIONS.has(extension));
  if (unknown.length > 0)
    throw new Error(`${name} requires ${unknown.join(', ')}, which cannot be read: export it without.`);
}

/** Refuses a node that is its own descendant: every traversal of the tree would loop forever. */
function checkNodes(name: string, nodes: GLTF.INode[] = []): void {
  const parents = new Map<number, number>();
  nodes.forEach(({ children }, parent) => {
    for (const child of Array.isArray(children) ? children : []) parents.set(child, parent);
  });
  const isFine = new Set<number>();
  for (const start of parents.keys()) {
    const path = new Set<number>();
    for (
      let node: number | undefined = start;
      node !== undefined && !isFine.has(node);
      node = parents.get(node)
    ) {
      if (path.has(node))
        throw new Error(`${name} is not a valid glTF file (node ${node} is below itself): export it again.`);
      path.add(node);
    }
    for (const node of path) isFine.add(node);
  }
}

/** Adds the bytes of every external buffer and image to the resources, under the URI that the file gives it. */
function addCompanions(file: SourceFile, { json, resources }: JSONDocument, files: SourceFile[]): void {
  const missing = new Set<string>();
  for (const { uri } of [...(json.buffers ?? []), ...(json.images ?? [])]) {
    if (!uri || uri.startsWith('data:')) continue;
    const companion = findCompanion(file.name, uri, files);
    if (companion) resources[uri] = new Uint8Array(companion.bytes);
    else missing.add(uri);
  }
  if (missing.size === 0) return;
  const names = [...missing].join(', ');
  const verb = missing.size === 1 ? 'is' : 'are';
  throw new Error(
    `${file.name} needs ${names}, which ${verb} not there: open the whole folder, or put them beside it.`,
  );
}

/** Paths, relative to the file, of the buffers and images that a GLB or glTF names; empty for other formats. */
export function companionNames(file: SourceFile): string[] {
  const isGlb = String.fromCharCode(...file.bytes.subarray(0, 4)) === 'glTF';
  if (!isGlb && !file.name.toLowerCase().endsWith('.gltf')) return [];
  const json = isGlb ? parseGlb(file).json : parseJson(file.name, file.bytes);
  const addresses = [...(json.buffers ?? []), ...(json.images ?? [])].map(({ uri }) => uri ?? '');
  const outside = addresses.filter((address) => address !== '' && !address.startsWith('data:'));
  return [...new Set(outside.map((address) => companionPath('', address)))];
}

function findCompanion(main: string, uri: string, files: SourceFile[]): SourceFile | undefined {
  const path = companionPath(main, uri);
  const baseName = path.split('/').pop();
  return (
    files.find((file) => companionPath('', file.name) === path) ??
    files.find((file) => file.name.split(/[/\\]/).pop() === baseName)
  );
}

/** Resolves `uri` against the folder of `main`; the path has forward slashes and no dot segments. */
export function companionPath(main: string, uri: string): string {
  const folder = main.replace(/\\/g, '/').split('/').slice(0, -1);
  let decoded = uri;
  try {
    decoded = decodeURIComponent(uri);
  } catch {
    // A % that starts no escape sequence is a character of the name.
  }
  const path: string[] = [];
  for (const part of [...folder, ...decoded.replace(/\\/g, '/').split('/')]) {
    if (part === '..' && path.length > 0 && path[path.length - 1] !== '..') path.pop();
    else if (part !== '.' && part !== '') path.push(part);
  }
  return path.join('/');
}

async function readDocument(name: string, jsonDocument: JSONDocument): Promise<Document> {
  const io = await createGltfIo(jsonDocument.json.extensionsUsed);
  try {
    const document = await io.readJSON(jsonDocument);
    checkAccessors(jsonDocument.json, document);
    return document;
  } catch (error) {
    const reason = error instanceof Error ? error.message.replace(/\.$/, '') : String(error);
    throw new Error(`${name} is not a valid glTF file (${reason}): check it with the glTF validator.`);
  }
}

/** The reader silently shortens an accessor whose buffer is too short, so element counts are checked here. */
function checkAccessors(json: GLTF.IGLTF, document: Document): void {
  const accessors = document.getRoot().listAccessors();
  (json.accessors ?? []).forEach(({ count }, i) => {
    const found = accessors[i]?.getArray() ? accessors[i].getCount() : count;
    if (found !== count) throw new Error(`accessor ${i} announces ${count} elements, ${found} are there`);
  });
}

function restPoseNotes(document: Document): string[] {
  const root = document.getRoot();
  const [skins, animations] = [root.listSkins().length, root.listAnimations().length];
  const moving = [
    ...(skins > 0 ? [counted(skins, 'skin')] : []),
    ...(animations > 0 ? [counted(animations, 'animation')] : []),
  ];
  return moving.length > 0 ? [`${moving.join(' and ')}: the rest pose is used`] : [];
}
