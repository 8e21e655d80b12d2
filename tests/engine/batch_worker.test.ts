/** The process of a batch that works on one asset after the other. */

import { fork } from 'node:child_process';
import { cpSync, mkdirSync, mkdtempSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, expect, it } from 'vitest';
import { parseArguments } from '../../web/cli/arguments';
import type { Arguments } from '../../web/cli/arguments';
import { ASSET_WORKER } from '../../web/cli/batch/asset_worker';
import type { WorkDone, WorkOrder } from '../../web/cli/batch/messages';
import { argumentsFor, requestsOf } from '../../web/cli/batch/orders';
import { findSources } from '../../web/cli/batch/sources';
import { EMPTY_CONFIG } from '../../web/engine/settings/batch_config';
import { SQUARE_OBJ } from './support/files';

const root = join(import.meta.dirname, '..', '..');
const folder = mkdtempSync(join(tmpdir(), 'limber-worker-'));
const at = (name: string) => join(folder, name);
afterAll(() => rmSync(folder, { recursive: true, force: true }));

/** The order to optimize src/a.obj. */
function orderOf(): WorkOrder {
  mkdirSync(at('src'));
  mkdirSync(at('out'));
  mkdirSync(at('work'));
  writeFileSync(at('src/a.obj'), SQUARE_OBJ);
  const args = parseArguments(['batch', at('src'), at('out'), '--method', 'qem']) as Arguments;
  const [request] = requestsOf(EMPTY_CONFIG, args, findSources([at('src')], at('out'))).requests;
  const { asset, options, fromPreset } = request;
  return {
    ...{ asset: asset.name, options, fromPreset, result: asset.result, out: at('out'), folder: at('work') },
    args: argumentsFor(args, request, { out: at('out'), threads: 1 }),
  };
}

it('loads the core again for the next asset where that has failed', async () => {
  cpSync(join(root, 'dist', 'cli'), at('cli'), { recursive: true });
  symlinkSync(join(root, 'node_modules'), at('node_modules'));
  const order = orderOf();
  const worker = fork(at('cli/limber.mjs'), [ASSET_WORKER], { serialization: 'advanced' });
  const stateOf = () =>
    new Promise<[string, string[]]>((resolve) => {
      worker.once('message', ({ record }: WorkDone) => resolve([record.state, record.sentences]));
      worker.send(order);
    });
  const missing = 'The WebAssembly core is missing: run npm run build.';
  expect(await stateOf()).toEqual(['failed', [missing]]);
  symlinkSync(join(root, 'public', 'wasm'), at('assets'));
  expect((await stateOf())[0]).not.toBe('failed');
  worker.kill();
});
