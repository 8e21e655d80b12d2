import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { describeTooLarge, MAX_CORNERS, triangulatePolygon } from '../../web/engine/document/polygon';
import { areaOf, triangleArea } from './support/shapes';
import { processorTime } from './support/processor_time';

/** Vertices in a plane that is not parallel to any axis. */
function tilted(points: number[][]): Float32Array {
  return Float32Array.from(points.flatMap(([x, y]) => [x, 0.6 * y + 0.3 * x, 0.8 * y - 0.2 * x]));
}

const corners = (points: unknown[]) => points.map((_, i) => i);

/** Expects every side of the polygon once and every diagonal twice, in opposite directions. */
function expectTiling(triangles: number[], count: number): void {
  const edges = new Map<string, number>();
  for (let t = 0; t < triangles.length; t += 3)
    for (let k = 0; k < 3; ++k) {
      const edge = `${triangles[t + k]}>${triangles[t + ((k + 1) % 3)]}`;
      edges.set(edge, (edges.get(edge) ?? 0) + 1);
    }
  for (const [edge, times] of edges) {
    expect(times).toBe(1);
    const [a, b] = edge.split('>').map(Number);
    expect((a + 1) % count === b).not.toBe(edges.has(`${b}>${a}`));
  }
  expect(edges.size - (count - 3)).toBe(count + (count - 3));
}

describe('a polygon', () => {
  it('that is convex becomes a fan around its first corner', () => {
    const pentagon = [0, 1, 2, 3, 4].map((i) => [Math.cos(i * 1.2566), Math.sin(i * 1.2566)]);
    expect(triangulatePolygon(corners(pentagon), tilted(pentagon))).toEqual([0, 1, 2, 0, 2, 3, 0, 3, 4]);
  });

  it('with one corner that sees all others becomes a fan around it', () => {
    const dart = [
      [0, 0],
      [2, 1],
      [0, 2],
      [0.5, 1],
    ];
    const triangles = triangulatePolygon(corners(dart), tilted(dart))!;
    expectTiling(triangles, 4);
    expect(triangles[0]).toBe(1);
  });

  it('with corners on straight sides keeps all of them and gets no flat triangle', () => {
    const square = [
      [0, 0],
      [1, 0],
      [2, 0],
      [2, 1],
      [2, 2],
      [1, 2],
      [0, 2],
      [0, 1],
    ];
    const positions = tilted(square);
    const triangles = triangulatePolygon(corners(square), positions)!;
    expectTiling(triangles, 8);
    for (let t = 0; t < triangles.length; t += 3)
      expect(triangleArea(positions, triangles.slice(t, t + 3))).toBeGreaterThan(0.1);
  });

  it('of any simple shape is tiled without gaps or overlaps', () => {
    const star = fc
      .tuple(
        fc.array(fc.double({ min: 0.1, max: 1, noNaN: true }), { minLength: 4, maxLength: 24 }),
        fc.boolean(),
      )
      .map(([radii, isTurned]) => {
        const points = radii.map((radius, i) => {
          const angle = (2 * Math.PI * i) / radii.length;
          return [radius * Math.cos(angle), radius * Math.sin(angle)];
        });
        return isTurned ? points.reverse() : points;
      });
    fc.assert(
      fc.property(star, (points) => {
        const positions = tilted(points);
        const triangles = triangulatePolygon(corners(points), positions)!;
        expectTiling(triangles, points.length);
        const fanArea = areaOf({
          positions: tilted([...points, [0, 0]]),
          triangles: Uint32Array.from(points.flatMap((_, i) => [i, (i + 1) % points.length, points.length])),
        });
        expect(areaOf({ positions, triangles: Uint32Array.from(triangles) })).toBeCloseTo(fanArea, 5);
      }),
      { numRuns: 500, seed: 3 },
    );
  });

  it('on a staircase keeps every corner', () => {
    const steps = [0, 1, 2, 3, 4].flatMap((i) => [
      [i, i],
      [i + 1, i],
    ]);
    const staircase = [...steps, [5, 5], [0, 5]];
    const triangles = triangulatePolygon(corners(staircase), tilted(staircase))!;
    expectTiling(triangles, staircase.length);
  });

  it('without area still becomes a fan, so that its faces can be counted', () => {
    const line = [
      [0, 0],
      [1, 0],
      [2, 0],
      [3, 0],
    ];
    expect(triangulatePolygon(corners(line), tilted(line))).toHaveLength(6);
  });

  const circle = (count: number, radius: (i: number) => number) =>
    Array.from({ length: count }, (_, i) => {
      const angle = (2 * Math.PI * i) / count;
      return [radius(i) * Math.cos(angle), radius(i) * Math.sin(angle)];
    });

  it('of 100,000 corners is cut at once where it is convex, and refused where it is not', () => {
    const round = circle(100_000, () => 1);
    const seconds = processorTime();
    expect(triangulatePolygon(corners(round), tilted(round))).toHaveLength(3 * 99_998);
    const star = circle(100_000, (i) => 1 + (i % 2));
    expect(triangulatePolygon(corners(star), tilted(star))).toBeNull();
    const twice = circle(100_000, () => 1).map(
      (_, i, points) => points[(2 * i + (i >= 50_000 ? 1 : 0)) % points.length],
    );
    expect(triangulatePolygon(corners(twice), tilted(twice))).toBeNull();
    expect(seconds()).toBeLessThan(3);
    expect(describeTooLarge(100_000)).toContain(MAX_CORNERS.toLocaleString('en-US'));
  });

  it('of the most corners that are cut whatever their shape is tiled', () => {
    const star = circle(MAX_CORNERS, (i) => 1 + (i % 2));
    expectTiling(triangulatePolygon(corners(star), tilted(star))!, MAX_CORNERS);
  });
});
