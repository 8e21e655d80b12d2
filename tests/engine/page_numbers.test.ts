/** What the page works out by itself: the remaining time, quick normals, the scale of curvature, points for the floor. */

import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { curvatureScale, ranked } from '../../web/app/panels/viewport/curvature_scale';
import { remainingTime, shareDone } from '../../web/app/state/remaining';
import { drawnArrays, quickArrays } from '../../web/app/viewer/drawn_arrays';
import { quickNormals } from '../../web/app/viewer/quick_normals';
import { spreadPoints, spreadStep } from '../../web/app/viewer/spread_points';
import { cube, grid, torus } from './support/shapes';

describe('the remaining time', () => {
  /** What is told last when a phase of `total` seconds is looked at every 50 ms until `until`. */
  function told(total: number, until: number, share = (seconds: number) => seconds / total): number | null {
    const left = remainingTime();
    let last: number | null = null;
    for (let seconds = 0; seconds <= until + 1e-9; seconds += 0.05) last = left(seconds, share(seconds));
    return last;
  }

  it('follows from the share that is done', () => {
    expect(told(40, 10)).toBeCloseTo(30, 6);
    expect(told(40, 30)).toBeCloseTo(10, 6);
  });

  it('is not shown before enough is done, nor when little is left', () => {
    expect(told(40, 2)).toBeNull();
    expect(told(40, 38)).toBeNull();
    expect(remainingTime()(5, null)).toBeNull();
  });

  it('is hidden while it jumps, and shown again once it is steady', () => {
    const jumping = (seconds: number) => (seconds < 5 ? 0.1 : 0.3);
    expect(told(0, 5.6, jumping)).toBeNull();
    const left = remainingTime();
    expect([1, 2, 3, 4].map((seconds) => left(seconds, seconds / 20))).toEqual([null, null, null, 16]);
    expect(left(0.5, 0.5)).toBeNull();
  });
});

describe('what is done', () => {
  it('is the share of all bodies where it is told, otherwise that of the phase', () => {
    expect(shareDone({ phase: 'fitting', fraction: 0.5, share: 0.2 })).toBe(0.2);
    expect(shareDone({ phase: 'idle', fraction: 0, share: 0 })).toBe(0);
    expect(shareDone({ phase: 'fitting', fraction: 0.5 })).toBe(0.5);
    expect(shareDone({ phase: 'idle', fraction: 0 })).toBeNull();
    expect(shareDone(null)).toBeNull();
  });
});

describe('quick normals', () => {
  it('are those of a smooth surface up to a few degrees', () => {
    const mesh = torus(96, 48);
    const [quick, exact] = [quickNormals(mesh), drawnArrays(mesh).normals!];
    for (let corner = 0; corner < mesh.triangles.length; corner++) {
      const at = 3 * corner;
      const cosine = quick[at] * exact[at] + quick[at + 1] * exact[at + 1] + quick[at + 2] * exact[at + 2];
      expect(cosine).toBeGreaterThan(Math.cos((3 * Math.PI) / 180));
    }
  });

  it('are those of the faces at the edges of a cube', () => {
    const mesh = cube();
    const [quick, exact] = [quickArrays(mesh), drawnArrays(mesh)];
    quick.normals!.forEach((value, i) => expect(value).toBeCloseTo(exact.normals![i], 6));
    expect(quick.positions).toEqual(exact.positions);
    expect([quick.low, quick.high]).toEqual([exact.low, exact.high]);
    expect([quick.isQuick, exact.isQuick]).toEqual([true, false]);
  });
});

describe('the value at a place of the order', () => {
  it('is that of the sorted values', () => {
    const values = Float32Array.from({ length: 501 }, (_, i) => ((i * 7919) % 97) - 40);
    const sorted = values.slice().sort();
    for (let place = 0; place < values.length; place++) expect(ranked(values, place)).toBe(sorted[place]);
    expect(ranked(new Float32Array(), 0)).toBe(0);
  });

  it('scales colours: the 98th percentile, the largest value where that is 0, or 1', () => {
    expect(curvatureScale(Float32Array.from({ length: 101 }, (_, i) => 100 - i))).toBe(98);
    expect(curvatureScale(Float32Array.of(...new Array<number>(200).fill(0), 5))).toBe(5);
    expect(curvatureScale(new Float32Array(3))).toBe(1);
  });
});

describe('points for the floor', () => {
  it('lie on the triangles, corners among them', () => {
    const { positions, triangles } = grid(4, 4);
    const points = spreadPoints(positions, triangles);
    const side = 12;
    expect(points.length).toBe(3 * (triangles.length / 3) * (((side + 1) * (side + 2)) / 2));
    const [a, b, c] = [0, 1, 2].map((k) => [...positions.slice(3 * triangles[k], 3 * triangles[k] + 3)]);
    expect([...points.slice(0, 3)]).toEqual(a);
    expect([...points.slice(3 * side, 3 * side + 3)]).toEqual(c);
    const last = (side + 1) * (side + 2) * 0.5 - 1;
    expect([...points.slice(3 * last, 3 * last + 3)]).toEqual(b);
  });

  it('lie on some triangles of many', () => {
    const { positions, triangles } = grid(250, 250);
    const step = spreadStep(triangles.length / 3);
    expect(step).toBe(2);
    expect(spreadPoints(positions, triangles).length).toBe(9 * Math.ceil(triangles.length / 3 / step));
  });
});

describe('the light of the room', () => {
  const words = new Uint32Array(
    new Uint8Array(readFileSync(new URL('../../web/app/viewer/room_light.bin', import.meta.url))).buffer,
  );
  /** The mean of red, green and blue of RGB9_E5. */
  const brightness = (word: number): number =>
    (((word & 511) + ((word >>> 9) & 511) + ((word >>> 18) & 511)) / 3) * 2 ** ((word >>> 27) - 24);
  const level = (width: number, start: number): number[] =>
    Array.from({ length: 6 }, (_, face) => {
      const texels = words.subarray(start + face * width ** 2, start + (face + 1) * width ** 2);
      return texels.reduce((sum, word) => sum + brightness(word), 0) / texels.length;
    });

  it('has six faces of each of its four levels', () => {
    expect(words).toHaveLength(6 * (64 ** 2 + 32 ** 2 + 16 ** 2 + 8 ** 2));
  });

  it('is as bright at every roughness, and comes from above', () => {
    const sharp = level(64, 0);
    const rough = level(8, 6 * (64 ** 2 + 32 ** 2 + 16 ** 2));
    const mean = (faces: number[]): number => faces.reduce((sum, value) => sum + value, 0) / 6;
    expect(mean(rough) / mean(sharp)).toBeGreaterThan(0.8);
    expect(mean(rough) / mean(sharp)).toBeLessThan(1.25);
    const [, , up, down] = rough;
    expect(up).toBeGreaterThan(1.5 * down);
  });
});
