// Meshes for the measurements of the page, as files on the disk.

import { mkdtempSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

const scratch = mkdtempSync(join(tmpdir(), 'limber-bench-'));

/** A wavy torus of about `count` faces; `waves`: around it. `positions[3 v + c]`, `triangles[3 t + i]`. */
function torus(count, waves = 5) {
  const n = Math.round(Math.sqrt(count) / 2);
  const m = Math.round(count / (2 * n));
  const positions = new Float32Array(3 * m * n);
  const triangles = new Uint32Array(6 * m * n);
  const vertex = (i, j) => (i % m) * n + (j % n);
  for (let i = 0; i < m; i++)
    for (let j = 0; j < n; j++) {
      const [u, v] = [(2 * Math.PI * i) / m, (2 * Math.PI * j) / n];
      const r = 0.4 + 0.05 * Math.sin(waves * u + 2 * v);
      const around = 1 + r * Math.cos(v);
      positions.set([around * Math.cos(u), r * Math.sin(v), around * Math.sin(u)], 3 * vertex(i, j));
      const [a, b, c, d] = [vertex(i, j), vertex(i, j + 1), vertex(i + 1, j), vertex(i + 1, j + 1)];
      triangles.set([a, b, c, c, b, d], 6 * vertex(i, j));
    }
  return { positions, triangles };
}

/** A wavy torus of about `count` faces as binary PLY; returns its path. */
export function writeTorus(count) {
  const { positions, triangles } = torus(count);
  const [vertices, faces] = [positions.length / 3, triangles.length / 3];
  const header = [
    'ply',
    'format binary_little_endian 1.0',
    `element vertex ${vertices}`,
    ...['x', 'y', 'z'].map((axis) => `property float ${axis}`),
    `element face ${faces}`,
    'property list uchar int vertex_indices',
    'end_header\n',
  ].join('\n');
  const bytes = Buffer.alloc(header.length + 4 * positions.length + 13 * faces);
  let at = bytes.write(header, 'latin1');
  for (const value of positions) at = bytes.writeFloatLE(value, at);
  for (let t = 0; t < faces; t++) {
    at = bytes.writeUInt8(3, at);
    for (let i = 0; i < 3; i++) at = bytes.writeInt32LE(triangles[3 * t + i], at);
  }
  const path = join(scratch, `torus-${count}.ply`);
  writeFileSync(path, bytes);
  return path;
}

/** A scene of `count` tori of 1,000 to 3,000 faces in rows, no two alike, as GLB; returns its path. */
export function writeScene(count) {
  const bodies = Array.from({ length: count }, (_, i) =>
    torus(1000 + Math.round((2000 * ((7 * i) % count)) / count), 3 + i),
  );
  const parts = bodies.flatMap(({ positions, triangles }) => [positions, triangles]);
  let end = 0;
  const bufferViews = parts.map(({ byteLength }) => ({
    buffer: 0,
    byteOffset: (end += byteLength) - byteLength,
    byteLength,
  }));
  const accessors = bodies.flatMap(({ positions, triangles }, i) => [
    {
      ...{ bufferView: 2 * i, componentType: 5126, type: 'VEC3', count: positions.length / 3 },
      ...{ min: extreme(positions, Math.min), max: extreme(positions, Math.max) },
    },
    { bufferView: 2 * i + 1, componentType: 5125, type: 'SCALAR', count: triangles.length },
  ]);
  const columns = Math.ceil(Math.sqrt(count));
  const json = {
    asset: { version: '2.0' },
    scene: 0,
    scenes: [{ nodes: bodies.map((_, i) => i) }],
    nodes: bodies.map((_, i) => ({
      ...{ name: `body ${i + 1}`, mesh: i },
      translation: [4 * (i % columns), 0, 4 * Math.floor(i / columns)],
    })),
    meshes: bodies.map((_, i) => ({
      primitives: [{ attributes: { POSITION: 2 * i }, indices: 2 * i + 1 }],
    })),
    ...{ accessors, bufferViews, buffers: [{ byteLength: end }] },
  };
  const path = join(scratch, `scene-${count}.glb`);
  writeFileSync(path, glb(json, parts));
  return path;
}

/** The least or the greatest value of each coordinate. */
const extreme = (positions, choose) =>
  [0, 1, 2].map((c) =>
    positions.reduce((most, value, i) => (i % 3 === c ? choose(most, value) : most), positions[c]),
  );

/** A binary glTF of a document and the parts of its one buffer. */
function glb(json, parts) {
  const text = Buffer.from(JSON.stringify(json));
  const padded = Buffer.concat([text, Buffer.alloc((4 - (text.length % 4)) % 4, ' ')]);
  const data = Buffer.concat(parts.map(({ buffer }) => Buffer.from(buffer)));
  const chunk = (type, bytes) => Buffer.concat([words(bytes.length, type), bytes]);
  const chunks = Buffer.concat([chunk(0x4e4f534a, padded), chunk(0x004e4942, data)]);
  return Buffer.concat([words(0x46546c67, 2, 12 + chunks.length), chunks]);
}

const words = (...values) => Buffer.from(Uint32Array.from(values).buffer);

/** Where a measurement may write. */
export const scratchPath = (name) => join(scratch, name);
