/** The container of binary glTF: a JSON chunk and, where there is one, the buffer inside the file. */

import type { SourceFile } from './model';

const HEADER_BYTES = 20;
const CHUNK_HEADER_BYTES = 8;
const MAGIC = 0x46546c67;
const JSON_CHUNK = 0x4e4f534a;
const SPACE = 32;

export interface GlbParts {
  json: Uint8Array;
  /** null: the file has no buffer inside */
  binary: Uint8Array | null;
}

export const isGlb = (bytes: Uint8Array): boolean => String.fromCharCode(...bytes.subarray(0, 4)) === 'glTF';

/** Views of the chunks. Throws an Error with one sentence where the file is cut off or of another version. */
export function glbParts({ name, bytes }: SourceFile): GlbParts {
  const broken = (problem: string) => new Error(`${name} is not a usable GLB (${problem}): export it again.`);
  if (bytes.length < HEADER_BYTES) throw broken('it is cut off');
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const [magic, version, announced, jsonLength] = [0, 4, 8, 12].map((at) => view.getUint32(at, true));
  if (magic !== MAGIC) throw broken('it does not start with "glTF"');
  if (version === 1) throw new Error(describeFirstVersion(name));
  if (version !== 2) throw broken(`it has version ${version}, not 2`);
  const binaryAt = HEADER_BYTES + jsonLength;
  if (view.getUint32(16, true) !== JSON_CHUNK) throw broken('its first chunk is not JSON');
  if (announced > bytes.length || binaryAt > bytes.length)
    throw broken(`it is cut off: ${announced} bytes expected, ${bytes.length} found`);
  const json = bytes.subarray(HEADER_BYTES, binaryAt);
  if (binaryAt + CHUNK_HEADER_BYTES > bytes.length) return { json, binary: null };
  const start = binaryAt + CHUNK_HEADER_BYTES;
  const end = start + view.getUint32(binaryAt, true);
  if (end > bytes.length) throw broken('its binary chunk is cut off');
  return { json, binary: bytes.subarray(start, end) };
}

/** The error for a file of glTF 1.0, which no current program reads. */
export const describeFirstVersion = (name: string): string =>
  `${name} is glTF 1.0: convert it to glTF 2.0, as gltf-pipeline does.`;

/** The GLB with its JSON replaced; everything after the JSON chunk stays byte for byte. */
export function withJson(glb: Uint8Array, json: object): Uint8Array {
  const old = new DataView(glb.buffer, glb.byteOffset, glb.byteLength);
  const rest = glb.subarray(HEADER_BYTES + old.getUint32(12, true));
  const text = new TextEncoder().encode(JSON.stringify(json));
  const jsonLength = 4 * Math.ceil(text.length / 4);
  const bytes = new Uint8Array(HEADER_BYTES + jsonLength + rest.length).fill(SPACE);
  bytes.set(glb.subarray(0, HEADER_BYTES));
  bytes.set(text, HEADER_BYTES);
  bytes.set(rest, HEADER_BYTES + jsonLength);
  const view = new DataView(bytes.buffer);
  view.setUint32(8, bytes.length, true);
  view.setUint32(12, jsonLength, true);
  return bytes;
}
