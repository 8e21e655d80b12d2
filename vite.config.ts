import { defineConfig } from 'vite';

// Shared memory needs a cross-origin isolated page; without these headers the app runs on one thread.
const isolation = {
  'Cross-Origin-Opener-Policy': 'same-origin',
  'Cross-Origin-Embedder-Policy': 'require-corp',
};

export default defineConfig({
  root: 'web/app',
  base: './',
  publicDir: '../../public',
  oxc: { jsx: { runtime: 'automatic', importSource: 'preact' } },
  worker: { format: 'es' },
  server: { headers: isolation },
  preview: { headers: isolation },
  build: { outDir: '../../dist/app', emptyOutDir: true, target: 'es2022' },
});
