// Loads the bundled engine and the core for the evaluation.

import { createHash } from 'node:crypto';
import { readFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { bundleModule } from '../../../scripts/setup/bundle.mjs';

export const root = resolve(import.meta.dirname, '..', '..', '..');
export const scratch = join(root, 'build', 'bench', 'fidelity');
export const imageFolder = join(root, 'docs', 'images', 'simplification');
const wasm = join(root, 'public', 'wasm');

/** The first 16 hexadecimal digits of the SHA-256 of all parts, which are strings or typed arrays. */
export function hashOf(...parts) {
  const hash = createHash('sha256');
  for (const part of parts) hash.update(part).update('\n');
  return hash.digest('hex').slice(0, 16);
}

/** { engine, core, version, wasmFolder }: `version` changes with the code of core and engine. Requires `npm run build`. */
export async function loadEngine() {
  const outDir = join(scratch, 'engine');
  await bundleModule('tests/bench/fidelity/engine.ts', outDir);
  const bundle = join(outDir, 'engine.js');
  const engine = await import(pathToFileURL(bundle).href);
  const wasmFolder = pathToFileURL(join(wasm, '/')).href;
  const core = await engine.loadCore({ threads: 0, wasmFolder });
  const name = core.threads > 1 ? 'threads' : 'single';
  const version = hashOf(readFileSync(join(wasm, `limber-${name}.wasm`)), readFileSync(bundle));
  return { engine, core, version, wasmFolder };
}
