import { readFileSync } from 'node:fs';
import { resolve } from 'node:path';
import { defineConfig } from 'vite';
import type { Plugin } from 'vite';

/** The colours of the app follow what it sets on its root; pages without scripts follow the system. */
const darkBySystem: Plugin = {
  name: 'dark-by-system',
  enforce: 'pre',
  transform(code, id) {
    if (!id.endsWith('site.css')) return;
    const tokens = readFileSync(resolve(import.meta.dirname, 'web/app/styles/tokens.css'), 'utf8');
    const dark = /:root\[data-theme='dark'\] (\{[^}]*\})/.exec(tokens);
    if (!dark) this.error('tokens.css has no dark colours');
    return `${code}\n@media (prefers-color-scheme: dark) { :root ${dark[1]} }\n`;
  },
};

// The scripts and styles of the site, under the names by which its pages know them. The pages are made by scripts/site.
export default defineConfig({
  base: './',
  plugins: [darkBySystem],
  publicDir: false,
  build: {
    outDir: 'dist/site',
    target: 'es2022',
    cssCodeSplit: true,
    // three.js alone is larger than what Vite warns of.
    chunkSizeWarningLimit: 1000,
    rolldownOptions: {
      // How long each plugin takes is no news to who builds Limber.
      checks: { bundlerTimings: false },
      input: {
        site: resolve(import.meta.dirname, 'web/site/site.ts'),
        gallery: resolve(import.meta.dirname, 'web/site/gallery.ts'),
      },
      output: { entryFileNames: 'assets/[name].js', assetFileNames: 'assets/[name][extname]' },
    },
  },
});
