import { defineConfig } from 'vite';

// The generator of the samples as one file for Node; packages stay imports.
export default defineConfig({
  publicDir: false,
  build: {
    ssr: 'scripts/samples/make-samples.ts',
    outDir: 'build/samples',
    emptyOutDir: true,
    target: 'node20',
    rolldownOptions: {
      // How long each plugin takes is no news to who builds Limber.
      checks: { bundlerTimings: false },
      output: { entryFileNames: 'make-samples.mjs' },
    },
  },
});
