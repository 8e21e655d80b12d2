/** Turns corners of an OBJ object, each with indices of a position, UV and normal, into vertices that have all three. */

import { NONE } from '../core/core';
import { GrowingIndices } from './growing';

/** Indices per corner; NONE for a missing UV or normal. */
export class ObjCorners {
  readonly vertices = new GrowingIndices();
  readonly uvs = new GrowingIndices();
  readonly normals = new GrowingIndices();

  push(vertex: number, uv: number, normal: number): void {
    this.vertices.push(vertex);
    this.uvs.push(uv);
    this.normals.push(normal);
  }
}

/** One vertex for each distinct corner. */
export interface ObjVertices {
  /** per vertex: the index of its position in the file */
  vertexOf: Uint32Array;
  uvOf: Uint32Array;
  normalOf: Uint32Array;
  /** per corner: its vertex */
  indices: Uint32Array;
}

/**
 * The first corner at a position gets the position's number, so that vertices are numbered as in the file; corners there
 * with other UVs or normals are numbered after all positions. With `onlyUsed`, positions that no corner names are left out
 * and the others are numbered in the order of their first use.
 */
export function splitVertices(parts: ObjCorners[], positionCount: number, onlyUsed: boolean): ObjVertices {
  const splitter = new VertexSplitter(onlyUsed ? usedPositions(parts) : null, positionCount);
  const indices = new Uint32Array(parts.reduce((sum, { vertices }) => sum + vertices.length, 0));
  let at = 0;
  for (const part of parts) {
    const [vertices, uvs, normals] = [part.vertices.view(), part.uvs.view(), part.normals.view()];
    for (let i = 0; i < vertices.length; ++i)
      indices[at++] = splitter.vertexFor(vertices[i], uvs[i], normals[i]);
  }
  return { ...splitter.finish(), indices };
}

/** Numbers the positions that corners name in the order of their first use. */
function usedPositions(parts: ObjCorners[]): Map<number, number> {
  const numbers = new Map<number, number>();
  for (const { vertices } of parts)
    for (const vertex of vertices.view()) if (!numbers.has(vertex)) numbers.set(vertex, numbers.size);
  return numbers;
}

class VertexSplitter {
  private readonly baseCount: number;
  private readonly isTaken: Uint8Array;
  private readonly vertexOf = new GrowingIndices();
  private readonly uvOf = new GrowingIndices();
  private readonly normalOf = new GrowingIndices();
  /** by the hash of a corner: the first vertex with it; `next` leads to the others */
  private readonly firstOf = new Map<number, number>();
  private readonly next = new Map<number, number>();

  constructor(
    private readonly numbers: Map<number, number> | null,
    positionCount: number,
  ) {
    this.baseCount = numbers?.size ?? positionCount;
    this.isTaken = new Uint8Array(this.baseCount);
    if (numbers) for (const vertex of numbers.keys()) this.add(vertex, NONE, NONE);
    else for (let vertex = 0; vertex < positionCount; ++vertex) this.add(vertex, NONE, NONE);
  }

  /** The vertex with this UV and normal: that of the file, or a new one if the former already has others. */
  vertexFor(vertex: number, uv: number, normal: number): number {
    const base = this.numbers ? this.numbers.get(vertex)! : vertex;
    if (!this.isTaken[base]) {
      this.isTaken[base] = 1;
      this.uvOf.view()[base] = uv;
      this.normalOf.view()[base] = normal;
      return base;
    }
    if (this.uvOf.at(base) === uv && this.normalOf.at(base) === normal) return base;
    // A position may have a hundred thousand corners, so they are not searched one by one.
    const hash = hashOf(base, uv, normal);
    const first = this.firstOf.get(hash);
    for (let found = first; found !== undefined; found = this.next.get(found))
      if (this.isCorner(found, vertex, uv, normal)) return found;
    const added = this.add(vertex, uv, normal);
    this.firstOf.set(hash, added);
    if (first !== undefined) this.next.set(added, first);
    return added;
  }

  private isCorner(found: number, vertex: number, uv: number, normal: number): boolean {
    return (
      this.vertexOf.at(found) === vertex && this.uvOf.at(found) === uv && this.normalOf.at(found) === normal
    );
  }

  finish(): Omit<ObjVertices, 'indices'> {
    return {
      vertexOf: this.vertexOf.finish(),
      uvOf: this.uvOf.finish(),
      normalOf: this.normalOf.finish(),
    };
  }

  private add(vertex: number, uv: number, normal: number): number {
    this.vertexOf.push(vertex);
    this.uvOf.push(uv);
    this.normalOf.push(normal);
    return this.vertexOf.length - 1;
  }
}

/** 32 bits that spread the three indices; the constants are odd and without structure. */
function hashOf(vertex: number, uv: number, normal: number): number {
  const mixed =
    Math.imul(vertex, 0x9e3779b1) ^ Math.imul(uv + 1, 0x85ebca6b) ^ Math.imul(normal + 1, 0xc2b2ae35);
  return mixed ^ (mixed >>> 15);
}
