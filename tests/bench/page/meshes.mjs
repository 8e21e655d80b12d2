// Meshes for the measurements of the page, as files on the disk.

import { mkdtempSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

const scratch = mkdtempSync(join(tmpdir(), 'limber-bench-'));

/** A wavy torus of about `count` faces as binary PLY; returns its path. */
export function writeTorus(count) {
  const n = Math.round(Math.sqrt(count) / 2);
  const m = Math.round(count / (2 * n));
  const header = [
    'ply',
    'format binary_little_endian 1.0',
    `element vertex ${m * n}`,
    ...['x', 'y', 'z'].map((axis) => `property float ${axis}`),
    `element face ${2 * m * n}`,
    'property list uchar int vertex_indices',
    'end_header\n',
  ].join('\n');
  const bytes = Buffer.alloc(header.length + 12 * m * n + 2 * 13 * m * n);
  let at = bytes.write(header, 'latin1');
  const float = (value) => (at = bytes.writeFloatLE(value, at));
  for (let i = 0; i < m; i++)
    for (let j = 0; j < n; j++) {
      const [u, v] = [(2 * Math.PI * i) / m, (2 * Math.PI * j) / n];
      const r = 0.4 + 0.05 * Math.sin(5 * u + 2 * v);
      float((1 + r * Math.cos(v)) * Math.cos(u));
      float(r * Math.sin(v));
      float((1 + r * Math.cos(v)) * Math.sin(u));
    }
  const vertex = (i, j) => (i % m) * n + (j % n);
  const face = (...corners) => {
    at = bytes.writeUInt8(3, at);
    for (const corner of corners) at = bytes.writeInt32LE(corner, at);
  };
  for (let i = 0; i < m; i++)
    for (let j = 0; j < n; j++) {
      face(vertex(i, j), vertex(i, j + 1), vertex(i + 1, j));
      face(vertex(i + 1, j), vertex(i, j + 1), vertex(i + 1, j + 1));
    }
  const path = join(scratch, `torus-${count}.ply`);
  writeFileSync(path, bytes);
  return path;
}

/** Where a measurement may write. */
export const scratchPath = (name) => join(scratch, name);
