import { standing, type Shape } from './shape';

const cells = [8, 24, 8] as const;
const cellSize = 1 / 8;

/** The paper's rectangle: a closed upright bar of 8 x 24 x 8 cells (1 x 3 x 1 m), 898 vertices and 1,792 faces. */
export function makeBar(): Shape {
  const points: number[] = [];
  const triangles: number[] = [];
  const vertexOf = new Map<string, number>();
  const vertexAt = (corner: readonly number[]) => {
    const key = corner.join();
    if (!vertexOf.has(key)) {
      vertexOf.set(key, points.length / 3);
      points.push(...corner.map((step) => step * cellSize));
    }
    return vertexOf.get(key)!;
  };
  for (let axis = 0; axis < 3; axis++)
    for (const end of [0, cells[axis]])
      for (const quad of sideQuads(axis, end)) {
        const [a, b, c, d] = quad.map(vertexAt);
        triangles.push(a, b, c, a, c, d);
      }
  return standing(points, triangles);
}

/** The quads of the side where coordinate `axis` is `end`; corners in cells, counter-clockwise seen from outside. */
function sideQuads(axis: number, end: number): number[][][] {
  const [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
  const corner = (i: number, j: number) => {
    const steps = [end, end, end];
    steps[u] = i;
    steps[v] = j;
    return steps;
  };
  const quads: number[][][] = [];
  for (let j = 0; j < cells[v]; j++)
    for (let i = 0; i < cells[u]; i++) {
      const quad = [corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)];
      quads.push(end > 0 ? quad : [quad[0], quad[3], quad[2], quad[1]]);
    }
  return quads;
}
