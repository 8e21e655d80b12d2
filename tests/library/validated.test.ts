/** What the worker of the library says of errors that the glTF validator finds. */

import { beforeEach, expect, it, vi } from 'vitest';
import type { OptimizeRequest, WorkMessage } from '../../web/library/protocol';
import { Server } from '../../web/library/work/serve';
import { addMesh, glbFile, primitiveOf, startDocument } from '../engine/support/gltf';
import { torus } from '../engine/support/shapes';

const wasmFolder = new URL('../../public/wasm/', import.meta.url).href;

/** Files that were looked at, and how many errors the one with the given number has. */
const looked: Uint8Array[] = [];
let errorsOf: (number: number) => number = () => 0;

vi.mock('gltf-validator', () => ({
  validateBytes: (bytes: Uint8Array) => {
    const numErrors = errorsOf(looked.push(bytes) - 1);
    const issue = (_: unknown, i: number) => ({
      code: `E${i}`,
      message: 'Wrong.',
      severity: 0,
      pointer: '/a',
    });
    const messages = Array.from({ length: numErrors }, issue);
    return Promise.resolve({ issues: { numErrors, numWarnings: 0, messages } });
  },
}));

beforeEach(() => {
  looked.length = 0;
});

async function notesOf(options: Partial<OptimizeRequest>): Promise<string[]> {
  const document = startDocument();
  addMesh(document, 'ring', [primitiveOf(document, torus())]);
  const messages: WorkMessage[] = [];
  await new Server((message) => messages.push(message)).answer({
    command: 'optimize',
    models: [[await glbFile(document)]],
    options: { threads: 1, wantsBodies: false, ...options },
    core: { wasmFolder },
  });
  return (messages.at(-1) as { value: { notes: string[] } }).value.notes;
}

it('errors that a result or a level has beside those of its model are noted', async () => {
  // The result, its level with five errors, and the model with one of them.
  errorsOf = (number) => [0, 5, 1][number];
  expect(await notesOf({ ratio: 0.8, lods: [0.5] })).toEqual([
    'the glTF validator finds errors in test_lod1.glb that the model does not have: E1 at /a: Wrong; E2 at /a: Wrong; E3 at /a: Wrong; and 1 more',
  ]);
  looked.length = 0;
  errorsOf = (number) => [1, 0][number];
  expect(await notesOf({ ratio: 0.8 })).toEqual([
    'the glTF validator finds errors in the result that the model does not have: E0 at /a: Wrong',
  ]);
});

it('errors that the model has are not noted, and formats other than glTF are not checked', async () => {
  errorsOf = () => 1;
  expect(await notesOf({ ratio: 0.8 })).toEqual([]);
  expect(looked).toHaveLength(2);
  await notesOf({ ratio: 0.8, format: 'obj' });
  expect(looked).toHaveLength(2);
  await notesOf({ ratio: 0.8, format: 'gltf' });
  expect(looked).toHaveLength(4);
  await notesOf({ ratio: 0.8, format: 'gltf.zip' });
  expect(looked).toHaveLength(6);
});

it('nothing is checked where that is not wanted, or where no file is made', async () => {
  errorsOf = () => 1;
  expect(await notesOf({ ratio: 0.8, validate: false })).toEqual([]);
  expect(await notesOf({ ratio: 0.8, wantsBodies: true })).toEqual([]);
  expect(looked).toHaveLength(0);
});
