/** Sentences about models that callers give without a name. */

import { Document } from '@gltf-transform/core';
import { expect, it } from 'vitest';
import { filesOf } from '../../web/library/models';
import type { Model } from '../../web/library/options';
import { inCallersWords } from '../../web/library/protocol';
import type { Failure, WorkMessage } from '../../web/library/protocol';
import { Server } from '../../web/library/work/serve';
import { textFile } from '../engine/support/files';
import { toObj, torus } from '../engine/support/shapes';

const wasmFolder = new URL('../../public/wasm/', import.meta.url).href;
const RING = [textFile('ring.obj', toObj(torus()))];
const CUT = new TextEncoder().encode('glTF');

/** What the call says that refuses these models. */
async function refused(...models: Model[]): Promise<string> {
  const messages: WorkMessage[] = [];
  const server = new Server((message) => messages.push(message));
  const which = models.length > 1 ? (['first ', 'second '] as const) : ([''] as const);
  const files = await Promise.all(models.map((model, i) => filesOf(model, which[i])));
  const command = models.length > 1 ? 'compare' : 'inspect';
  await server.answer({ command, models: files, options: { threads: 1 }, core: { wasmFolder } });
  return (messages.at(-1) as { failure: Failure }).failure.message;
}

it('name the model, and which of two it is, but no file', async () => {
  expect(await refused(CUT)).toMatch(/^The model is not a usable GLB \(/);
  expect(await refused(RING, CUT)).toMatch(/^The second model is not a usable GLB \(/);
  expect(await refused(CUT, RING)).toMatch(/^The first model is not a usable GLB \(/);
  expect(await refused(new Document())).toBe('The document has no mesh: export it with a triangle mesh.');
  expect(await refused(RING, new Document())).toMatch(/^The second document has no mesh: /);
  await expect(filesOf(new Uint8Array(4), 'second ')).rejects.toThrow(
    /^The bytes of the second model do not /,
  );
});

it('leave the names of files that callers gave as they are', async () => {
  expect(await refused([{ name: 'chair.glb', bytes: CUT }])).toMatch(/^chair\.glb is not a usable GLB \(/);
  const named = [[textFile('ring.obj', ''), textFile('model.glb', '')]];
  expect(inCallersWords('model.glb and ring.obj are two.', named)).toBe('model.glb and ring.obj are two.');
});
