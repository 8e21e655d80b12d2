/** An opened file: its glTF document, which exports start from, and its bodies. */

import type { Document } from '@gltf-transform/core';
import type { Foreign } from './extensions/foreign';
import type { InnerExtras } from './extensions/inner_extras';
import type { TextureTexts } from './extensions/texture_texts';
import type { Stored } from './write/compression';

export interface SourceFile {
  /** may include a path relative to the other files */
  name: string;
  bytes: Uint8Array;
}

export type Format = 'glb' | 'gltf' | 'obj' | 'stl' | 'ply' | 'off';

/** Triangles [first, next span's first) of a body come from primitive number `primitive` of its mesh. */
export interface PrimitiveSpan {
  primitive: number;
  first: number;
  /** the vertex of the body that is vertex 0 of the primitive; primitives with one list of positions have the same */
  firstVertex: number;
  /** vertices of the primitive in its file */
  vertexCount: number;
}

/** All triangles of one mesh of the document, in the mesh's local space, not welded. */
export interface Body {
  name: string;
  /** positions[3 * v + c] */
  positions: Float32Array;
  /** indices[3 * t + corner] */
  indices: Uint32Array;
  /** per triangle: 1 if its quad is cut along the other diagonal than in the file; absent if none is */
  recut?: Uint8Array;
  /** what the reader changed in it, in words for the user */
  notes: string[];
  /** its index among the document's meshes */
  mesh: number;
  spans: PrimitiveSpan[];
  /**
   * file units per unit of this body, from the first node that uses it, or from the first joint of its skin, beside which glTF
   * ignores the node; the mean of the axes if not uniform
   */
  scale: number;
  /** absent where the scale is uniform */
  isScaledUnevenly?: true;
  /** of a body that was brought into the space of another mesh; absent: its positions are those of the file */
  own?: OwnSpace;
}

/** The original space of a mesh whose body was moved to another one. */
export interface OwnSpace {
  /** positions[3 * v + c] of the file */
  positions: Float32Array;
  /** units of the body per unit of the file's mesh */
  scale: number;
}

export interface OpenModel {
  /** name of the main file */
  name: string;
  format: Format;
  document: Document;
  bodies: Body[];
  /** notes on the file as a whole, in words for the user */
  notes: string[];
  /** content that the document cannot hold, in words for the user: "UV coordinates" */
  unread: string[];
  /** whether its meshes are levels of detail of each other; absent: they are not */
  hasLevels?: true;
  /** how its vertices were stored; absent: plainly */
  stored?: Stored;
  /** extensions that its document cannot hold; null or absent: none */
  foreign?: Foreign | null;
  /** names and extras of textures, which its document cannot hold; null or absent: none */
  textureTexts?: TextureTexts | null;
  /** extras that its document cannot hold; absent: none */
  innerExtras?: InnerExtras[];
  /** names of the material libraries of an OBJ, which a written OBJ refers to again */
  libraries?: string[];
  /** these libraries and their pictures, under their paths from the folder of the OBJ: they are written beside a written OBJ */
  carried?: SourceFile[];
  /** names of libraries and pictures that cannot be beside a written OBJ */
  outside?: string[];
}
