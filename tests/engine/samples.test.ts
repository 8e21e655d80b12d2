import { NodeIO, type Primitive } from '@gltf-transform/core';
import { describe, expect, it } from 'vitest';
import { sampleGlb } from '../../scripts/samples/glb';
import { samples, type Sample } from '../../scripts/samples/samples';
import { cross, dot, length, pointAt, subtract, type Point, type Shape } from '../../scripts/samples/shape';
import { bestTriangulation, smallestAngle } from '../../scripts/samples/tower/cells';
import { validateGlb } from '../../web/engine/document/validate';

interface Expected {
  vertices: number;
  faces: [number, number];
  boundaryLoops: number;
  genus: number;
  smallestAngleDegrees: number;
}

/**
 * The tower's solid is 4 plinths and a spire (Euler characteristic 1 each), two platforms with an open middle (0),
 * tubes of walls with an opening less each (8 leg storeys of 2 bays with 2 x 4 + 2 openings, a shaft of 5 bays with
 * 4 x 4), and 4 arches (-1) with 4 hangers (-1) each; its skin has genus 1 - that sum.
 */
const towerGenus = 1 - (4 + 1 - 8 * 2 * (2 * 4 + 2) - 5 * 16 - 4 * (1 + 4));

const expected: Record<string, Expected> = {
  bar: { vertices: 898, faces: [1792, 1792], boundaryLoops: 0, genus: 0, smallestAngleDegrees: 44.9 },
  cloth: { vertices: 33 * 33, faces: [2048, 2048], boundaryLoops: 1, genus: 0, smallestAngleDegrees: 35 },
  tower: {
    vertices: 3988,
    faces: [6000, 9000],
    boundaryLoops: 0,
    genus: towerGenus,
    smallestAngleDegrees: 3,
  },
  // three limbs between foot and crown (2), the crown's own ring (1) and two bridges (2)
  organic: { vertices: NaN, faces: [6000, 10000], boundaryLoops: 0, genus: 5, smallestAngleDegrees: 30 },
};

const corners = ({ positions, triangles }: Shape, t: number): [Point, Point, Point] => {
  const at = (corner: number) => pointAt(positions, triangles[3 * t + corner]);
  return [at(0), at(1), at(2)];
};
const faceIndices = (shape: Shape) => Array.from({ length: shape.triangles.length / 3 }, (_, t) => t);

/** Maps directed edges "a,b" to their faces. */
function directedEdges({ triangles }: Shape): Map<string, number[]> {
  const edges = new Map<string, number[]>();
  triangles.forEach((a, corner) => {
    const b = triangles[corner % 3 === 2 ? corner - 2 : corner + 1];
    const key = `${a},${b}`;
    edges.set(key, [...(edges.get(key) ?? []), Math.floor(corner / 3)]);
  });
  return edges;
}

/** The number of connected components of a graph with `count` nodes and the edges `links`. */
function components(count: number, links: Iterable<readonly [number, number]>): number {
  const parent = Array.from({ length: count }, (_, i) => i);
  const root = (i: number): number => (parent[i] === i ? i : (parent[i] = root(parent[i])));
  for (const [a, b] of links) parent[root(a)] = root(b);
  return parent.filter((p, i) => p === i).length;
}

function topology(shape: Shape) {
  const edges = directedEdges(shape);
  const vertexCount = shape.positions.length / 3;
  const pairs = [...edges.keys()].map((edge) => edge.split(',').map(Number) as [number, number]);
  const boundary = pairs.filter(([a, b]) => !edges.has(`${b},${a}`));
  const undirected = (edges.size + boundary.length) / 2;
  const onBoundary = [...new Set(boundary.flat())];
  const boundaryLinks = boundary.map(
    ([a, b]) => [onBoundary.indexOf(a), onBoundary.indexOf(b)] as [number, number],
  );
  const boundaryLoops = components(onBoundary.length, boundaryLinks);
  const eulerCharacteristic = vertexCount - undirected + shape.triangles.length / 3;
  return {
    components: components(vertexCount, pairs),
    boundaryLoops,
    genus: (2 - boundaryLoops - eulerCharacteristic) / 2,
    mostFacesOnDirectedEdge: Math.max(...[...edges.values()].map((faces) => faces.length)),
  };
}

/** Vertices whose faces, joined across shared edges, do not form one fan. */
function splitFans(shape: Shape): number[] {
  const edges = directedEdges(shape);
  const around = Array.from({ length: shape.positions.length / 3 }, () => [] as number[]);
  shape.triangles.forEach((v, corner) => around[v].push(Math.floor(corner / 3)));
  return around.flatMap((faces, v) => {
    const links = [...new Set(faces.flatMap((t) => [...shape.triangles.slice(3 * t, 3 * t + 3)]))].flatMap(
      (w) => {
        const [here] = edges.get(`${v},${w}`) ?? [];
        const [there] = edges.get(`${w},${v}`) ?? [];
        const isInner = here !== undefined && there !== undefined;
        return isInner ? [[faces.indexOf(here), faces.indexOf(there)] as [number, number]] : [];
      },
    );
    return components(faces.length, links) === 1 ? [] : [v];
  });
}

function volume(shape: Shape): number {
  return faceIndices(shape).reduce((sum, t) => {
    const [a, b, c] = corners(shape, t);
    return sum + dot(a, cross(b, c)) / 6;
  }, 0);
}

async function primitiveOf(glb: Uint8Array): Promise<Primitive> {
  const document = await new NodeIO().readBinary(glb);
  return document.getRoot().listMeshes()[0].listPrimitives()[0];
}

const shapes = Object.fromEntries(samples.map((sample) => [sample.id, sample.make()]));

describe.each(samples.map((sample): [string, Sample] => [sample.id, sample]))('sample %s', (id, sample) => {
  const want = expected[id];
  const shape = shapes[id];
  const vertexCount = shape.positions.length / 3;

  it('has the promised numbers of faces and vertices', () => {
    const faces = shape.triangles.length / 3;
    expect(faces).toBeGreaterThanOrEqual(want.faces[0]);
    expect(faces).toBeLessThanOrEqual(want.faces[1]);
    if (want.vertices) expect(vertexCount).toBe(want.vertices);
    expect(new Set(shape.triangles).size).toBe(vertexCount);
  });

  it('is one consistently oriented manifold of the expected genus', () => {
    const { boundaryLoops, genus } = want;
    expect(topology(shape)).toEqual({ components: 1, boundaryLoops, genus, mostFacesOnDirectedEdge: 1 });
    expect(splitFans(shape)).toEqual([]);
  });

  it('has no face thinner than allowed', () => {
    const angles = faceIndices(shape).map((t) => smallestAngle(...corners(shape, t)));
    expect((Math.min(...angles) * 180) / Math.PI).toBeGreaterThan(want.smallestAngleDegrees);
  });

  it('stands centred on the ground, one to three metres tall', () => {
    const along = (axis: number) => shape.positions.filter((_, i) => i % 3 === axis);
    expect(Math.min(...along(1))).toBe(0);
    expect(Math.max(...along(1))).toBeGreaterThan(1);
    expect(Math.max(...along(1))).toBeLessThanOrEqual(3);
    for (const axis of [0, 2]) expect(Math.max(...along(axis)) + Math.min(...along(axis))).toBeCloseTo(0, 6);
  });

  it(want.boundaryLoops > 0 ? 'faces the front' : 'faces outwards', () => {
    const front = faceIndices(shape).reduce((sum, t) => {
      const [a, b, c] = corners(shape, t);
      return sum + cross(subtract(b, a), subtract(c, a))[2];
    }, 0);
    expect(want.boundaryLoops > 0 ? front : volume(shape)).toBeGreaterThan(0);
  });

  it('is bit-equal each time it is made', async () => {
    const again = await sampleGlb(sample, sample.make());
    expect(Buffer.compare(await sampleGlb(sample, shape), again)).toBe(0);
  }, 30_000);

  it('gives a GLB that the validator accepts without messages', async () => {
    expect(await validateGlb(await sampleGlb(sample, shape))).toEqual({
      errors: 0,
      warnings: 0,
      messages: [],
    });
  });

  it('welds back to its vertices bit for bit, and its normals agree with its faces', async () => {
    const primitive = await primitiveOf(await sampleGlb(sample, shape));
    const positions = primitive.getAttribute('POSITION')!.getArray()!;
    const normals = primitive.getAttribute('NORMAL')!.getArray()!;
    const indices = [...primitive.getIndices()!.getArray()!];
    const welded = indices.filter((v, corner) =>
      pointAt(positions, v).some((x, axis) => x !== shape.positions[3 * shape.triangles[corner] + axis]),
    );
    expect(welded).toEqual([]);
    const againstFace = indices.filter((v, corner) => {
      const [a, b, c] = corners(shape, Math.floor(corner / 3));
      return dot(pointAt(normals, v), cross(subtract(b, a), subtract(c, a))) <= 0;
    });
    expect(againstFace).toEqual([]);
    for (let v = 0; v < normals.length / 3; v++) expect(length(pointAt(normals, v))).toBeCloseTo(1, 5);
  });
});

describe('the bar', () => {
  const bar = samples.find(({ id }) => id === 'bar')!;

  it('is 1 x 3 x 1 m of right-angled triangles with legs of 1/8 m', () => {
    const shape = shapes.bar;
    expect(volume(shape)).toBeCloseTo(3, 6);
    const areas = faceIndices(shape).map((t) => {
      const [a, b, c] = corners(shape, t);
      return length(cross(subtract(b, a), subtract(c, a))) / 2;
    });
    expect(new Set(areas)).toEqual(new Set([1 / 128]));
  });

  it('has its normals split only at its 12 edges', async () => {
    const primitive = await primitiveOf(await sampleGlb(bar, shapes.bar));
    const sides = 2 * 9 * 9 + 4 * 9 * 25;
    expect(primitive.getAttribute('POSITION')!.getCount()).toBe(sides);
  });
});

describe('the cloth', () => {
  const at = (i: number, j: number) => pointAt(shapes.cloth.positions, i + 33 * j);

  it('hangs by its two top corners and sags between them', () => {
    const [left, right] = [at(0, 0), at(32, 0)];
    expect(left[1]).toBeCloseTo(right[1], 6);
    expect(length(subtract(left, right))).toBeCloseTo(1.15, 6);
    const heights = shapes.cloth.positions.filter((_, i) => i % 3 === 1);
    expect(heights.filter((y) => y >= Math.min(left[1], right[1])).length).toBe(2);
  });

  it('is nowhere stretched or shrunk by more than 3 %', () => {
    const ratios: number[] = [];
    for (let j = 0; j < 33; j++)
      for (let i = 0; i < 32; i++) {
        ratios.push(length(subtract(at(i + 1, j), at(i, j))) / 0.05);
        ratios.push(length(subtract(at(j, i + 1), at(j, i))) / 0.05);
      }
    expect(Math.max(...ratios)).toBeLessThan(1.03);
    expect(Math.min(...ratios)).toBeGreaterThan(0.97);
  });

  it('falls in folds: its middle rows oscillate in depth', () => {
    const depth = (i: number) => at(i, 8)[2];
    const turns = Array.from({ length: 31 }, (_, k) => k + 1).filter(
      (i) => (depth(i) - depth(i - 1)) * (depth(i + 1) - depth(i)) < 0,
    );
    expect(turns.length).toBeGreaterThanOrEqual(3);
  });
});

describe('the best triangulation of a convex polygon', () => {
  it('has no flat triangle for a long quad and for a quad with a corner on its side', () => {
    const polygon: Point[] = [
      [0, 0, 0],
      [1, 0, 0],
      [2, 0, 0],
      [2, 1, 0],
      [0, 1, 0],
    ];
    const triangles = bestTriangulation(polygon);
    expect(triangles.length).toBe(9);
    for (let t = 0; t < 9; t += 3) {
      const [a, b, c] = triangles.slice(t, t + 3).map((corner) => polygon[corner]);
      expect(smallestAngle(a, b, c)).toBeCloseTo(Math.PI / 4, 9);
    }
  });
});
