import { resolve } from 'node:path';
import { defineConfig } from 'vite';
import { developmentHeaders, headers } from './scripts/page/headers.mjs';
import { offline } from './scripts/page/offline.mjs';

export default defineConfig({
  root: 'web/app',
  base: './',
  publicDir: '../../public',
  oxc: { jsx: { runtime: 'automatic', importSource: 'preact' } },
  worker: { format: 'es' },
  resolve: {
    alias: { 'ndarray-pixels': resolve(import.meta.dirname, 'web/engine/document/write/no_pixels.ts') },
  },
  plugins: [offline()],
  server: { headers: developmentHeaders },
  preview: { headers },
  build: { outDir: '../../dist/app', emptyOutDir: true, target: 'es2022' },
});
