/** Reads binary and text STL: a triangle soup, read as one body. */

import { GrowingFloats } from './growing';
import { counted } from '../core/words';
import type { SourceFile } from './model';
import type { SurfaceFile } from './surface';
import { excerpt, TextScanner } from './text_scanner';

const HEADER_BYTES = 84;
const FACET_BYTES = 50;

/** Throws an Error that names the line or the facet. */
export function readStl(file: SourceFile): SurfaceFile {
  const isText =
    !isBinaryStl(file.bytes) && new TextScanner(file.name, file.bytes).word().toLowerCase() === 'solid';
  const { positions, solids } = isText ? readText(file) : readBinary(file);
  if (positions.length === 0) throw new Error(`${file.name} has no facets: export it as a mesh with faces.`);
  const indices = Uint32Array.from({ length: positions.length / 3 }, (_, v) => v);
  const name = file.name.replace(/^.*[/\\]/, '').replace(/\.[^.]*$/, '');
  const notes = solids > 1 ? [`${counted(solids, 'solid')} read as one body`] : [];
  return { surfaces: [{ name, positions, indices, notes: [] }], notes, unread: [] };
}

/** Whether the bytes are exactly as many as the header of a binary STL announces. */
export const isBinaryStl = (bytes: Uint8Array): boolean =>
  bytes.length >= HEADER_BYTES && binaryLength(bytes) === bytes.length;

function binaryLength(bytes: Uint8Array): number {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  return HEADER_BYTES + FACET_BYTES * view.getUint32(80, true);
}

function readBinary({ name, bytes }: SourceFile): { positions: Float32Array; solids: number } {
  if (bytes.length < HEADER_BYTES) throw new Error(`${name} is not STL: check that it is a mesh file.`);
  const expected = binaryLength(bytes);
  if (bytes.length < expected)
    throw new Error(
      `${name} is cut off or not STL (${expected} bytes expected, ${bytes.length} found): export it again.`,
    );
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const facets = view.getUint32(80, true);
  const positions = new Float32Array(9 * facets);
  for (let facet = 0; facet < facets; ++facet)
    for (let i = 0; i < 9; ++i) {
      // A facet is a normal (12 bytes), nine coordinates and two bytes of attributes.
      const value = view.getFloat32(HEADER_BYTES + FACET_BYTES * facet + 12 + 4 * i, true);
      if (!Number.isFinite(value))
        throw new Error(
          `${name}, facet ${facet}: a coordinate is ${value}, not a finite number: export it again.`,
        );
      positions[9 * facet + i] = value;
    }
  return { positions, solids: 1 };
}

function readText({ name, bytes }: SourceFile): { positions: Float32Array; solids: number } {
  const scan = new TextScanner(name, bytes);
  const positions = new GrowingFloats();
  let solids = 0;
  while (scan.seekWordAnywhere()) {
    const word = scan.word().toLowerCase();
    if (word === 'solid') {
      solids += 1;
      scan.nextLine(); // its name
    } else if (word === 'facet') readFacet(scan, positions);
    else if (word === 'endsolid') scan.nextLine();
    else scan.fail(`"${excerpt(word)}" found where a facet was expected`);
  }
  return { positions: positions.finish(), solids };
}

function readFacet(scan: TextScanner, positions: GrowingFloats): void {
  expectWord(scan, 'normal');
  // The normal is not used, and real files contain "nan" there.
  for (let i = 0; i < 3; ++i) scan.word();
  expectWord(scan, 'outer');
  expectWord(scan, 'loop');
  for (let i = 0; i < 3; ++i) {
    expectWord(scan, 'vertex');
    const at = ['x', 'y', 'z'].map((axis) => Math.fround(scan.number(axis)));
    if (!at.every(Number.isFinite)) scan.fail('a coordinate is too large for a 32-bit number');
    positions.push3(at[0], at[1], at[2]);
  }
  expectWord(scan, 'endloop');
  expectWord(scan, 'endfacet');
}

function expectWord(scan: TextScanner, expected: string): void {
  scan.seekWordAnywhere();
  const word = scan.word();
  if (word.toLowerCase() === expected) return;
  const found = word === '' ? 'the file ends' : `"${excerpt(word)}" found`;
  scan.fail(`${found} where "${expected}" was expected`);
}
