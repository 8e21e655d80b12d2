/** Pictures of the page that take a while, during which it is used. */

import { beforeEach, expect, it, vi } from 'vitest';
import { makePicture } from '../../web/app/panels/pictures/pictures_state';
import { results } from '../../web/app/state/store';
import type { OpenedFile } from '../../web/app/worker/protocol';

const page = vi.hoisted(() => {
  vi.stubGlobal('matchMedia', () => ({ matches: true, addEventListener: () => {} }));
  vi.stubGlobal('requestAnimationFrame', (draw: () => void) => setTimeout(draw));
  return {
    saved: [] as string[],
  };
});

vi.mock('../../web/app/files/files', () => ({ download: (name: string) => page.saved.push(name) }));
vi.mock('../../web/app/state/running', () => ({
  complain: (error: unknown) => {
    throw error;
  },
}));
const named = (name: string) => ({ name, bodies: [{}] }) as unknown as OpenedFile;

beforeEach(() => {
  page.saved.length = 0;
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
