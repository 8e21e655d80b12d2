import { resolve } from 'node:path';
import { defineConfig } from 'vite';

// The command line with what it uses of its packages, since one file loads faster than a hundred; a command is loaded when it
// is run. It finds the core beside the app, below dist/app/wasm/. Draco looks for its own files in its package.
export default defineConfig({
  publicDir: false,
  resolve: {
    alias: { 'ndarray-pixels': resolve(import.meta.dirname, 'web/engine/document/write/no_pixels.ts') },
  },
  ssr: { noExternal: true, external: ['draco3dgltf', 'gltf-validator'] },
  build: {
    ssr: 'web/cli/main.ts',
    outDir: 'dist/cli',
    emptyOutDir: true,
    target: 'node20',
    rolldownOptions: {
      // How long each plugin takes is no news to who builds Limber.
      checks: { bundlerTimings: false },
      // glTF-Transform makes one for a function that is not used: it loads the tables of languages.
      treeshake: { manualPureFunctions: ['Intl.NumberFormat'] },
      output: { entryFileNames: 'limber.mjs', chunkFileNames: '[name].mjs' },
    },
  },
});
