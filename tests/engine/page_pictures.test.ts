/** Pictures and videos of the page that take a while, during which it is used. */

import { beforeEach, expect, it, vi } from 'vitest';
import { figurePng } from '../../web/app/panels/pictures/figure';
import { makePicture } from '../../web/app/panels/pictures/pictures_state';
import { recordTest } from '../../web/app/panels/pictures/recordings';
import { results, view } from '../../web/app/state/store';
import { twin } from '../../web/app/state/twin';
import type { Viewport } from '../../web/app/viewer/viewport';
import type { OpenedFile } from '../../web/app/worker/protocol';
import type { TwinFrame } from '../../web/app/worker/simulation_protocol';

const page = vi.hoisted(() => {
  vi.stubGlobal('matchMedia', () => ({ matches: true, addEventListener: () => {} }));
  vi.stubGlobal('requestAnimationFrame', (draw: () => void) => setTimeout(draw));
  return {
    saved: [] as string[],
    drawn: [] as object[],
    frames: 0,
    pose: (() => {}) as (pose: unknown) => void,
  };
});

vi.mock('../../web/app/files/files', () => ({ download: (name: string) => page.saved.push(name) }));
vi.mock('../../web/app/state/running', () => ({
  complain: (error: unknown) => {
    throw error;
  },
}));
vi.mock('../../web/app/state/simulation', () => ({ reset: () => {}, stepOnce: () => {} }));
vi.mock('../../web/app/panels/simulate/simulate_view', () => ({ showTwin: () => {} }));
vi.mock('../../web/app/state/end_pose', () => ({
  endPose: () => new Promise((resolve) => (page.pose = resolve)),
}));
vi.mock('../../web/app/viewer/picture/figure_pictures', () => ({
  drawFigure: (bodies: object[]) => page.drawn.push(...bodies),
}));
vi.mock('../../web/app/panels/pictures/figure_page', () => ({ composeFigure: () => ({}) }));
vi.mock('../../web/app/panels/pictures/stage_picture', () => ({
  pngOf: () => Promise.resolve(new Uint8Array()),
  sizeOf: () => ({ width: 16, height: 16, scale: 1 }),
  drawStage: () => ({}),
}));
vi.mock('../../web/app/viewer/picture/recorder', () => ({
  Recorder: {
    open: () => ({
      add: () => void page.frames++,
      finish: () => Promise.resolve(new Uint8Array()),
      cancel: () => {},
    }),
  },
}));

const rest = () => new Promise((resolve) => setTimeout(resolve, 20));
const job = () => ({ signal: new AbortController().signal, onProgress: () => {} });
const named = (name: string) => ({ name, bodies: [{}] }) as unknown as OpenedFile;
const frameAt = (time: number) => ({ time, diverged: [] as string[] }) as unknown as TwinFrame;
const viewport = { orbit: { camera: { quaternion: { clone: () => null } } } } as unknown as Viewport;

beforeEach(() => {
  page.saved.length = page.drawn.length = page.frames = 0;
});

it('a picture has the name of the file that it is of', async () => {
  results.file.value = named('bar.glb');
  const made = makePicture({ what: '', ending: 'picture.png', type: '' }, async () => {
    results.file.value = named('other.glb');
    return '';
  });
  await made;
  expect(page.saved).toEqual(['bar-picture.png']);
});

it('a figure is of the body that was shown when it was asked for', async () => {
  const mesh = { positions: new Float32Array(9), triangles: Uint32Array.of(0, 1, 2) };
  const modes = { modesPerComponent: 1, shapes: new Float32Array(9), modes: [], key: 'modes' };
  results.body.value = { mesh, diagonal: 1 } as never;
  results.mesh.value = { mesh } as never;
  results.modes.value = modes as never;
  results.overview.value = { ranks: new Uint8Array(1), key: 'modes' } as never;
  results.guidance.value = { rank: Float32Array.of(0.5) } as never;
  const made = figurePng(viewport, job());
  results.body.value = results.modes.value = results.overview.value = results.guidance.value = null;
  const positions = mesh.positions;
  page.pose({ bodies: { original: { positions }, optimized: { positions } } });
  await made;
  expect(page.drawn).toMatchObject([
    ...[
      { title: 'Original' },
      { title: 'Mode 1' },
      { title: 'Strain', field: { values: Float32Array.of(0.5) } },
    ],
    ...[{ title: 'Optimized' }, {}, {}],
  ]);
});

it.each([
  ['the step is left', () => (view.step.value = 'reduce')],
  ['the motion begins anew', () => (twin.frame.value = null)],
])('a video of the motion ends where %s', async (_what, change) => {
  view.step.value = 'test';
  twin.frame.value = frameAt(0);
  const made = recordTest({} as Viewport, job());
  await rest();
  for (const time of [0.02, 0.04]) {
    twin.frame.value = frameAt(time);
    await rest();
  }
  expect(page.frames).toBe(2);
  change();
  expect(await made).toEqual(new Uint8Array());
});
