import { defineConfig } from 'vite';

// The command line as one file; packages stay imports. It finds the core beside the app, in dist/app/wasm/.
export default defineConfig({
  publicDir: false,
  build: {
    ssr: 'web/cli/main.ts',
    outDir: 'dist/cli',
    emptyOutDir: true,
    target: 'node20',
    rolldownOptions: { output: { entryFileNames: 'limber.mjs' } },
  },
});
