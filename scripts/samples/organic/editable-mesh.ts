// A closed manifold mesh whose edges can be split, collapsed and flipped; every operation keeps its topology.

import { cross, dot, pointAt, subtract, type Point } from '../shape';
import type { Net } from './marching-tetrahedra';

export class EditableMesh {
  readonly points: number[];
  private readonly corners: (readonly [number, number, number] | undefined)[] = [];
  private readonly facesOf: Set<number>[] = [];

  constructor({ points, triangles }: Net) {
    this.points = [...points];
    for (let v = 0; v < points.length / 3; v++) this.facesOf.push(new Set());
    for (let t = 0; t < triangles.length; t += 3)
      this.addFace(triangles[t], triangles[t + 1], triangles[t + 2]);
  }

  /** The mesh without removed elements; vertices are renumbered in order. */
  net(): Net {
    const renumbered: number[] = [];
    const points: number[] = [];
    this.facesOf.forEach((faces, v) => {
      if (faces.size === 0) return;
      renumbered[v] = points.length / 3;
      points.push(...this.point(v));
    });
    return { points, triangles: this.corners.flatMap((face) => face?.map((v) => renumbered[v]) ?? []) };
  }

  get vertexCount(): number {
    return this.facesOf.length;
  }

  point(v: number): Point {
    return pointAt(this.points, v);
  }

  move(v: number, [x, y, z]: Point): void {
    [this.points[3 * v], this.points[3 * v + 1], this.points[3 * v + 2]] = [x, y, z];
  }

  /** Every edge once, with the smaller vertex first. */
  edges(): [number, number][] {
    return this.corners.flatMap((face) =>
      face
        ? face.map((a, i): [number, number] => [a, face[(i + 1) % 3]]).filter(([a, b]) => a < b) // the face on the other side has b, a
        : [],
    );
  }

  neighbours(v: number): number[] {
    return [...this.facesOf[v]].map((t) => nextCorner(this.corners[t]!, v));
  }

  valence(v: number): number {
    return this.facesOf[v].size;
  }

  isEdge(a: number, b: number): boolean {
    return this.sharedFaces(a, b).length === 2;
  }

  /** The corners opposite an edge in its two faces: first left of a -> b, then right of it. */
  opposite(a: number, b: number): [number, number] {
    const [left, right] = [this.faceWith(a, b), this.faceWith(b, a)];
    return [nextCorner(this.corners[left]!, b), nextCorner(this.corners[right]!, a)];
  }

  /** Splits an edge and its two faces at `middle`. */
  split(a: number, b: number, middle: Point): void {
    const [left, right] = this.opposite(a, b);
    const v = this.vertexCount;
    this.facesOf.push(new Set());
    this.points.push(...middle);
    for (const face of this.sharedFaces(a, b)) this.removeFace(face);
    this.addFace(a, v, left);
    this.addFace(v, b, left);
    this.addFace(b, v, right);
    this.addFace(v, a, right);
  }

  /** Whether a and b have only the two corners opposite their edge as common neighbours (link condition). */
  canCollapse(a: number, b: number): boolean {
    const around = new Set(this.neighbours(a));
    const common = this.neighbours(b).filter((v) => around.has(v));
    return common.length === 2 && common.every((v) => this.valence(v) > 3);
  }

  /** Collapses `b` into `a`, which moves to `target`. */
  collapse(a: number, b: number, target: Point): void {
    for (const face of this.sharedFaces(a, b)) this.removeFace(face);
    for (const face of [...this.facesOf[b]]) {
      const [i, j, k] = this.corners[face]!.map((v) => (v === b ? a : v));
      this.removeFace(face);
      this.addFace(i, j, k);
    }
    this.move(a, target);
  }

  /** Flips the edge a, b; the new edge must not exist yet. */
  flip(a: number, b: number): void {
    const [left, right] = this.opposite(a, b);
    for (const face of this.sharedFaces(a, b)) this.removeFace(face);
    this.addFace(left, right, b);
    this.addFace(right, left, a);
  }

  /** Normals (length: twice the area) of the faces at `v` if it were at `position`, without faces at `except`. */
  normalsAround(v: number, position: Point, except?: number): Point[] {
    const faces = [...this.facesOf[v]].map((t) => this.corners[t]!);
    return faces
      .filter((face) => except === undefined || !face.includes(except))
      .map((face) => {
        const [a, b, c] = face.map((corner) => (corner === v ? position : this.point(corner)));
        return cross(subtract(b, a), subtract(c, a));
      });
  }

  /** Whether no face at `v` rotates by more than about 45 degrees when `v` moves to `position`. */
  keepsNormals(v: number, position: Point, except?: number): boolean {
    const before = this.normalsAround(v, this.point(v), except);
    const after = this.normalsAround(v, position, except);
    return before.every(
      (normal, i) => dot(normal, after[i]) > 0.7 * Math.hypot(...normal) * Math.hypot(...after[i]),
    );
  }

  private addFace(a: number, b: number, c: number): void {
    for (const v of [a, b, c]) this.facesOf[v].add(this.corners.length);
    this.corners.push([a, b, c]);
  }

  private removeFace(t: number): void {
    for (const v of this.corners[t]!) this.facesOf[v].delete(t);
    this.corners[t] = undefined;
  }

  private sharedFaces(a: number, b: number): number[] {
    return [...this.facesOf[a]].filter((t) => this.facesOf[b].has(t));
  }

  /** The face with the directed edge from a to b. */
  private faceWith(a: number, b: number): number {
    return this.sharedFaces(a, b).find((t) => nextCorner(this.corners[t]!, a) === b)!;
  }
}

/** The next corner after `v`, counter-clockwise. */
function nextCorner(face: readonly [number, number, number], v: number): number {
  return face[(face.indexOf(v) + 1) % 3];
}
