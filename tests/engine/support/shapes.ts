/** Small closed and open surfaces, oriented outwards. */

import type { TriangleMesh } from '../../../web/engine/core/core';

/** A flat grid over [0, 1]^2 in the xy plane of cellsX * cellsY cells with two triangles each. */
export function grid(cellsX: number, cellsY: number): TriangleMesh {
  const positions: number[] = [];
  const triangles: number[] = [];
  const at = (i: number, j: number) => j * (cellsX + 1) + i;
  for (let j = 0; j <= cellsY; ++j)
    for (let i = 0; i <= cellsX; ++i) positions.push(i / cellsX, j / cellsY, 0);
  for (let j = 0; j < cellsY; ++j)
    for (let i = 0; i < cellsX; ++i)
      triangles.push(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j), at(i + 1, j + 1), at(i, j + 1));
  return { positions: Float32Array.from(positions), triangles: Uint32Array.from(triangles) };
}

/** A torus around z with radii 1 and 0.4: around * across * 2 triangles, genus 1. */
export function torus(around = 24, across = 12): TriangleMesh {
  const positions: number[] = [];
  const triangles: number[] = [];
  for (let i = 0; i < around; ++i)
    for (let j = 0; j < across; ++j) {
      const [u, v] = [(2 * Math.PI * i) / around, (2 * Math.PI * j) / across];
      const radius = 1 + 0.4 * Math.cos(v);
      positions.push(radius * Math.cos(u), radius * Math.sin(u), 0.4 * Math.sin(v));
      const at = (di: number, dj: number) => ((i + di) % around) * across + ((j + dj) % across);
      triangles.push(at(0, 0), at(1, 0), at(1, 1), at(0, 0), at(1, 1), at(0, 1));
    }
  return { positions: Float32Array.from(positions), triangles: Uint32Array.from(triangles) };
}

/** The cube [0, 1]^3 of 12 triangles. */
export function cube(): TriangleMesh {
  const positions = Float32Array.from({ length: 24 }, (_, i) => (Math.floor(i / 3) >> (i % 3)) & 1);
  const faces = [
    [0, 2, 3, 1],
    [4, 5, 7, 6],
    [0, 1, 5, 4],
    [2, 6, 7, 3],
    [0, 4, 6, 2],
    [1, 3, 7, 5],
  ];
  const triangles = faces.flatMap(([a, b, c, d]) => [a, b, c, a, c, d]);
  return { positions, triangles: Uint32Array.from(triangles) };
}

/** The surface of a box of cellsX x cellsY x cellsZ unit cells, two triangles each. */
export function box(cellsX: number, cellsY: number, cellsZ: number): TriangleMesh {
  const cells = [cellsX, cellsY, cellsZ];
  const numbers = new Map<string, number>();
  const triangles: number[] = [];
  const at = (point: number[]): number => {
    const key = point.join();
    if (!numbers.has(key)) numbers.set(key, numbers.size);
    return numbers.get(key)!;
  };
  for (const [axis, side] of [0, 1, 2].flatMap((one) => [[one, 0] as const, [one, 1] as const])) {
    const [u, v] = [(axis + 1) % 3, (axis + 2) % 3];
    for (let j = 0; j < cells[v]; ++j)
      for (let i = 0; i < cells[u]; ++i) {
        const corner = (di: number, dj: number): number => {
          const point = [0, 0, 0];
          point[axis] = side * cells[axis];
          point[u] = i + di;
          point[v] = j + dj;
          return at(point);
        };
        const [a, b, c, d] = [corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)];
        triangles.push(...(side ? [a, b, c, a, c, d] : [a, c, b, a, d, c]));
      }
  }
  const positions = Float32Array.from([...numbers.keys()].flatMap((key) => key.split(',').map(Number)));
  return { positions, triangles: Uint32Array.from(triangles) };
}

export function toObj({ positions, triangles }: TriangleMesh): string {
  const lines: string[] = [];
  for (let v = 0; v < positions.length; v += 3) lines.push(`v ${positions.slice(v, v + 3).join(' ')}`);
  for (let t = 0; t < triangles.length; t += 3)
    lines.push(`f ${[...triangles.slice(t, t + 3)].map((v) => v + 1).join(' ')}`);
  return `${lines.join('\n')}\n`;
}

/** Sum of the triangles' areas. */
export function areaOf({ positions, triangles }: TriangleMesh): number {
  let area = 0;
  for (let t = 0; t < triangles.length; t += 3)
    area += triangleArea(positions, [...triangles.slice(t, t + 3)]);
  return area;
}

export function triangleArea(positions: ArrayLike<number>, corners: number[]): number {
  const [a, b, c] = corners.map((v) => [0, 1, 2].map((axis) => positions[3 * v + axis]));
  const [u, w] = [b.map((value, i) => value - a[i]), c.map((value, i) => value - a[i])];
  return Math.hypot(u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2], u[0] * w[1] - u[1] * w[0]) / 2;
}

/** A wavy sheet over [-1, 1] x [0, 1] of 2 * cellsX * cellsY cells, mirror-symmetric across x = 0 with its triangles. */
export function butterfly(cellsX = 6, cellsY = 8): TriangleMesh {
  const positions: number[] = [];
  const triangles: number[] = [];
  for (let j = 0; j <= cellsY; ++j)
    for (let i = -cellsX; i <= cellsX; ++i) {
      const [x, y] = [Math.abs(i) / cellsX, j / cellsY];
      positions.push(i / cellsX, y, 0.2 * x * x + 0.1 * Math.sin(5 * y + 2 * x));
    }
  const at = (i: number, j: number) => j * (2 * cellsX + 1) + i + cellsX;
  for (let j = 0; j < cellsY; ++j)
    for (let i = 0; i < cellsX; ++i) {
      triangles.push(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j), at(i + 1, j + 1), at(i, j + 1));
      triangles.push(
        at(-i, j),
        at(-i - 1, j + 1),
        at(-i - 1, j),
        at(-i, j),
        at(-i, j + 1),
        at(-i - 1, j + 1),
      );
    }
  return { positions: Float32Array.from(positions), triangles: Uint32Array.from(triangles) };
}
