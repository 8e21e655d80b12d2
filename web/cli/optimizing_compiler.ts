/** When V8 compiles functions of the core a second time, with its optimizing compiler. */

import { setFlagsFromString } from 'node:v8';

/** About the bytes that a function executes before V8 optimizes it. docs/experiments.md has times with others. */
const BUDGET = 20_000_000;

/**
 * Lets V8 optimize functions of WebAssembly later. Up to version 11 (Node 20 and 21) it does so after 1.8 million bytes,
 * and a small mesh is finished before that pays; version 12 waits for 13 million by itself, and is left as it is.
 */
export function optimizeLater(version = process.versions.v8): void {
  if (Number.parseInt(version, 10) < 12) setFlagsFromString(`--wasm-tiering-budget=${BUDGET}`);
}
