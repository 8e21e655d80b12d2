/** Meshes of the validation cases, each in several kinds. Lengths in metres. */

import type { TriangleMesh } from '../../web/engine/core/core';

/**
 * regular: equal cells, one diagonal direction; union jack: equal cells, alternating diagonals; irregular: displaced
 * vertices, random diagonals; graded: the longest cell is about eight times as long as the shortest.
 */
export type MeshKind = 'regular' | 'union jack' | 'irregular' | 'graded';

/** Largest displacement of a vertex in an irregular mesh, in cells. */
const JITTER = 0.25;
const GRADING = 8;

type Random = () => number;

/** Pseudorandom numbers in [0, 1), the same for the same seed. */
function seeded(seed: number): Random {
  let state = seed >>> 0;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

/** 0 .. 1 in `cells` steps, which grow geometrically if graded. */
export function steps(cells: number, kind: MeshKind): number[] {
  if (kind !== 'graded') return Array.from({ length: cells + 1 }, (_, i) => i / cells);
  const ratio = GRADING ** (1 / (cells - 1));
  return Array.from({ length: cells + 1 }, (_, i) => (ratio ** i - 1) / (ratio ** cells - 1));
}

/** 0 .. 1 in `cells` steps around a ring; if graded, short on one side and long on the other. */
function ringSteps(cells: number, kind: MeshKind): number[] {
  const swing = kind === 'graded' ? (GRADING - 1) / (GRADING + 1) / (2 * Math.PI) : 0;
  return steps(cells, 'regular').map((t) => t + swing * Math.sin(2 * Math.PI * t));
}

interface Grid {
  /** parameters of the grid lines; a closed direction ends where it starts */
  x: number[];
  y: number[];
  closedX?: boolean;
  closedY?: boolean;
  /** further lines whose vertices keep their parameter in an irregular mesh, besides the ends of an open direction */
  fixedX?: (i: number) => boolean;
  fixedY?: (j: number) => boolean;
  place(x: number, y: number): [number, number, number];
}

function gridMesh(kind: MeshKind, { x, y, closedX, closedY, fixedX, fixedY, place }: Grid): TriangleMesh {
  const random = seeded(7);
  const [cellsX, cellsY] = [x.length - 1, y.length - 1];
  const [countX, countY] = [closedX ? cellsX : cellsX + 1, closedY ? cellsY : cellsY + 1];
  const moved = (lines: number[], i: number, isClosed?: boolean, isFixed?: (i: number) => boolean) => {
    const isEnd = !isClosed && (i === 0 || i === lines.length - 1);
    const offset = JITTER * (2 * random() - 1);
    if (kind !== 'irregular' || isEnd || isFixed?.(i)) return lines[i];
    return lines[i] + offset * (lines[i + 1] - lines[i]);
  };
  const positions: number[] = [];
  for (let j = 0; j < countY; j++)
    for (let i = 0; i < countX; i++)
      positions.push(...place(moved(x, i, closedX, fixedX), moved(y, j, closedY, fixedY)));
  const at = (i: number, j: number) => (j % countY) * countX + (i % countX);
  const triangles: number[] = [];
  for (let j = 0; j < cellsY; j++)
    for (let i = 0; i < cellsX; i++) {
      const quad = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
      triangles.push(...split(quad, otherDiagonal(kind, i + j, random)));
    }
  return { positions: Float32Array.from(positions), triangles: Uint32Array.from(triangles) };
}

function otherDiagonal(kind: MeshKind, cell: number, random: Random): boolean {
  if (kind === 'union jack') return cell % 2 === 1;
  return kind === 'irregular' && random() < 0.5;
}

const split = ([a, b, c, d]: number[], isOther: boolean) =>
  isOther ? [a, b, d, b, c, d] : [a, b, c, a, c, d];

/** A unit square in the plane z = 0. A frame adds a row of cells outside along the given sides. */
export function plate(cells: number, kind: MeshKind, frame: 'none' | 'left' | 'all' = 'none'): TriangleMesh {
  const inner = steps(cells, kind);
  const before = [inner[0] - (inner[1] - inner[0])];
  const after = [2 - inner[cells - 1]];
  const x = frame === 'none' ? inner : [...before, ...inner, ...(frame === 'all' ? after : [])];
  const y = frame === 'all' ? x : inner;
  const isBorder = (lines: number[]) => (i: number) => lines[i] === 0 || lines[i] === 1;
  return gridMesh(kind, { x, y, fixedX: isBorder(x), fixedY: isBorder(y), place: (u, v) => [u, v, 0] });
}

/** A cylinder without caps around the z axis; graded along its length. */
export function tube(around: number, along: number, kind: MeshKind, [radius, length]: [number, number]) {
  return gridMesh(kind, {
    x: ringSteps(around, length > radius ? 'regular' : kind),
    y: steps(along, length > radius ? kind : 'regular'),
    closedX: true,
    place: (t, z) => {
      const angle = 2 * Math.PI * t;
      return [radius * Math.cos(angle), radius * Math.sin(angle), length * z];
    },
  });
}

/** A closed ring of square cross-section around the z axis, `perSide` cells along each side; graded around. */
export function squareRing(
  around: number,
  perSide: number,
  kind: MeshKind,
  [radius, side]: [number, number],
) {
  const corner = (j: number) => j % perSide === 0;
  return gridMesh(kind, {
    x: ringSteps(around, kind),
    y: steps(4 * perSide, 'regular'),
    closedX: true,
    closedY: true,
    fixedY: corner,
    place: (t, s) => {
      const angle = 2 * Math.PI * t;
      const [outwards, up] = squareOutline(s);
      const r = radius + side * outwards;
      return [r * Math.cos(angle), r * Math.sin(angle), side * up];
    },
  });
}

/** A point on the outline of a unit square around 0, s in [0, 1), anticlockwise from (1/2, -1/2). */
function squareOutline(s: number): [number, number] {
  const side = Math.min(3, Math.floor(4 * s + 1e-12));
  const t = 4 * s - side - 0.5;
  return [
    [0.5, t],
    [-t, 0.5],
    [-0.5, -t],
    [t, -0.5],
  ][side] as [number, number];
}

/** The surface of a box from 0 to `size`, cut into cells[c] along axis c; graded along z. */
export function box(size: number[], cells: number[], kind: MeshKind): TriangleMesh {
  const random = seeded(11);
  const lines = [0, 1, 2].map((c) => steps(cells[c], c === 2 ? kind : 'regular').map((t) => t * size[c]));
  const vertices = new Map<string, number>();
  const positions: number[] = [];
  const triangles: number[] = [];
  const vertexAt = (p: number[]): number => {
    const key = p.join();
    if (!vertices.has(key)) {
      vertices.set(key, vertices.size);
      const isInner = p.map((i, c) => i > 0 && i < cells[c]);
      const isMoved = kind === 'irregular' && isInner.filter(Boolean).length === 2;
      p.forEach((i, c) => {
        const offset = isMoved && isInner[c] ? JITTER * (2 * random() - 1) * (size[c] / cells[c]) : 0;
        positions.push(lines[c][i] + offset);
      });
    }
    return vertices.get(key)!;
  };
  for (let axis = 0; axis < 3; axis++)
    for (const isFar of [false, true]) {
      const [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
      for (let j = 0; j < cells[v]; j++)
        for (let i = 0; i < cells[u]; i++) {
          const corner = (di: number, dj: number): number => {
            const p = [0, 0, 0];
            [p[axis], p[u], p[v]] = [isFar ? cells[axis] : 0, i + di, j + dj];
            return vertexAt(p);
          };
          const quad = [corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)];
          const outwards = isFar ? quad : [quad[0], quad[3], quad[2], quad[1]];
          triangles.push(...split(outwards, otherDiagonal(kind, i + j, random)));
        }
    }
  return { positions: Float32Array.from(positions), triangles: Uint32Array.from(triangles) };
}

/**
 * A unit sphere: regular is an octahedron whose edges are divided into `cuts`, irregular the same with displaced vertices,
 * graded a grid of longitudes and latitudes with needles at its poles.
 */
export function sphere(cuts: number, kind: MeshKind): TriangleMesh {
  return kind === 'graded' ? globe(4 * cuts, 2 * cuts) : octahedralSphere(cuts, kind);
}

function octahedralSphere(cuts: number, kind: MeshKind): TriangleMesh {
  const random = seeded(13);
  const vertices = new Map<string, number>();
  const positions: number[] = [];
  const triangles: number[] = [];
  const vertexAt = (p: number[]): number => {
    const key = p.map((value) => value + 0).join();
    if (!vertices.has(key)) {
      vertices.set(key, vertices.size);
      const moved = p.map((value) => value + (kind === 'irregular' ? JITTER * (2 * random() - 1) : 0));
      const length = Math.hypot(...moved);
      positions.push(...moved.map((value) => value / length));
    }
    return vertices.get(key)!;
  };
  for (const [x, y, z] of octants)
    for (let i = 0; i < cuts; i++)
      for (let j = 0; i + j < cuts; j++) {
        const corner = (p: number, q: number) => vertexAt([x * p, y * q, z * (cuts - p - q)]);
        const add = (a: number, b: number, c: number) =>
          triangles.push(a, x * y * z > 0 ? b : c, x * y * z > 0 ? c : b);
        add(corner(i, j), corner(i + 1, j), corner(i, j + 1));
        if (i + j + 1 < cuts) add(corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1));
      }
  return { positions: Float32Array.from(positions), triangles: Uint32Array.from(triangles) };
}

const octants = [1, -1].flatMap((x) => [1, -1].flatMap((y) => [1, -1].map((z) => [x, y, z])));

function globe(around: number, along: number): TriangleMesh {
  const positions = [0, 0, 1];
  const at = (j: number, i: number) =>
    j === 0 ? 0 : j === along ? (along - 1) * around + 1 : (j - 1) * around + 1 + (i % around);
  for (let j = 1; j < along; j++)
    for (let i = 0; i < around; i++) {
      const [theta, angle] = [(Math.PI * j) / along, (2 * Math.PI * i) / around];
      positions.push(Math.sin(theta) * Math.cos(angle), Math.sin(theta) * Math.sin(angle), Math.cos(theta));
    }
  positions.push(0, 0, -1);
  const triangles: number[] = [];
  for (let j = 0; j < along; j++)
    for (let i = 0; i < around; i++) {
      if (j + 1 < along) triangles.push(at(j, i), at(j + 1, i), at(j + 1, i + 1));
      if (j > 0) triangles.push(at(j, i), at(j + 1, i + 1), at(j, i + 1));
    }
  return { positions: Float32Array.from(positions), triangles: Uint32Array.from(triangles) };
}
