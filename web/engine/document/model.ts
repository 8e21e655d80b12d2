/** What a file has become: the document of record and the bodies in it. */

import type { Document } from '@gltf-transform/core';

export interface SourceFile {
  /** may hold a path relative to the other files */
  name: string;
  bytes: Uint8Array;
}

export type Format = 'glb' | 'gltf' | 'obj' | 'stl' | 'ply';

/** Triangles [first, next span's first) of a body come from the mesh's primitive number `primitive`. */
export interface PrimitiveSpan {
  primitive: number;
  first: number;
  /** the body's vertex that the primitive's attributes begin at */
  firstVertex: number;
}

/** All triangles of one mesh of the document, in its own space, as they came: not welded. */
export interface Body {
  name: string;
  /** positions[3 * v + c] */
  positions: Float32Array;
  /** indices[3 * t + corner] */
  indices: Uint32Array;
  /** per triangle: 1 where a quad is cut another way than in the file; absent where none is */
  recut?: Uint8Array;
  /** what was done to it while reading, in plain words */
  notes: string[];
  /** its number among the document's meshes */
  mesh: number;
  spans: PrimitiveSpan[];
  /** of the first node that uses it: file units per unit of this body (the mean where it is not uniform) */
  scale: number;
}

export interface OpenModel {
  /** of the main file */
  name: string;
  format: Format;
  document: Document;
  bodies: Body[];
  /** what concerns the file as a whole, in plain words */
  notes: string[];
  /** what the reader could not take into the document, in plain words: "UV coordinates" */
  unread: string[];
}
