import { KHRMeshQuantization } from '@gltf-transform/extensions';
import type { Accessor, Document, Primitive } from '@gltf-transform/core';
import { beforeAll, describe, expect, it } from 'vitest';
import type { Core, MeshAt, TriangleMesh } from '../../web/engine/core/core';
import { attributesOf } from '../../web/engine/body/attributes';
import { costAttributesOf } from '../../web/engine/body/cost_attributes';
import { exportGlb } from '../../web/engine/document/export';
import { openModel } from '../../web/engine/document/open';
import { validateGlb } from '../../web/engine/document/validate';
import { defaultSettings } from '../../web/engine/settings/options';
import type { Settings } from '../../web/engine/settings/options';
import { prepareBody } from '../../web/engine/stages/prepared';
import { exportedBody, exportedMesh } from '../../web/engine/stages/written';
import { loadTestCore } from './support/core';
import { addMesh, floats, glbFile, primitiveOf, readGlb, startDocument } from './support/gltf';
import { optimized, runOfModel } from './support/runs';
import { cube, grid, torus } from './support/shapes';

let core: Core;
beforeAll(async () => {
  core = await loadTestCore(1);
});

/** Opens the document, keeps `ratio` of its faces and returns the content of the exported file, which must be valid. */
async function reduced(source: Document, ratio: number, changes: Partial<Settings> = { method: 'qem' }) {
  const model = await openModel([await glbFile(source)]);
  // Faces are asked for that the guard would stop short of.
  const settings = { ...defaultSettings(), maxDeviation: 0, ...changes };
  const results: MeshAt[] = [];
  const bodies = model.bodies.map((body, i) => {
    const prepared = prepareBody(core, body, settings, model.document);
    if (ratio === 1) return exportedMesh(prepared);
    const targetFaces = Math.floor((ratio * prepared.mesh.triangles.length) / 3);
    const { result } = optimized(runOfModel(core, model, i), settings, targetFaces);
    results.push(result);
    return exportedBody(core, prepared, result, null);
  });
  const bytes = await exportGlb(model, bodies, { fields: false });
  expect((await validateGlb(bytes)).messages).toEqual([]);
  const document = await readGlb(bytes);
  return { model, document, results, primitives: document.getRoot().listMeshes()[0].listPrimitives() };
}

/** The attribute at every corner: values[triangle][corner]. */
function byCorner(
  primitive: Primitive,
  semantic: string,
  holder: Pick<Primitive, 'getAttribute'> = primitive,
) {
  const accessor = holder.getAttribute(semantic)!;
  const corners = [...primitive.getIndices()!.getArray()!].map((vertex) => accessor.getElement(vertex, []));
  return Array.from({ length: corners.length / 3 }, (_, t) => corners.slice(3 * t, 3 * t + 3));
}

function integers(
  document: Document,
  type: 'SCALAR' | 'VEC3' | 'VEC4',
  array: Uint8Array | Int8Array | Uint16Array,
) {
  const buffer = document.getRoot().listBuffers()[0];
  return document
    .createAccessor('', buffer)
    .setType(type)
    .setArray(array as Uint8Array<ArrayBuffer>);
}

/** Values per vertex, as a function of its position. */
function field(
  { positions }: TriangleMesh,
  valuesAt: (x: number, y: number, z: number) => number[],
): number[] {
  return Array.from({ length: positions.length / 3 }, (_, v) =>
    valuesAt(positions[3 * v], positions[3 * v + 1], positions[3 * v + 2]),
  ).flat();
}

/** A grid cut at x = 0.5 into two halves that share positions there but no vertices. */
function cutGrid(cells: number): TriangleMesh {
  const whole = grid(cells, cells);
  const count = whole.positions.length / 3;
  const isRight = (t: number) =>
    [0, 1, 2].some((k) => whole.positions[3 * whole.triangles[3 * t + k]] > 0.5 + 1e-6);
  const triangles = whole.triangles.map((v, corner) => (isRight(Math.floor(corner / 3)) ? v + count : v));
  return { positions: Float32Array.from([...whole.positions, ...whole.positions]), triangles };
}

/** A wavy grid whose cells each have a unit of the texture: cell k has U from 2 k to 2 k + 1, V from 0 to 1. */
function patchwork(source: Document, cells: number): Primitive {
  const whole = grid(cells, cells);
  const corners = [...whole.triangles];
  const cellOf = (corner: number) => Math.floor(corner / 6);
  const placeIn = (corner: number) => {
    const [x, y] = whole.positions.subarray(3 * corners[corner], 3 * corners[corner] + 2);
    const origin = [0, 1].map((axis) => {
      const first = 6 * cellOf(corner);
      return Math.min(...corners.slice(first, first + 6).map((v) => whole.positions[3 * v + axis]));
    });
    return [2 * cellOf(corner) + cells * (x - origin[0]), cells * (y - origin[1])];
  };
  const positions = Float32Array.from(
    corners.flatMap((v) => {
      const [x, y] = whole.positions.subarray(3 * v, 3 * v + 2);
      return [x, y, 0.1 * Math.sin(5 * x) * Math.cos(4 * y)];
    }),
  );
  const mesh = { positions, triangles: Uint32Array.from(corners, (_, corner) => corner) };
  const uv = corners.flatMap((_, corner) => placeIn(corner));
  return primitiveOf(source, mesh).setAttribute('TEXCOORD_0', floats(source, 'VEC2', uv));
}

const sumOf = (values: Iterable<number>) => [...values].reduce((sum, value) => sum + value, 0);

describe('attributes of an exported body', () => {
  it('are exactly those of the file if nothing was reduced', async () => {
    const source = startDocument();
    const mesh = torus();
    const count = mesh.positions.length / 3;
    let seed = 1;
    const random = () => (seed = (seed * 16807) % 2147483647) / 2147483647;
    const randoms = (size: number) => Array.from({ length: size * count }, random);
    const primitive = primitiveOf(source, mesh)
      .setAttribute('TEXCOORD_0', floats(source, 'VEC2', randoms(2)))
      .setAttribute('TEXCOORD_1', floats(source, 'VEC2', randoms(2)))
      .setAttribute(
        'COLOR_0',
        integers(
          source,
          'VEC4',
          Uint8Array.from(randoms(4), (x) => 255 * x),
        ).setNormalized(true),
      )
      .setAttribute('_MASK', floats(source, 'SCALAR', randoms(1)))
      .addTarget(
        source.createPrimitiveTarget('grow').setAttribute('POSITION', floats(source, 'VEC3', randoms(3))),
      );
    addMesh(source, 'torus', [primitive]);
    const { primitives } = await reduced(source, 1);
    for (const semantic of ['POSITION', 'TEXCOORD_0', 'TEXCOORD_1', 'COLOR_0', '_MASK'])
      expect(byCorner(primitives[0], semantic)).toEqual(byCorner(primitive, semantic));
    const [target] = primitives[0].listTargets();
    expect(byCorner(primitives[0], 'POSITION', target)).toEqual(
      byCorner(primitive, 'POSITION', primitive.listTargets()[0]),
    );
    expect(primitives[0].getAttribute('COLOR_0')!.getComponentType()).toBe(5121);
    expect(primitives[0].getAttribute('POSITION')!.getCount()).toBe(count);
  });

  it('that are linear on a flat sheet keep their value at every point', async () => {
    const source = startDocument();
    const mesh = grid(12, 12);
    const primitive = primitiveOf(source, mesh)
      .setAttribute(
        'TEXCOORD_0',
        floats(
          source,
          'VEC2',
          field(mesh, (x, y) => [x, 1 - y]),
        ),
      )
      .setAttribute(
        'COLOR_0',
        floats(
          source,
          'VEC3',
          field(mesh, (x, y) => [x, y, 0.5]),
        ),
      )
      .setAttribute(
        '_HEIGHT',
        floats(
          source,
          'SCALAR',
          field(mesh, (x, y) => [3 * x - y + 0.25]),
        ),
      )
      .addTarget(
        source.createPrimitiveTarget('bend').setAttribute(
          'POSITION',
          floats(
            source,
            'VEC3',
            field(mesh, (x, y) => [y, 2, x]),
          ),
        ),
      );
    addMesh(source, 'sheet', [primitive])
      .setWeights([0.25])
      .setExtras({ targetNames: ['bend'] });
    const { document, primitives } = await reduced(source, 0.2);
    const positions = byCorner(primitives[0], 'POSITION').flat();
    const expectLinear = (values: number[][], valuesAt: (x: number, y: number) => number[]) =>
      values.forEach((found, corner) => {
        const [x, y] = positions[corner];
        valuesAt(x, y).forEach((value, c) => expect(found[c]).toBeCloseTo(value, 5));
      });
    expectLinear(byCorner(primitives[0], 'TEXCOORD_0').flat(), (x, y) => [x, 1 - y]);
    expectLinear(byCorner(primitives[0], 'COLOR_0').flat(), (x, y) => [x, y, 0.5]);
    expectLinear(byCorner(primitives[0], '_HEIGHT').flat(), (x, y) => [3 * x - y + 0.25]);
    const [target] = primitives[0].listTargets();
    expectLinear(byCorner(primitives[0], 'POSITION', target).flat(), (x, y) => [y, 2, x]);
    expect(document.getRoot().listMeshes()[0].getWeights()).toEqual([0.25]);
    expect(document.getRoot().listMeshes()[0].getExtras()).toEqual({ targetNames: ['bend'] });
  });

  it('do not bleed over a seam, and the surface stays closed there', async () => {
    const source = startDocument();
    const mesh = cutGrid(16);
    const half = mesh.positions.length / 6;
    const uv = field(mesh, (x, y) => [x, y]).map((value, i) =>
      i >= 2 * half && i % 2 === 0 ? value + 10 : value,
    );
    addMesh(source, 'sheet', [
      primitiveOf(source, mesh).setAttribute('TEXCOORD_0', floats(source, 'VEC2', uv)),
    ]);
    const { primitives, results } = await reduced(source, 0.15);
    expect(core.inspect(results[0].mesh)).toMatchObject({ boundaryLoops: 1, components: 1 });
    for (const corners of byCorner(primitives[0], 'TEXCOORD_0')) {
      const isRight = corners[0][0] > 5;
      for (const [u] of corners) {
        expect(u).toBeGreaterThanOrEqual(isRight ? 10.5 - 1e-5 : 0);
        expect(u).toBeLessThanOrEqual(isRight ? 11 : 0.5 + 1e-5);
      }
    }
  });

  it('preserve every cell with its own part of the texture, unless seams may be crossed', async () => {
    const faces = async (changes: Partial<Settings>) => {
      const source = startDocument();
      addMesh(source, 'quilt', [patchwork(source, 12)]);
      const { primitives, results } = await reduced(source, 0.25, changes);
      expect(core.inspect(results[0].mesh)).toMatchObject({ boundaryLoops: 1, components: 1 });
      return byCorner(primitives[0], 'TEXCOORD_0');
    };
    for (const method of ['limber', 'qem'] as const) {
      // The corners of the sheet are exceptions, because their cells have two borders.
      expect((await faces({ method })).length).toBeGreaterThanOrEqual(280);
      const crossed = await faces({ method, seams: 'cross' });
      expect(crossed.length).toBeLessThanOrEqual(72);
      // The texture of a triangle is that of its original cell, even if the triangle has grown beyond it.
      for (const corners of crossed) {
        const cell = Math.floor((corners[0][0] + 1e-3) / 2);
        for (const [u, v] of corners) {
          expect(u).toBeGreaterThanOrEqual(2 * cell - 1e-4);
          expect(u).toBeLessThanOrEqual(2 * cell + 1 + 1e-4);
          expect(v).toBeGreaterThanOrEqual(-1e-4);
          expect(v).toBeLessThanOrEqual(1 + 1e-4);
        }
      }
    }
  });

  it('keep the border between two materials free of cracks', async () => {
    const source = startDocument();
    const mesh = cutGrid(12);
    const isRight = (t: number) => mesh.triangles[3 * t] >= mesh.positions.length / 6;
    const halves = [false, true].map((right) => {
      const triangles = mesh.triangles.filter((_, corner) => isRight(Math.floor(corner / 3)) === right);
      return primitiveOf(source, { positions: mesh.positions, triangles }).setMaterial(
        source.createMaterial(right ? 'right' : 'left'),
      );
    });
    addMesh(source, 'sheet', halves);
    const { document } = await reduced(source, 0.2);
    const again = await openModel([await glbFile(document)]);
    const { inspection } = prepareBody(core, again.bodies[0], defaultSettings(), again.document);
    expect(again.bodies[0].spans).toHaveLength(2);
    expect(inspection).toMatchObject({ boundaryLoops: 1, components: 1, eulerCharacteristic: 1 });
  });

  it('of joints are the strongest of the corners, without repetition, with sum 1 in their component type', async () => {
    for (const type of ['float', 'byte'] as const) {
      const source = startDocument();
      const mesh = torus(16, 8);
      const count = mesh.positions.length / 3;
      const joints = Uint8Array.from({ length: 4 * count }, (_, i) => (i % 4) * 6 + (Math.floor(i / 4) % 6));
      const weights = Array.from({ length: 4 * count }, (_, i) => [100, 80, 50, 25][i % 4]);
      const weightAccessor =
        type === 'float'
          ? floats(
              source,
              'VEC4',
              weights.map((weight) => weight / 255),
            )
          : integers(source, 'VEC4', Uint8Array.from(weights)).setNormalized(true);
      const primitive = primitiveOf(source, mesh)
        .setAttribute('JOINTS_0', integers(source, 'VEC4', joints))
        .setAttribute('WEIGHTS_0', weightAccessor);
      addMesh(source, 'torus', [primitive]);
      const skin = source.createSkin('skin');
      const rig = source.createNode('rig');
      source.getRoot().getDefaultScene()!.addChild(rig);
      for (let joint = 0; joint < 24; ++joint) {
        const node = source.createNode(`joint ${joint}`);
        rig.addChild(node);
        skin.addJoint(node);
      }
      const matrix = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
      skin.setInverseBindMatrices(floats(source, 'MAT4', Array.from({ length: 24 }, () => matrix).flat()));
      source.getRoot().listNodes()[0].setSkin(skin);
      const { document, primitives } = await reduced(source, 0.3);
      expect(document.getRoot().listNodes()[0].getSkin()!.listJoints()).toHaveLength(24);
      const [found, shares] = ['JOINTS_0', 'WEIGHTS_0'].map((name) => primitives[0].getAttribute(name)!);
      let mixed = 0;
      for (let v = 0; v < found.getCount(); ++v) {
        const share = shares.getElement(v, []);
        expect(sumOf(share)).toBeCloseTo(1, 6);
        expect(new Set(found.getElement(v, []).filter((_, i) => share[i] > 0)).size).toBe(
          share.filter((weight) => weight > 0).length,
        );
        mixed += Math.abs(share[0] - 100 / 255) > 0.01 ? 1 : 0;
      }
      expect(mixed).toBeGreaterThan(5);
      if (type === 'byte')
        for (let v = 0; v < found.getCount(); ++v)
          expect(sumOf(shares.getArray()!.subarray(4 * v, 4 * v + 4))).toBe(255);
    }
  });

  it('of joints in sets of different types keep their joints and shares', async () => {
    const source = startDocument();
    const mesh = grid(8, 8);
    const everywhere = (values: number[]) => field(mesh, () => values);
    const bytes = Uint8Array.from(everywhere([153, 51, 0, 0]));
    const primitive = primitiveOf(source, mesh)
      .setAttribute('JOINTS_0', integers(source, 'VEC4', Uint8Array.from(everywhere([1, 2, 0, 0]))))
      .setAttribute('WEIGHTS_0', floats(source, 'VEC4', everywhere([0.1, 0.1, 0, 0])))
      .setAttribute('JOINTS_1', integers(source, 'VEC4', Uint16Array.from(everywhere([300, 301, 0, 0]))))
      .setAttribute('WEIGHTS_1', integers(source, 'VEC4', bytes).setNormalized(true));
    addMesh(source, 'sheet', [primitive]);
    const rig = source.createNode('rig');
    source.getRoot().getDefaultScene()!.addChild(rig);
    const skin = source.createSkin('skin');
    for (let joint = 0; joint < 302; ++joint) {
      const node = source.createNode();
      rig.addChild(node);
      skin.addJoint(node);
    }
    source.getRoot().listNodes()[0].setSkin(skin);
    for (const ratio of [0.3, 1]) {
      const { primitives } = await reduced(source, ratio);
      const valueOf = (name: string, v: number) => primitives[0].getAttribute(name)!.getElement(v, []);
      for (let v = 0; v < primitives[0].getAttribute('JOINTS_0')!.getCount(); ++v) {
        const shareOf = new Map<number, number>();
        for (const set of [0, 1])
          valueOf(`JOINTS_${set}`, v).forEach((joint, i) => {
            const share = valueOf(`WEIGHTS_${set}`, v)[i];
            if (share > 0) shareOf.set(joint, share);
          });
        expect([...shareOf.keys()].sort((a, b) => a - b)).toEqual([1, 2, 300, 301]);
        expect(shareOf.get(300)).toBeCloseTo(0.6, 5);
        expect(shareOf.get(2)).toBeCloseTo(0.1, 5);
      }
    }
  });

  it('that are directions stay unit vectors in their component type, and tangents keep a handedness of 1 or -1', async () => {
    const source = startDocument();
    const mesh = torus(16, 8);
    const normals = field(mesh, (x, y, z) => {
      const ring = Math.hypot(x, y);
      const direction = [x * (1 - 1 / ring), y * (1 - 1 / ring), z];
      const length = Math.hypot(...direction);
      return direction.map((value) => value / length);
    });
    const tangents = field(mesh, (x, y) => [-y / Math.hypot(x, y), x / Math.hypot(x, y), 0, x > 0 ? 1 : -1]);
    const bytes = integers(
      source,
      'VEC3',
      Int8Array.from(normals, (value) => Math.round(127 * value)),
    );
    source.createExtension(KHRMeshQuantization).setRequired(true);
    const primitive = primitiveOf(source, mesh)
      .setAttribute('NORMAL', bytes.setNormalized(true))
      .setAttribute('TANGENT', floats(source, 'VEC4', tangents));
    addMesh(source, 'torus', [primitive]);
    const { primitives } = await reduced(source, 0.3);
    const normal = primitives[0].getAttribute('NORMAL')!;
    const tangent = primitives[0].getAttribute('TANGENT')!;
    expect(normal.getComponentType()).toBe(5120);
    for (let v = 0; v < normal.getCount(); ++v) {
      expect(Math.hypot(...normal.getElement(v, []))).toBeCloseTo(1, 1);
      expect(Math.hypot(...tangent.getElement(v, []).slice(0, 3))).toBeCloseTo(1, 5);
      expect(Math.abs(tangent.getElement(v, [])[3])).toBe(1);
    }
  });

  it('that are identifiers are never interpolated', async () => {
    const source = startDocument();
    const mesh = torus(16, 8);
    const ids = field(mesh, (x) => [x > 0 ? 7 : 1000]);
    const primitive = primitiveOf(source, mesh)
      .setAttribute('_FEATURE_ID_0', integers(source, 'SCALAR', Uint16Array.from(ids)))
      .setAttribute('_PART', floats(source, 'SCALAR', ids));
    addMesh(source, 'torus', [primitive]);
    const { primitives } = await reduced(source, 0.3);
    for (const name of ['_FEATURE_ID_0', '_PART'])
      expect(new Set(primitives[0].getAttribute(name)!.getArray())).toEqual(new Set([7, 1000]));
  });

  it('of a faceted body keep its facets: every changed face has its own normal', async () => {
    const source = startDocument();
    const smooth = torus(12, 8);
    const positions = Float32Array.from(
      [...smooth.triangles].flatMap((v) => [...smooth.positions.slice(3 * v, 3 * v + 3)]),
    );
    const mesh = { positions, triangles: smooth.triangles.map((_, corner) => corner) };
    addMesh(source, 'facets', [primitiveOf(source, mesh).setAttribute('NORMAL', flatNormals(source, mesh))]);
    const { primitives, results } = await reduced(source, 0.4);
    expect(results[0].mesh.triangles.length).toBeLessThan(0.45 * mesh.triangles.length);
    const normals = byCorner(primitives[0], 'NORMAL');
    byCorner(primitives[0], 'POSITION').forEach((corners, t) => {
      const expected = normalOf(corners);
      for (const normal of normals[t])
        normal.forEach((value, axis) => expect(value).toBeCloseTo(expected[axis], 4));
    });
  });
});

describe('the wedges of a body', () => {
  it('are one per distinct set of attributes at a vertex', async () => {
    const source = startDocument();
    const mesh = cutGrid(4);
    const count = mesh.positions.length / 6;
    const plain = field(mesh, (x, y) => [x, y]);
    const seam = plain.map((value, i) => (i >= 2 * count ? value + 1 : value));
    const wedgeCounts: number[] = [];
    for (const uv of [plain, seam]) {
      const primitive = primitiveOf(source, mesh).setAttribute('TEXCOORD_0', floats(source, 'VEC2', uv));
      addMesh(source, 'sheet', [primitive]);
    }
    const model = await openModel([await glbFile(source)]);
    for (const body of model.bodies) {
      const prepared = prepareBody(core, body, defaultSettings(), model.document);
      const { weld, diagonal, attributes } = prepared;
      expect(attributesOf(model.document, body, weld)).toEqual(attributes);
      wedgeCounts.push(attributes.wedgeCount);
      const cost = costAttributesOf(model.document, prepared)!;
      expect(cost.dimension).toBe(2);
      // A unit square of UV covers a unit square of surface, so one unit of UV is one unit of length.
      expect(Math.max(...cost.values)).toBeCloseTo(
        Math.max(...(body === model.bodies[0] ? plain : seam)) / diagonal,
        5,
      );
    }
    expect(wedgeCounts).toEqual([25, 30]);
  });

  it('are absent if there are only positions', async () => {
    const source = startDocument();
    addMesh(source, 'cube', [primitiveOf(source, cube())]);
    const model = await openModel([await glbFile(source)]);
    const { attributes } = prepareBody(core, model.bodies[0], defaultSettings(), model.document);
    expect(attributes).toEqual({
      charts: { wedges: new Uint32Array(), groups: new Uint32Array() },
      wedgeCount: 0,
      hardCosine: null,
      isBare: true,
    });
  });
});

function flatNormals(document: Document, { positions, triangles }: TriangleMesh): Accessor {
  const corner = (i: number) => [...positions.slice(3 * triangles[i], 3 * triangles[i] + 3)];
  const values = Array.from({ length: triangles.length / 3 }, (_, t) => {
    const normal = normalOf([corner(3 * t), corner(3 * t + 1), corner(3 * t + 2)]);
    return [...normal, ...normal, ...normal];
  });
  return floats(document, 'VEC3', values.flat());
}

function normalOf([a, b, c]: number[][]): number[] {
  const [u, w] = [b, c].map((point) => point.map((value, axis) => value - a[axis]));
  const normal = [0, 1, 2].map((i) => u[(i + 1) % 3] * w[(i + 2) % 3] - u[(i + 2) % 3] * w[(i + 1) % 3]);
  const length = Math.hypot(...normal);
  return normal.map((value) => value / length);
}
