// Meshes for benchmarks, one component each: { positions: Float32Array, triangles: Uint32Array }, and their file format
// for tests/bench/native/shell_modes.cpp.

import { readFileSync, writeFileSync } from 'node:fs';

/** A grid of cellsX x cellsY quads, split along alternating diagonals, with vertices at place(x, y). */
function grid(cellsX, cellsY, { closedX = false, closedY = false, place }) {
  const countX = closedX ? cellsX : cellsX + 1;
  const countY = closedY ? cellsY : cellsY + 1;
  const positions = new Float32Array(3 * countX * countY);
  for (let j = 0; j < countY; j++)
    for (let i = 0; i < countX; i++) positions.set(place(i / cellsX, j / cellsY), 3 * (j * countX + i));
  const at = (i, j) => (j % countY) * countX + (i % countX);
  const triangles = new Uint32Array(6 * cellsX * cellsY);
  for (let j = 0, t = 0; j < cellsY; j++)
    for (let i = 0; i < cellsX; i++, t += 6) {
      const [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
      triangles.set((i + j) % 2 ? [a, b, c, a, c, d] : [a, b, d, b, c, d], t);
    }
  return { positions, triangles };
}

/** A torus of about `faces` triangles with a tube of 0.35 of its radius, slightly uneven so that no mode is multiple. */
export function torus(faces) {
  const across = Math.round(Math.sqrt((faces / 2) * 0.35));
  const around = Math.round(faces / 2 / across);
  return grid(around, across, {
    closedX: true,
    closedY: true,
    place: (x, y) => {
      const [u, v] = [2 * Math.PI * x, 2 * Math.PI * y];
      const tube = 0.35 * (1 + 0.1 * Math.sin(2 * u + 0.3));
      const radius = 1 + tube * Math.cos(v);
      return [radius * Math.cos(u), 0.9 * radius * Math.sin(u), tube * Math.sin(v)];
    },
  });
}

/** A wavy sheet of about `faces` triangles. */
export function cloth(faces) {
  const cells = Math.round(Math.sqrt(faces / 2));
  return grid(cells, cells, {
    place: (x, y) => [x, y, 0.03 * Math.sin(9 * x + 2 * y) * Math.cos(7 * y) + 0.05 * x * y],
  });
}

/** A sphere with soft bumps: an octahedron whose edges are divided to give about `faces` triangles. */
export function bumpySphere(faces) {
  const cuts = Math.round(Math.sqrt(faces / 8));
  const vertices = new Map();
  const positions = [];
  const triangles = [];
  const vertexAt = (x, y, z) => {
    const key = (x + cuts) * (2 * cuts + 1) ** 2 + (y + cuts) * (2 * cuts + 1) + z + cuts;
    if (!vertices.has(key)) {
      const length = Math.hypot(x, y, z);
      const [a, b, c] = [x / length, y / length, z / length];
      const r = 1 + 0.08 * Math.sin(5 * a + 1) * Math.sin(4 * b + 2) + 0.06 * Math.sin(6 * c);
      positions.push(a * r, b * r, c * r);
      vertices.set(key, vertices.size);
    }
    return vertices.get(key);
  };
  for (const [sx, sy, sz] of octants())
    for (let i = 0; i < cuts; i++)
      for (let j = 0; i + j < cuts; j++) {
        const corner = (p, q) => vertexAt(sx * p, sy * q, sz * (cuts - p - q));
        const add = (a, b, c) => triangles.push(...(sx * sy * sz > 0 ? [a, b, c] : [a, c, b]));
        add(corner(i, j), corner(i + 1, j), corner(i, j + 1));
        if (i + j + 1 < cuts) add(corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1));
      }
  return { positions: Float32Array.from(positions), triangles: Uint32Array.from(triangles) };
}

/** The surface of the paper's bar, 1 x 1 x 3, of `cells` x `cells` x 3 `cells` cells. */
export function bar(cells) {
  const size = [cells, cells, 3 * cells];
  const vertices = new Map();
  const positions = [];
  const triangles = [];
  const vertexAt = (axis, level, i, j) => {
    const place = [0, 0, 0];
    [place[axis], place[(axis + 1) % 3], place[(axis + 2) % 3]] = [level, i, j];
    const key = place.join();
    if (!vertices.has(key)) {
      vertices.set(key, vertices.size);
      positions.push(...place.map((x) => x / cells));
    }
    return vertices.get(key);
  };
  for (let axis = 0; axis < 3; axis++)
    for (const side of [0, 1])
      for (let j = 0; j < size[(axis + 2) % 3]; j++)
        for (let i = 0; i < size[(axis + 1) % 3]; i++) {
          const corner = (di, dj) => vertexAt(axis, side * size[axis], i + di, j + dj);
          const [a, b, c, d] = [corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)];
          triangles.push(...(side ? [a, b, c, a, c, d] : [a, c, b, a, d, c]));
        }
  return { positions: Float32Array.from(positions), triangles: Uint32Array.from(triangles) };
}

/** Vertex pairs of all edges, each once, in the order in which faces name them. */
export function edgesOf({ triangles }) {
  const edges = new Map();
  for (let t = 0; t < triangles.length; t += 3)
    for (let e = 0; e < 3; e++) {
      const [a, b] = [triangles[t + e], triangles[t + ((e + 1) % 3)]];
      const key = `${Math.min(a, b)},${Math.max(a, b)}`;
      if (!edges.has(key)) edges.set(key, [a, b]);
    }
  return [...edges.values()];
}

const octants = () => [1, -1].flatMap((x) => [1, -1].flatMap((y) => [1, -1].map((z) => [x, y, z])));

/** Positions and triangles of an OBJ file; polygons become fans. */
export function readObj(path) {
  const positions = [];
  const triangles = [];
  for (const line of readFileSync(path, 'utf8').split('\n')) {
    const [word, ...rest] = line.trim().split(/\s+/);
    if (word === 'v') positions.push(...rest.slice(0, 3).map((text) => Math.fround(Number(text))));
    if (word !== 'f') continue;
    const corners = rest.map((text) => Number.parseInt(text, 10));
    const face = corners.map((index) => (index < 0 ? positions.length / 3 + index : index - 1));
    for (let k = 2; k < face.length; k++) triangles.push(face[0], face[k - 1], face[k]);
  }
  return { positions: Float32Array.from(positions), triangles: Uint32Array.from(triangles) };
}

/** The component with the most triangles, without vertices that no triangle uses. */
export function largestComponent({ positions, triangles }) {
  const parent = Uint32Array.from({ length: positions.length / 3 }, (_, v) => v);
  const find = (v) => {
    while (parent[v] !== v) v = parent[v] = parent[parent[v]];
    return v;
  };
  for (let t = 0; t < triangles.length; t += 3)
    for (const other of [triangles[t + 1], triangles[t + 2]]) parent[find(other)] = find(triangles[t]);
  const counts = new Map();
  for (let t = 0; t < triangles.length; t += 3) {
    const root = find(triangles[t]);
    counts.set(root, (counts.get(root) ?? 0) + 1);
  }
  const [largest] = [...counts].reduce((best, entry) => (entry[1] > best[1] ? entry : best));
  const vertexOf = new Map();
  const kept = [];
  for (let t = 0; t < triangles.length; t += 3)
    if (find(triangles[t]) === largest)
      for (const v of triangles.subarray(t, t + 3)) {
        if (!vertexOf.has(v)) vertexOf.set(v, vertexOf.size);
        kept.push(vertexOf.get(v));
      }
  const moved = [...vertexOf.keys()].flatMap((v) => [...positions.subarray(3 * v, 3 * v + 3)]);
  return { positions: Float32Array.from(moved), triangles: Uint32Array.from(kept) };
}

/** Writes uint32 vertex count, uint32 triangle count, positions and triangles. */
export function writeMesh(path, { positions, triangles }) {
  const counts = Uint32Array.of(positions.length / 3, triangles.length / 3);
  writeFileSync(
    path,
    Buffer.concat([counts, positions, triangles].map((array) => Buffer.from(array.buffer))),
  );
}
