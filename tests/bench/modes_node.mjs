// A fresh Node process for one measurement: modes_node.mjs MESH THREADS '{"model", "exact", "calls"}'; JSON on stdout.

import { readFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { runModes } from './run_modes.mjs';

const root = resolve(import.meta.dirname, '..', '..');
const [mesh, threads, options] = process.argv.slice(2);
const { loadCore } = await import(pathToFileURL(join(root, 'build', 'bench', 'engine', 'load_core.js')).href);
const wasmFolder = pathToFileURL(join(root, 'public', 'wasm', '/')).href;
const core = await loadCore({ threads: Number(threads), wasmFolder });
const bytes = readFileSync(mesh);
const buffer = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length);
console.log(JSON.stringify(runModes(core, buffer, JSON.parse(options))));
process.exit(0);
