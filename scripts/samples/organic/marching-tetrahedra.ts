// Marching tetrahedra: every grid cube is cut into six tetrahedra, each crossed by a triangle or a quad. Triangles may be
// badly shaped, but the surface is a closed manifold by construction.

import { cross, dot, pointAt, subtract, type Point } from '../shape';
import type { Field } from './field';

export interface Box {
  low: Point;
  high: Point;
}

export interface Net {
  points: number[];
  /** Counter-clockwise seen from outside. */
  triangles: number[];
}

/** The surface field = 0 on a grid of `cell` metres; `box` must contain all of it. */
export function marchTetrahedra(field: Field, { low, high }: Box, cell: number): Net {
  const grid = new Grid(
    low,
    cell,
    [0, 1, 2].map((axis) => Math.ceil((high[axis] - low[axis]) / cell) + 1),
  );
  const values = Float64Array.from({ length: grid.nodeCount }, (_, node) => field(...grid.point(node)).value);
  const surface = new CutSurface(grid, values);
  for (let node = 0; node < grid.nodeCount; node++)
    if (grid.isCubeCorner(node))
      for (const steps of grid.tetrahedra) surface.cut(steps.map((step) => node + step));
  return surface.net;
}

class Grid {
  readonly nodeCount: number;
  /** The six tetrahedra of a cube around its long diagonal; steps from the cube's low corner to their nodes. */
  readonly tetrahedra: number[][];
  private readonly stride: number[];

  constructor(
    private readonly low: Point,
    private readonly cell: number,
    private readonly count: number[],
  ) {
    this.stride = [1, count[0], count[0] * count[1]];
    this.nodeCount = count[0] * count[1] * count[2];
    const [x, y, z] = this.stride;
    const paths = [
      [x, y],
      [y, x],
      [y, z],
      [z, y],
      [z, x],
      [x, z],
    ];
    this.tetrahedra = paths.map(([first, second]) => [0, first, first + second, x + y + z]);
  }

  point(node: number): Point {
    const at = (axis: number) => this.low[axis] + this.cell * this.step(node, axis);
    return [at(0), at(1), at(2)];
  }

  isCubeCorner(node: number): boolean {
    return [0, 1, 2].every((axis) => this.step(node, axis) + 1 < this.count[axis]);
  }

  private step(node: number, axis: number): number {
    return Math.floor(node / this.stride[axis]) % this.count[axis];
  }
}

class CutSurface {
  readonly net: Net = { points: [], triangles: [] };
  private readonly vertexOf = new Map<number, number>();

  constructor(
    private readonly grid: Grid,
    private readonly values: Float64Array,
  ) {}

  /** Adds the part of the surface within a tetrahedron. */
  cut(nodes: number[]): void {
    const inside = nodes.filter((node) => this.values[node] < 0);
    const outside = nodes.filter((node) => this.values[node] >= 0);
    if (inside.length === 0 || outside.length === 0) return;
    const outwards = subtract(this.grid.point(outside[0]), this.grid.point(inside[0]));
    const loop = [...inside].flatMap((a, i) => {
      const crossed = outside.map((b) => this.vertexBetween(a, b));
      return i % 2 ? crossed.reverse() : crossed; // with two nodes on each side, this order goes around the quad
    });
    const [a, b, c] = loop.map((vertex) => pointAt(this.net.points, vertex));
    const isInwards = dot(cross(subtract(b, a), subtract(c, a)), outwards) < 0;
    if (isInwards) loop.reverse();
    for (let i = 2; i < loop.length; i++) this.net.triangles.push(loop[0], loop[i - 1], loop[i]);
  }

  /** The vertex where the surface crosses an edge of the grid, kept away from its ends so that no triangle is flat. */
  private vertexBetween(inside: number, outside: number): number {
    const key = Math.min(inside, outside) * this.grid.nodeCount + Math.max(inside, outside);
    const known = this.vertexOf.get(key);
    if (known !== undefined) return known;
    const vertex = this.net.points.length / 3;
    const [low, high] = [this.values[inside], this.values[outside]];
    const fraction = Math.min(0.9, Math.max(0.1, low / (low - high)));
    const [from, to] = [this.grid.point(inside), this.grid.point(outside)];
    this.net.points.push(...from.map((x, axis) => x + fraction * (to[axis] - x)));
    this.vertexOf.set(key, vertex);
    return vertex;
  }
}
