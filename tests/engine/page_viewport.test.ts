/** What the viewport shows of meshes whose arrays, modes and positions come at different times. */

import { expect, it, vi } from 'vitest';
import { drawnArrays, quickArrays } from '../../web/app/viewer/drawn_arrays';
import { mapTexture } from '../../web/app/viewer/colours';
import { Pane } from '../../web/app/viewer/pane';
import { sceneFaces, showShapes } from '../../web/app/panels/viewport/show_bodies';
import { results, view } from '../../web/app/state/store';
import type { Viewport } from '../../web/app/viewer/viewport';
import type { TriangleMesh } from '../../web/engine/core/core';
import { grid } from './support/shapes';

vi.hoisted(() => {
  vi.stubGlobal('matchMedia', () => ({ matches: true, addEventListener: () => {} }));
  vi.stubGlobal('document', { hidden: false, baseURI: 'http://localhost/' });
  vi.stubGlobal('devicePixelRatio', 1);
});

/** Prepares what is drawn when a test says so. */
class LateWorker {
  static readonly due: (() => void)[] = [];
  onmessage: (event: object) => void = () => {};

  postMessage({ mesh, isQuick }: { mesh: TriangleMesh; isQuick: boolean }): void {
    LateWorker.due.push(() => this.onmessage({ data: isQuick ? quickArrays(mesh) : drawnArrays(mesh) }));
  }
}
vi.stubGlobal('Worker', LateWorker);

/** Lets the next worker answer. */
async function answer(): Promise<void> {
  await vi.waitUntil(() => LateWorker.due.length > 0);
  LateWorker.due.shift()!();
  await new Promise((resolve) => setTimeout(resolve));
}

/** Larger than what is prepared at once. */
const large = grid(80, 80);
const lifted = large.positions.map((value, i) => (i % 3 === 2 ? value + 5 : value));

interface Drawn {
  geometry: { getAttribute(name: string): { getZ(i: number): number } };
}
const heightIn = (pane: Pane): number =>
  (pane.scene.children[0] as never as Drawn).geometry.getAttribute('position').getZ(0);

it('positions that come before a large mesh can be moved are shown as soon as it can', async () => {
  const pane = new Pane(mapTexture('viridis'), 1, () => {});
  void pane.show(large);
  pane.setPositions(lifted, null);
  await answer();
  await answer();
  expect(heightIn(pane)).toBe(5);
  pane.setPositions(null, null);
  expect(heightIn(pane)).toBe(0);
});

it('a mesh stays where it is until the next one is there', async () => {
  const pane = new Pane(mapTexture('viridis'), 1, () => {});
  const small = grid(2, 2);
  void pane.show(small);
  pane.setPositions(
    small.positions.map(() => 3),
    null,
  );
  void pane.show(large);
  pane.setPositions(lifted, null);
  pane.setPositions(small.positions, null);
  expect(heightIn(pane)).toBe(3);
  await answer();
  await answer();
  expect(heightIn(pane)).toBe(5);
});

it('modes of a mesh that was welded in another way move nothing', () => {
  const displace = vi.fn();
  view.step.value = 'motion';
  results.body.value = { mesh: grid(2, 2) } as never;
  const shapesOf = (vertices: number) =>
    ({ modesPerComponent: 1, shapes: new Float32Array(3 * vertices) }) as never;
  results.modes.value = shapesOf(9);
  showShapes({ displace } as unknown as Viewport);
  expect(displace).toHaveBeenCalledWith('original', expect.any(Float32Array));
  results.modes.value = shapesOf(12);
  showShapes({ displace } as unknown as Viewport);
  expect(displace).toHaveBeenCalledWith('original', null);
});

it('the faces of a scene are counted as the slider shares them out, also until its result is drawn', () => {
  const bodies = [{ faces: 10 }, { faces: 20 }, { faces: 7, health: null }];
  results.file.value = { bodies } as never;
  results.originalFile.value = new Uint8Array();
  view.step.value = 'reduce';
  expect(sceneFaces('optimized')).toBe(18);
  results.shares.value = { expected: [4, 9, 0] } as never;
  expect([sceneFaces('original'), sceneFaces('optimized')]).toEqual([37, 20]);
});
