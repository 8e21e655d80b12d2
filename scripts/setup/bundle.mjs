// Bundles of the project's own TypeScript for scripts and benchmarks.

import { build } from 'vite';
import { root } from './environment.mjs';

/** Bundles with `options`, Vite's `build` options; paths in them are relative to the repository's root. */
export const bundle = (options) =>
  build({ root, configFile: false, logLevel: 'warn', publicDir: false, build: options });

/** Bundles one module for Node, which also runs in browsers if it imports no package. */
export const bundleModule = (entry, outDir) =>
  bundle({ ssr: entry, outDir, emptyOutDir: true, target: 'es2022' });
