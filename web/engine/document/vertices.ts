/** Splits the vertices of a result where the attributes of their corners differ, as a primitive of the file needs. */

import type { Primitive } from '@gltf-transform/core';
import { DistinctMembers, extendHash } from '../core/distinct_members';
import { NONE } from '../core/core';
import type { CornerSources, TriangleMesh } from '../core/core';
import type { VertexSources } from './blend';
import { GrowingFloats, GrowingIndices } from './growing';
import type { Body, PrimitiveSpan } from './model';

/** The part of a mesh that one primitive of the file shows. */
export interface PrimitiveGeometry {
  /** per vertex of the primitive: its vertex of the mesh, and the first corner of the mesh that uses it */
  vertexOfMesh: Uint32Array;
  firstCorner: Uint32Array;
  /** per vertex of the primitive: a key of ResultNormals, or CARRIED */
  normalKey: Uint32Array;
  sources: VertexSources;
  indices: Uint32Array;
}

/** The key of a normal that is interpolated from the sources, or of a corner without normal. */
export const CARRIED = NONE;

/** A mesh with the points of the body that the attributes of its corners come from; null: there are no attributes. */
export interface SourcedMesh {
  mesh: TriangleMesh;
  body: Body;
  sources: CornerSources | null;
}

/** Turns the corners of `triangles` into vertices, in the order of their first use. */
export function geometryOf(
  sourced: SourcedMesh,
  span: PrimitiveSpan,
  primitive: Primitive,
  triangles: Uint32Array,
  normalKeyOf: (corner: number) => number,
): PrimitiveGeometry {
  const gathering = new VertexGathering(sourced, span, primitive, 3 * triangles.length);
  for (const t of triangles)
    for (let corner = 3 * t; corner < 3 * t + 3; ++corner) gathering.add(corner, normalKeyOf(corner));
  return gathering.finish();
}

/** Whether the three corners of triangle t are still vertices of the body's triangle `source`. */
export function isUntouched({ triangle, barycentric }: CornerSources, t: number, source: number): boolean {
  const isWhole = (corner: number) => triangle[corner] === source && wholeShare(barycentric, corner) >= 0;
  return isWhole(3 * t) && isWhole(3 * t + 1) && isWhole(3 * t + 2);
}

/** Which of the three shares of a corner is 1; -1: none is. */
export function wholeShare(barycentric: Float32Array, corner: number): number {
  for (let k = 0; k < 3; ++k) if (barycentric[3 * corner + k] === 1) return k;
  return -1;
}

class VertexGathering {
  private readonly vertexOfMesh = new GrowingIndices();
  private readonly firstCorner = new GrowingIndices();
  private readonly normalKey = new GrowingIndices();
  private readonly indices: Uint32Array;
  private readonly vertices = new GrowingIndices();
  private readonly shares = new GrowingFloats();
  /** the vertices that are written, by vertices of the mesh */
  private readonly written = new DistinctMembers((one) =>
    this.hashOf(this.normalKey.at(one), this.shares.at(3 * one), this.vertices.view().subarray(3 * one)),
  );
  private readonly normals: ArrayLike<number> | null;
  private readonly compared: { array: ArrayLike<number>; size: number }[];
  private added = 0;
  /** of the current corner: three vertices of the primitive, and their shares */
  private readonly vertex = new Uint32Array(3);
  private readonly share = new Float32Array(3);

  constructor(
    private readonly sourced: SourcedMesh,
    private readonly span: PrimitiveSpan,
    primitive: Primitive,
    corners: number,
  ) {
    this.indices = new Uint32Array(corners);
    this.normals = primitive.getAttribute('NORMAL')?.getArray() ?? null;
    const others = primitive.listSemantics().filter((name) => name !== 'POSITION' && name !== 'NORMAL');
    const accessors = [
      ...others.map((semantic) => primitive.getAttribute(semantic)!),
      ...primitive.listTargets().flatMap((target) => target.listAttributes()),
    ];
    this.compared = accessors.map((accessor) => ({
      array: accessor.getArray()!,
      size: accessor.getElementSize(),
    }));
  }

  add(corner: number, normalKey: number): void {
    const vertex = this.sourced.mesh.triangles[corner];
    this.select(corner);
    const isSame = (written: number) => this.isSame(written, normalKey);
    let found = this.written.find(vertex, isSame, () => this.hashOf(normalKey, this.share[0], this.vertex));
    if (found === NONE) {
      this.vertexOfMesh.push(vertex);
      this.firstCorner.push(corner);
      this.normalKey.push(normalKey);
      for (const source of this.vertex) this.vertices.push(source);
      this.shares.push3(this.share[0], this.share[1], this.share[2]);
      found = this.written.add(vertex);
    }
    this.indices[this.added++] = found;
  }

  finish(): PrimitiveGeometry {
    return {
      vertexOfMesh: this.vertexOfMesh.finish(),
      firstCorner: this.firstCorner.finish(),
      normalKey: this.normalKey.finish(),
      sources: { vertices: this.vertices.finish(), shares: this.shares.finish() },
      indices: this.indices,
    };
  }

  /** Makes a corner the current one. A corner on a single vertex has that vertex three times, and the shares 1, 0, 0. Without attributes all corners are equal. */
  private select(corner: number): void {
    const { body, sources } = this.sourced;
    if (!sources) return;
    const first = 3 * sources.triangle[corner];
    const whole = wholeShare(sources.barycentric, corner);
    for (let k = 0; k < 3; ++k) {
      const from = whole < 0 ? k : whole;
      this.vertex[k] = body.indices[first + from] - this.span.firstVertex;
      this.share[k] = whole < 0 ? sources.barycentric[3 * corner + k] : k === 0 ? 1 : 0;
    }
  }

  /** Whether the written vertex number `written` is that of the current corner. */
  private isSame(written: number, normalKey: number): boolean {
    if (this.normalKey.at(written) !== normalKey) return false;
    const at = 3 * written;
    for (let k = 0; k < 3; ++k) if (this.shares.at(at + k) !== this.share[k]) return false;
    if (this.share[0] === 1)
      return this.looksLike(this.vertices.at(at), this.vertex[0], normalKey === CARRIED);
    for (let k = 0; k < 3; ++k) if (this.vertices.at(at + k) !== this.vertex[k]) return false;
    return true;
  }

  /** Equal for vertices that are the same; `share`: of the first of its sources. */
  private hashOf(normalKey: number, share: number, vertices: Uint32Array): number {
    const hash = extendHash(normalKey, share);
    if (share !== 1) return extendHash(extendHash(hash, vertices[0]), vertices[1]);
    const carried = this.normals && normalKey === CARRIED ? [{ array: this.normals, size: 3 }] : [];
    return [...this.compared, ...carried].reduce((all, { array, size }) => {
      let own = all;
      for (let c = 0; c < size; ++c) own = extendHash(own, array[size * vertices[0] + c]);
      return own;
    }, hash);
  }

  /** Whether two vertices of the primitive have equal attributes and displacements. */
  private looksLike(a: number, b: number, withNormals: boolean): boolean {
    if (a === b) return true;
    const agree = ({ array, size }: { array: ArrayLike<number>; size: number }): boolean => {
      for (let c = 0; c < size; ++c) if (array[size * a + c] !== array[size * b + c]) return false;
      return true;
    };
    const isLikeNormal = !withNormals || !this.normals || agree({ array: this.normals, size: 3 });
    return isLikeNormal && this.compared.every(agree);
  }
}
