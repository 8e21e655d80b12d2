/**
 * Checks the counts that Draco streams declare against their size: the decoder allocates all faces before it has read one. The
 * layout is that of the Draco bitstream specification, sections "Header", "Metadata" and "Connectivity".
 */

import type { GLTF, JSONDocument } from '@gltf-transform/core';
import { quotedJson } from '../../core/words';

const DRACO = 'KHR_draco_mesh_compression';
const MAGIC = 'DRACO';
const MESH = 1;
const EDGEBREAKER = 1;
const HAS_METADATA = 0x8000;
/** Metadata may be nested; only malicious files nest it deeper. */
const DEEPEST = 16;

/** Throws a plain Error whose message is a clause where the streams have more than `most` faces or vertices together. */
export function checkDraco({ json, resources }: JSONDocument, most: number): void {
  let announced = 0;
  for (const number of dracoViews(json)) {
    const view = json.bufferViews?.[number];
    const definition = json.buffers?.[view?.buffer ?? -1];
    if (!view || !definition)
      throw new Error(`Draco data is in buffer view ${quotedJson(number)}, which does not exist`);
    const bytes = resources[definition.uri ?? '@glb.bin'] ?? bytesOfAddress(definition.uri ?? '');
    const { byteOffset: start = 0, byteLength } = view;
    announced += announcedCount(bytes.subarray(start, start + byteLength));
    if (announced > most)
      throw new Error(`the Draco data in buffer view ${number} declares more than it can contain`);
  }
}

/** The indices of all buffer views with Draco meshes. */
function dracoViews({ meshes }: GLTF.IGLTF): Set<number> {
  const primitives = (meshes ?? []).flatMap((mesh) =>
    Array.isArray(mesh.primitives) ? mesh.primitives : [],
  );
  const views = primitives.map(
    (primitive) => (primitive?.extensions?.[DRACO] as { bufferView?: number } | undefined)?.bufferView,
  );
  return new Set(views.filter((view) => view !== undefined));
}

/** The bytes of a data URI in base64. */
function bytesOfAddress(uri: string): Uint8Array {
  const [, text] = /^data:[^,]*;base64,(.*)$/is.exec(uri) ?? [];
  if (text === undefined) throw new Error('Draco data is in a buffer that does not exist');
  try {
    return Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  } catch {
    throw new Error('Draco data is in a data URI that is not base64');
  }
}

/** The larger of the declared counts of faces and vertices; 0 for anything but a Draco mesh, which the decoder refuses. */
function announcedCount(bytes: Uint8Array): number {
  const reader = new Reader(bytes);
  if (String.fromCharCode(...bytes.subarray(0, MAGIC.length)) !== MAGIC) return 0;
  reader.skip(MAGIC.length);
  const version = 256 * reader.byte() + reader.byte();
  const [type, method, flags] = [reader.byte(), reader.byte(), reader.byte() + 256 * reader.byte()];
  if (type !== MESH) return 0;
  if (flags & HAS_METADATA) skipMetadata(reader);
  const isOld = version < 0x202;
  if (method !== EDGEBREAKER) {
    const number = () => (isOld ? reader.word() : reader.varint());
    return Math.max(number(), number());
  }
  const number = () => (version < 0x200 ? reader.word() : reader.varint());
  // The traversal method, and in old streams a number of further vertices.
  reader.skip(1);
  if (isOld) number();
  return Math.max(number(), number());
}

function skipMetadata(reader: Reader): void {
  for (let left = reader.varint(); left > 0 && !reader.isAtEnd; --left) {
    reader.varint();
    skipElement(reader, 0);
  }
  skipElement(reader, 0);
}

function skipElement(reader: Reader, depth: number): void {
  if (depth > DEEPEST) throw new Error('the metadata of its Draco data is nested too deeply');
  for (let left = reader.varint(); left > 0 && !reader.isAtEnd; --left) {
    reader.skip(reader.byte());
    reader.skip(reader.varint());
  }
  for (let left = reader.varint(); left > 0 && !reader.isAtEnd; --left) {
    reader.skip(reader.byte());
    skipElement(reader, depth + 1);
  }
}

/** Reads little-endian numbers; past the end it reads zeros, which the decoder refuses. */
class Reader {
  private at = 0;

  constructor(private readonly bytes: Uint8Array) {}

  get isAtEnd(): boolean {
    return this.at >= this.bytes.length;
  }

  skip(count: number): void {
    this.at += count;
  }

  byte(): number {
    return this.bytes[this.at++] ?? 0;
  }

  word(): number {
    return this.byte() + 2 ** 8 * this.byte() + 2 ** 16 * this.byte() + 2 ** 24 * this.byte();
  }

  /** A LEB128 number: seven bits a byte, the lowest first; the highest bit of a byte says that another one follows. */
  varint(): number {
    let value = 0;
    for (let shift = 0; shift < 64; shift += 7) {
      const byte = this.byte();
      value += (byte & 127) * 2 ** shift;
      if (byte < 128) break;
    }
    return value;
  }
}
