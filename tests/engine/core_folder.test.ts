/** The folder of the core in the built page: named after its bytes, so that no page loads another core than its own. */

import { mkdirSync, mkdtempSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { expect, it } from 'vitest';
import { coreFolder } from '../../scripts/page/core_folder.mjs';
import { coreFolder as coreAddress } from '../../web/app/worker/core_folder';

const FILES = ['limber-single.js', 'limber-single.wasm'];

/** Builds a page of a core of these bytes; returns the address of the core, and its folder. */
function build(bytes: string): { address: string; folder: string } {
  const root = mkdtempSync(join(tmpdir(), 'limber-core-'));
  const [core, copied] = ['core', 'built/wasm'].map((name) => join(root, name));
  for (const folder of [core, copied]) {
    mkdirSync(folder, { recursive: true });
    for (const name of FILES) writeFileSync(join(folder, name), bytes);
  }
  const plugin = coreFolder(core);
  const [address] = Object.values(plugin.config().define).map((text) => JSON.parse(text) as string);
  plugin.configResolved({ root, build: { outDir: 'built' } });
  plugin.writeBundle();
  return { address, folder: join(root, 'built', address) };
}

it('another core has another address, and the same core has the same', () => {
  const [first, again, newer] = ['old', 'old', 'new'].map((bytes) => build(bytes).address);
  expect([again === first, newer === first]).toEqual([true, false]);
  expect(first).toMatch(/^wasm\/[0-9a-f]{12}\/$/);
});

it('its files are at that address alone', () => {
  const { folder } = build('old');
  expect(readdirSync(folder)).toEqual(FILES);
  expect(readFileSync(join(folder, FILES[1]), 'utf8')).toBe('old');
  expect(readdirSync(join(folder, '..'))).toHaveLength(1);
});

it('while the page is developed its core is that of public/, below any path', () => {
  expect(coreAddress('http://localhost/tools/limber/')).toBe('http://localhost/tools/limber/wasm/');
});
