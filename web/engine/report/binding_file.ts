/** The binding of the original's vertices to results, as a file for other programs and later commands. */

import type { Binding } from '../core/core';
import { NONE } from '../core/core';
import { isCount } from '../core/count';
import type { BodyBinding } from '../body/body_binding';
import { VERSION } from '../core/version';

export const BINDING_SCHEMA = 'limber-binding/1';

/** One body in the file; arrays are little-endian numbers in base64. */
interface BodyEntry {
  name: string;
  mesh: number;
  vertices: number;
  faces: number;
  triangle: string;
  barycentric: string;
  offset: string;
}

export function writeBinding(bodies: BodyBinding[]): string {
  const entries = bodies.map(({ name, mesh, faces, binding }): BodyEntry => ({
    name,
    mesh,
    vertices: binding.triangle.length,
    faces,
    triangle: encode(binding.triangle),
    barycentric: encode(binding.barycentric),
    offset: encode(binding.offset),
  }));
  return `${JSON.stringify({ schema: BINDING_SCHEMA, version: VERSION, bodies: entries }, null, 1)}\n`;
}

/**
 * Throws an Error with one sentence where `text`, the content of the file `name`, is not a valid binding. `cure`: how the caller can get a
 * valid one.
 */
export function readBinding(
  name: string,
  text: string,
  cure = 'write it again with limber optimize --bind',
): BodyBinding[] {
  const fail = (problem: string): never => {
    throw new Error(`${name} ${problem}: ${cure}.`);
  };
  const { schema, bodies } = parse(text) ?? fail('is not JSON');
  if (schema !== BINDING_SCHEMA)
    return fail(`is no binding file, because its "schema" is not "${BINDING_SCHEMA}"`);
  if (!Array.isArray(bodies)) return fail('has no bodies');
  return (bodies as BodyEntry[]).map((entry) => {
    if (typeof entry?.name !== 'string') return fail('has a body without a name');
    const { vertices, faces, mesh } = entry;
    const binding: Binding = {
      triangle: new Uint32Array(decode(entry.triangle)),
      barycentric: new Float32Array(decode(entry.barycentric)),
      offset: new Float32Array(decode(entry.offset)),
    };
    const lengths = [binding.triangle.length, binding.barycentric.length / 3, binding.offset.length];
    if (lengths.some((length) => length !== vertices)) fail(`has damaged arrays for "${entry.name}"`);
    if (!isCount(mesh) || !isCount(faces)) fail(`lacks the mesh index or the face count of "${entry.name}"`);
    if (binding.triangle.some((triangle) => triangle !== NONE && triangle >= faces))
      fail(`refers to a triangle that "${entry.name}" does not have`);
    if (![binding.barycentric, binding.offset].every((values) => values.every(Number.isFinite)))
      fail(`has a coordinate of "${entry.name}" that is not finite`);
    return { name: entry.name, mesh, faces, binding };
  });
}

/** null where the text is not a JSON object. */
function parse(text: string): { schema?: unknown; bodies?: unknown } | null {
  try {
    const value = JSON.parse(text) as unknown;
    return typeof value === 'object' ? value : null;
  } catch {
    return null;
  }
}

/** Assumes a little-endian machine, as all that run JavaScript engines today are. */
function encode({ buffer, byteOffset, byteLength }: Uint32Array | Float32Array): string {
  const bytes = new Uint8Array(buffer, byteOffset, byteLength);
  let letters = '';
  // The number of arguments of one call is limited.
  for (let at = 0; at < bytes.length; at += 8192)
    letters += String.fromCharCode(...bytes.subarray(at, at + 8192));
  return btoa(letters);
}

/** An empty buffer where `text` is not base64 of whole 32-bit numbers. */
function decode(text: unknown): ArrayBuffer {
  let letters = '';
  try {
    letters = atob(String(text));
  } catch {
    return new ArrayBuffer(0);
  }
  if (letters.length % 4 !== 0) return new ArrayBuffer(0);
  return Uint8Array.from(letters, (letter) => letter.charCodeAt(0)).buffer;
}
