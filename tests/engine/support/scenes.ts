/** Small scenes of several bodies, as studios have them: furniture with glass, leaves with two sides, crates, rooms, many parts. */

import type { Document } from '@gltf-transform/core';
import type { TriangleMesh } from '../../../web/engine/core/core';
import { addMesh, floats, primitiveOf, startDocument } from './gltf';
import { box, grid } from './shapes';

/** The mesh with each vertex where `to` puts it. */
export function moved(mesh: TriangleMesh, to: (x: number, y: number, z: number) => number[]): TriangleMesh {
  const positions = new Float32Array(mesh.positions.length);
  for (let v = 0; v < positions.length; v += 3)
    positions.set(to(mesh.positions[v], mesh.positions[v + 1], mesh.positions[v + 2]), v);
  return { positions, triangles: mesh.triangles };
}

/** All meshes as one. */
export function joined(meshes: TriangleMesh[]): TriangleMesh {
  const positions: number[] = [];
  const triangles: number[] = [];
  for (const mesh of meshes) {
    const first = positions.length / 3;
    for (const value of mesh.positions) positions.push(value);
    for (const vertex of mesh.triangles) triangles.push(first + vertex);
  }
  return { positions: Float32Array.from(positions), triangles: Uint32Array.from(triangles) };
}

/** The mesh with every face seen from the other side. */
export const turned = ({ positions, triangles }: TriangleMesh): TriangleMesh => ({
  positions,
  triangles: triangles.map((_, i) => triangles[i % 3 === 0 ? i : i % 3 === 1 ? i + 1 : i - 1]),
});

/** A solid of revolution around y with closed ends: radii[k] at heights[k], `around` vertices in each ring. */
export function turnedSolid(radii: number[], heights: number[], around: number): TriangleMesh {
  const positions: number[] = [];
  const triangles: number[] = [];
  radii.forEach((radius, k) => {
    for (let i = 0; i < around; ++i) {
      const angle = (2 * Math.PI * i) / around;
      positions.push(radius * Math.cos(angle), heights[k], radius * Math.sin(angle));
    }
  });
  const at = (k: number, i: number) => k * around + (i % around);
  for (let k = 0; k + 1 < radii.length; ++k)
    for (let i = 0; i < around; ++i)
      triangles.push(at(k, i), at(k + 1, i), at(k + 1, i + 1), at(k, i), at(k + 1, i + 1), at(k, i + 1));
  const last = radii.length - 1;
  const [bottom, top] = [positions.length / 3, positions.length / 3 + 1];
  positions.push(0, heights[0], 0, 0, heights[last], 0);
  for (let i = 0; i < around; ++i)
    triangles.push(bottom, at(0, i), at(0, i + 1), top, at(last, i + 1), at(last, i));
  return { positions: Float32Array.from(positions), triangles: Uint32Array.from(triangles) };
}

/** A turned table leg of 2 * around * rings faces, 0.7 high. */
export const leg = (around = 10, rings = 8): TriangleMesh => {
  const heights = Array.from({ length: rings }, (_, k) => (0.7 * k) / (rings - 1));
  return turnedSolid(
    heights.map((y) => 0.03 + 0.012 * Math.cos(25 * y)),
    heights,
    around,
  );
};

/** A leaf over [0, 1] along x that bends down. */
export const leaf = (along = 20, across = 4): TriangleMesh =>
  moved(grid(along, across), (x, y) => {
    const width = 0.02 + 0.3 * Math.sin(Math.PI * Math.min(1, 0.08 + 0.92 * x)) * 0.5;
    return [x, -0.5 * x * x - 0.1 * (y - 0.5) ** 2, (y - 0.5) * width];
  });

const place = (document: Document, mesh: number, at: number[], scale = 1): void => {
  const root = document.getRoot();
  const node = document.createNode(`place ${mesh}`).setMesh(root.listMeshes()[mesh]);
  root
    .getDefaultScene()!
    .addChild(node.setTranslation(at as [number, number, number]).setScale([scale, scale, scale]));
};

function removeNodes(document: Document): void {
  for (const node of document.getRoot().listNodes()) node.dispose();
}

/** A glass top of two triangles, a frame of one box, and four turned legs that share one mesh. */
export function tableScene(): Document {
  const document = startDocument();
  const top = moved(grid(1, 1), (x, y) => [2 * x - 1, 0.75, 0.6 - 1.2 * y]);
  const frame = moved(box(1, 1, 1), (x, y, z) => [1.9 * x - 0.95, 0.7 + 0.04 * y, 1.1 * z - 0.55]);
  const glass = document.createMaterial('glass').setAlphaMode('BLEND').setBaseColorFactor([1, 1, 1, 0.3]);
  addMesh(document, 'top', [primitiveOf(document, top).setMaterial(glass)]);
  addMesh(document, 'frame', [primitiveOf(document, frame)]);
  addMesh(document, 'leg', [primitiveOf(document, leg())]);
  removeNodes(document);
  place(document, 0, [0, 0, 0]);
  place(document, 1, [0, 0, 0]);
  for (const [x, z] of [
    [-0.9, -0.5],
    [0.9, -0.5],
    [-0.9, 0.5],
    [0.9, 0.5],
  ])
    place(document, 2, [x, 0, z]);
  return document;
}

/** The table as a single mesh of one primitive: glass top of two triangles, frame and legs. */
export function tableBody(around = 10, rings = 8): TriangleMesh {
  const top = moved(grid(1, 1), (x, y) => [2 * x - 1, 0.75, 0.6 - 1.2 * y]);
  const frame = moved(box(1, 1, 1), (x, y, z) => [1.9 * x - 0.95, 0.7 + 0.04 * y, 1.1 * z - 0.55]);
  const legs = [-0.9, 0.9].flatMap((x) =>
    [-0.5, 0.5].map((z) => moved(leg(around, rings), (a, b, c) => [a + x, b, c + z])),
  );
  return joined([top, frame, ...legs]);
}

/** A trunk, and nine leaves whose back sides are faces of their own, in a material of their own. */
export function palmScene(along = 20, across = 4): Document {
  const document = startDocument();
  const trunk = turnedSolid(
    Array.from({ length: 9 }, (_, k) => 0.12 - 0.008 * k),
    Array.from({ length: 9 }, (_, k) => 0.25 * k),
    12,
  );
  const leaves = joined(
    Array.from({ length: 9 }, (_, i) => {
      const angle = (2 * Math.PI * i) / 9;
      const [c, s] = [Math.cos(angle), Math.sin(angle)];
      return moved(leaf(along, across), (x, y, z) => [c * x - s * z, y + 2.02, s * x + c * z]);
    }),
  );
  const front = primitiveOf(document, leaves).setMaterial(document.createMaterial('front'));
  const back = primitiveOf(document, turned(leaves)).setMaterial(document.createMaterial('back'));
  addMesh(document, 'trunk', [primitiveOf(document, trunk)]);
  addMesh(document, 'leaves', [front, back]);
  return document;
}

/** A leaf of which every face has a back side in another material. */
export function twoSidedLeaf(along = 20, across = 20): Document {
  const document = startDocument();
  const mesh = leaf(along, across);
  const uv = (offset: number) => {
    const values: number[] = [];
    for (let v = 0; v < mesh.positions.length; v += 3)
      values.push(offset + mesh.positions[v], mesh.positions[v + 2] + 0.5);
    return floats(document, 'VEC2', values);
  };
  const front = primitiveOf(document, mesh).setAttribute('TEXCOORD_0', uv(0));
  const back = primitiveOf(document, turned(mesh)).setAttribute('TEXCOORD_0', uv(5));
  addMesh(document, 'leaf', [
    front.setMaterial(document.createMaterial('front')),
    back.setMaterial(document.createMaterial('back')),
  ]);
  return document;
}

/** A ground of two triangles, crates of 12, and a finely cut ball; crates are instances of one mesh, of several sizes. */
export function boxScene(): Document {
  const document = startDocument();
  addMesh(document, 'ground', [
    primitiveOf(
      document,
      moved(grid(1, 1), (x, y) => [10 * x - 5, 0, 5 - 10 * y]),
    ),
  ]);
  addMesh(document, 'crate', [
    primitiveOf(
      document,
      moved(box(1, 1, 1), (x, y, z) => [x - 0.5, y, z - 0.5]),
    ),
  ]);
  addMesh(document, 'ball', [primitiveOf(document, ball(24))]);
  removeNodes(document);
  place(document, 0, [0, 0, 0]);
  for (let i = 0; i < 5; ++i) place(document, 1, [2 * i - 4, 0, i % 2], 0.5 + 0.2 * i);
  place(document, 2, [0, 1, -3], 1);
  return document;
}

/** A ball of radius 1 and 2 * rings * (rings - 1) * 2 faces. */
export const ball = (rings = 24): TriangleMesh => {
  const angles = Array.from({ length: rings - 1 }, (_, k) => (Math.PI * (k + 1)) / rings);
  return turnedSolid(
    angles.map((angle) => Math.sin(angle)),
    angles.map((angle) => -Math.cos(angle)),
    2 * rings,
  );
};

/** A house of walls of two triangles, a floor that is cut finely though it is flat, doors of 12 and a vase. */
export function roomScene(): Document {
  const document = startDocument();
  const wall = (at: (u: number, v: number) => number[]) => moved(grid(1, 1), (x, y) => at(x, y));
  const walls = joined([
    wall((u, v) => [4 * u, 2.5 * v, 0]),
    wall((u, v) => [4 - 4 * u, 2.5 * v, 6]),
    wall((u, v) => [0, 2.5 * v, 6 - 6 * u]),
    wall((u, v) => [4, 2.5 * v, 6 * u]),
    wall((u, v) => [4 * u, 2.5 * v, 3]),
  ]);
  addMesh(document, 'walls', [primitiveOf(document, walls)]);
  addMesh(document, 'floor', [
    primitiveOf(
      document,
      moved(grid(16, 24), (x, y) => [4 * x, 0, 6 - 6 * y]),
    ),
  ]);
  addMesh(document, 'door', [
    primitiveOf(
      document,
      moved(box(1, 1, 1), (x, y, z) => [1 + 0.9 * x, 2 * y, 2.97 + 0.06 * z]),
    ),
  ]);
  const heights = Array.from({ length: 14 }, (_, k) => (0.6 * k) / 13);
  const vase = turnedSolid(
    heights.map((y) => 0.12 + 0.05 * Math.sin(9 * y)),
    heights,
    20,
  );
  addMesh(document, 'vase', [
    primitiveOf(
      document,
      moved(vase, (x, y, z) => [x + 3, y, z + 1]),
    ),
  ]);
  return document;
}

/** `count` bodies of 132 faces each on a square; of every three one is a copy of another, up to where it stands. */
export function partsScene(count: number, areEqual = false): Document {
  const document = startDocument();
  const side = Math.ceil(Math.sqrt(count));
  for (let i = 0; i < count; ++i) {
    const kind = areEqual ? 0 : i % 3 === 2 ? i - 1 : i;
    const heights = Array.from({ length: 6 }, (_, k) => 0.2 * k);
    const radii = heights.map((y, k) => 0.2 + 0.05 * Math.sin(3 * y + kind) + 0.01 * ((kind * 7 + k) % 5));
    const solid = turnedSolid(radii, heights, 11);
    addMesh(document, `part ${i}`, [primitiveOf(document, solid)]);
    const nodes = document.getRoot().listNodes();
    nodes[nodes.length - 1].setTranslation([i % side, 0, Math.floor(i / side)]);
  }
  return document;
}

/** The parts of `partsScene` as one body of many components. */
export function partsBody(count: number): TriangleMesh {
  const side = Math.ceil(Math.sqrt(count));
  return joined(
    Array.from({ length: count }, (_, i) => {
      const heights = Array.from({ length: 6 }, (_unused, k) => 0.2 * k);
      const radii = heights.map((y, k) => 0.2 + 0.05 * Math.sin(3 * y + i) + 0.01 * ((i * 7 + k) % 5));
      return moved(turnedSolid(radii, heights, 11), (x, y, z) => [
        x + (i % side),
        y,
        z + Math.floor(i / side),
      ]);
    }),
  );
}
