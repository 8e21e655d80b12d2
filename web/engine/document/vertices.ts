/** Splits the vertices of a result where the attributes of their corners differ, as a primitive of the file needs. */

import type { Primitive } from '@gltf-transform/core';
import { NONE } from '../core/core';
import type { CornerSources, TriangleMesh } from '../core/core';
import type { VertexSources } from './blend';
import type { Body, PrimitiveSpan } from './model';

/** The part of a mesh that one primitive of the file shows. */
export interface PrimitiveGeometry {
  /** per vertex of the primitive: its vertex of the mesh, and the first corner of the mesh that uses it */
  vertexOfMesh: number[];
  firstCorner: number[];
  /** per vertex of the primitive: a key of ResultNormals, or CARRIED */
  normalKey: number[];
  sources: VertexSources;
  indices: number[];
}

/** Stands for a key where the normal, if any, is interpolated from the sources. */
export const CARRIED = -1;

/** A mesh with the points of the body that the attributes of its corners come from. */
export interface SourcedMesh {
  mesh: TriangleMesh;
  body: Body;
  sources: CornerSources;
}

/** Turns the corners of `triangles` into vertices, in the order of their first use. */
export function geometryOf(
  sourced: SourcedMesh,
  span: PrimitiveSpan,
  primitive: Primitive,
  triangles: number[],
  normalKeyOf: (corner: number) => number,
): PrimitiveGeometry {
  const gathering = new VertexGathering(sourced, span, primitive);
  for (const t of triangles)
    for (let corner = 3 * t; corner < 3 * t + 3; ++corner) gathering.add(corner, normalKeyOf(corner));
  return gathering.finish();
}

/** Whether the three corners of triangle t are still vertices of the body's triangle `source`. */
export function isUntouched({ triangle, barycentric }: CornerSources, t: number, source: number): boolean {
  const isWhole = (corner: number) =>
    triangle[corner] === source && barycentric.subarray(3 * corner, 3 * corner + 3).includes(1);
  return isWhole(3 * t) && isWhole(3 * t + 1) && isWhole(3 * t + 2);
}

class VertexGathering {
  private readonly vertexOfMesh: number[] = [];
  private readonly firstCorner: number[] = [];
  private readonly normalKey: number[] = [];
  private readonly indices: number[] = [];
  private readonly vertices: number[] = [];
  private readonly shares: number[] = [];
  /** per vertex of the mesh: the last vertex written there; `previous` links it to the earlier ones */
  private readonly lastAt = new Map<number, number>();
  private readonly previous: number[] = [];
  private readonly normals: ArrayLike<number> | null;
  private readonly compared: { array: ArrayLike<number>; size: number }[];

  constructor(
    private readonly sourced: SourcedMesh,
    private readonly span: PrimitiveSpan,
    primitive: Primitive,
  ) {
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
    const [vertices, shares] = this.sourceOf(corner);
    let found = this.lastAt.get(vertex) ?? NONE;
    while (found !== NONE && !this.isSame(found, normalKey, vertices, shares)) found = this.previous[found];
    if (found === NONE) {
      found = this.vertexOfMesh.length;
      this.vertexOfMesh.push(vertex);
      this.firstCorner.push(corner);
      this.normalKey.push(normalKey);
      this.vertices.push(...vertices);
      this.shares.push(...shares);
      this.previous.push(this.lastAt.get(vertex) ?? NONE);
      this.lastAt.set(vertex, found);
    }
    this.indices.push(found);
  }

  finish(): PrimitiveGeometry {
    const { vertexOfMesh, firstCorner, normalKey, indices } = this;
    const sources = { vertices: Uint32Array.from(this.vertices), shares: Float32Array.from(this.shares) };
    return { vertexOfMesh, firstCorner, normalKey, sources, indices };
  }

  /** Three vertices of the primitive and their shares; a corner on a single vertex has shares 1, 0, 0. */
  private sourceOf(corner: number): [number[], number[]] {
    const { body, sources } = this.sourced;
    const first = 3 * sources.triangle[corner];
    const vertices = [0, 1, 2].map((k) => body.indices[first + k] - this.span.firstVertex);
    const shares = [0, 1, 2].map((k) => sources.barycentric[3 * corner + k]);
    const whole = shares.indexOf(1);
    if (whole < 0) return [vertices, shares];
    return [
      [vertices[whole], vertices[whole], vertices[whole]],
      [1, 0, 0],
    ];
  }

  private isSame(written: number, normalKey: number, vertices: number[], shares: number[]): boolean {
    if (this.normalKey[written] !== normalKey) return false;
    const at = 3 * written;
    for (let k = 0; k < 3; ++k) if (this.shares[at + k] !== shares[k]) return false;
    if (shares[0] === 1) return this.looksLike(this.vertices[at], vertices[0], normalKey === CARRIED);
    return [0, 1, 2].every((k) => this.vertices[at + k] === vertices[k]);
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
