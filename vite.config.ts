import { resolve } from 'node:path';
import { defineConfig } from 'vite';
import { coreFolder } from './scripts/page/core_folder.mjs';
import { developmentHeaders, headers } from './scripts/page/headers.mjs';
import { offline } from './scripts/page/offline.mjs';

// How long each plugin takes is no news to who builds Limber.
const checks = { bundlerTimings: false };

export default defineConfig({
  root: 'web/app',
  base: './',
  publicDir: '../../public',
  oxc: { jsx: { runtime: 'automatic', importSource: 'preact' } },
  worker: { format: 'es', rolldownOptions: { checks } },
  resolve: {
    alias: { 'ndarray-pixels': resolve(import.meta.dirname, 'web/engine/document/write/no_pixels.ts') },
  },
  plugins: [coreFolder(), offline()],
  server: { headers: developmentHeaders },
  preview: { headers },
  build: {
    outDir: '../../dist/app',
    emptyOutDir: true,
    target: 'es2022',
    // The core's worker, with glTF-Transform and its codecs, is larger than what Vite warns of; it is loaded after the page.
    chunkSizeWarningLimit: 1000,
    rolldownOptions: {
      checks,
      onLog(level, log, handle) {
        // Packages for Node and browsers name modules of Node that they do not use here.
        if (!log.message?.includes('externalized for browser compatibility')) handle(level, log);
      },
    },
  },
});
