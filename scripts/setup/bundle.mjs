// Bundles of the project's own TypeScript for scripts and benchmarks.

import { build } from 'vite';
import { root } from './environment.mjs';

/** `options` are Vite's `build`; paths in them are from the repository's root. */
export const bundle = (options) =>
  build({ root, configFile: false, logLevel: 'warn', publicDir: false, build: options });

/** One module for Node; for browsers too where it needs no package. */
export const bundleModule = (entry, outDir) =>
  bundle({ ssr: entry, outDir, emptyOutDir: true, target: 'es2022' });
