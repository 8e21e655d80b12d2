// A solid made of prisms. Its skin consists of the faces that belong to only one prism; if all prisms meet face to face,
// the skin is closed by construction.

import { angleBetween, cross, dot, length, pointAt, subtract, type Point } from '../shape';

/** Points closer than this (metres) are one vertex; far below any strut's width and far above rounding. */
const resolution = 1e-6;

export class CellComplex {
  private readonly points: number[] = [];
  private readonly vertexOf = new Map<string, number>();
  private readonly openFaces = new Map<string, number[]>();

  /** Adds the prism between two loops with equal numbers of corners; adjacent prisms must share whole faces. */
  addPrism(bottom: readonly Point[], top: readonly Point[]): void {
    const low = bottom.map((point) => this.vertexAt(point));
    const high = top.map((point) => this.vertexAt(point));
    const faces = [[...low].reverse(), high];
    low.forEach((vertex, i) => {
      const next = (i + 1) % low.length;
      faces.push([vertex, low[next], high[next], high[i]]);
    });
    const isInsideOut = this.volume(faces) < 0;
    for (const face of faces) this.toggleFace(isInsideOut ? face.reverse() : face);
  }

  /** All faces that belong to only one prism, as triangles counter-clockwise seen from outside, and their vertices. */
  skin(): { points: number[]; triangles: number[] } {
    const triangles = [...this.openFaces.values()].flatMap((face) => this.triangulate(face));
    const used = [...new Set(triangles)].sort((a, b) => a - b); // the others are interior
    const renumbered = new Map(used.map((vertex, i) => [vertex, i]));
    return {
      points: used.flatMap((vertex) => pointAt(this.points, vertex)),
      triangles: triangles.map((vertex) => renumbered.get(vertex)!),
    };
  }

  private vertexAt(point: Point): number {
    const key = point.map((value) => Math.round(value / resolution)).join();
    const known = this.vertexOf.get(key);
    if (known !== undefined) return known;
    const vertex = this.points.length / 3;
    this.vertexOf.set(key, vertex);
    this.points.push(...point);
    return vertex;
  }

  /** A face that occurs a second time is between two prisms and not part of the skin. */
  private toggleFace(face: number[]): void {
    const key = [...face].sort((a, b) => a - b).join();
    if (!this.openFaces.delete(key)) this.openFaces.set(key, face);
  }

  private volume(faces: number[][]): number {
    let sum = 0;
    for (const face of faces)
      for (let i = 2; i < face.length; i++) {
        const [a, b, c] = [face[0], face[i - 1], face[i]].map((v) => pointAt(this.points, v));
        sum += dot(a, cross(b, c));
      }
    return sum / 6;
  }

  private triangulate(face: number[]): number[] {
    const corners = this.fromLowestCorner(face);
    return bestTriangulation(corners.map((v) => pointAt(this.points, v))).map((corner) => corners[corner]);
  }

  /** Starts the loop at its lowest corner, the innermost of equals, so that mirrored faces get mirrored diagonals. */
  private fromLowestCorner(face: number[]): number[] {
    const rank = face.map((v) => {
      const [x, y, z] = pointAt(this.points, v);
      return Math.round(y * 1e5) + Math.round(Math.hypot(x, z) * 1e4) * 1e-6;
    });
    const start = rank.indexOf(Math.min(...rank));
    return [...face.slice(start), ...face.slice(0, start)];
  }
}

/**
 * The triangulation of a convex polygon (corners may be collinear) that maximises the smallest angle, by dynamic
 * programming over chords. Returns three corner indices per triangle. Ties go to chords from corner 0.
 */
export function bestTriangulation(polygon: readonly Point[]): number[] {
  const count = polygon.length;
  const angle = Array.from({ length: count }, () => new Array<number>(count).fill(Math.PI));
  const apex = Array.from({ length: count }, () => new Array<number>(count).fill(-1));
  for (let span = 2; span < count; span++)
    for (let i = 0; i + span < count; i++) {
      const j = i + span;
      angle[i][j] = -1;
      for (let k = j - 1; k > i; k--) {
        const smallest = Math.min(
          angle[i][k],
          angle[k][j],
          smallestAngle(polygon[i], polygon[k], polygon[j]),
        );
        if (smallest > angle[i][j] + 1e-4) [angle[i][j], apex[i][j]] = [smallest, k];
      }
    }
  const triangles: number[] = [];
  const collect = (i: number, j: number) => {
    const k = apex[i][j];
    if (k < 0) return;
    triangles.push(i, k, j);
    collect(i, k);
    collect(k, j);
  };
  collect(0, count - 1);
  return triangles;
}

/** The smallest angle of a triangle, radians; 0 if it is degenerate. */
export function smallestAngle(a: Point, b: Point, c: Point): number {
  const [ab, bc, ca] = [subtract(b, a), subtract(c, b), subtract(a, c)];
  if (length(cross(ab, bc)) === 0) return 0;
  const negative = (p: Point): Point => [-p[0], -p[1], -p[2]];
  return Math.min(
    angleBetween(ab, negative(ca)),
    angleBetween(bc, negative(ab)),
    angleBetween(ca, negative(bc)),
  );
}
