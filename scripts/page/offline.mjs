// A plugin of Vite for the built page: its policy as a meta tag, and the service worker with the list of all files.

import { createHash } from 'node:crypto';
import { readdirSync, readFileSync, statSync } from 'node:fs';
import { join, relative, sep } from 'node:path';
import { build } from 'vite';
import { root } from '../setup/environment.mjs';
import { headers, policy } from './headers.mjs';

const NAME = 'service_worker.js';

/** Address of every file below the folder, relative to the page -> SHA-256 in hexadecimal digits. */
function filesOf(folder) {
  const names = readdirSync(folder, { recursive: true }).filter((name) =>
    statSync(join(folder, name)).isFile(),
  );
  const entries = names
    .map((name) => relative('.', name).split(sep).join('/'))
    .filter((path) => path !== NAME && !path.endsWith('.map'))
    .sort()
    .map((path) => [
      path,
      createHash('sha256')
        .update(readFileSync(join(folder, path)))
        .digest('hex'),
    ]);
  // Hosts may redirect the address of index.html to its folder.
  return Object.fromEntries(entries.map(([path, hash]) => [path === 'index.html' ? './' : path, hash]));
}

/** Writes the service worker of the built page in `folder`. */
export async function buildServiceWorker(folder) {
  const files = filesOf(folder);
  const version = createHash('sha256').update(JSON.stringify(files)).digest('hex').slice(0, 12);
  await build({
    configFile: false,
    logLevel: 'warn',
    root,
    publicDir: false,
    define: { BUILT: JSON.stringify({ files, version, headers }) },
    build: {
      outDir: folder,
      emptyOutDir: false,
      target: 'es2022',
      minify: true,
      rolldownOptions: {
        input: join(root, 'web', 'service_worker', 'service_worker.ts'),
        output: { format: 'iife', entryFileNames: NAME },
      },
    },
  });
}

export function offline() {
  let folder = '';
  return {
    name: 'offline',
    apply: 'build',
    configResolved: (config) => {
      folder = join(config.root, config.build.outDir);
    },
    transformIndexHtml: () => [
      {
        tag: 'meta',
        attrs: { 'http-equiv': 'Content-Security-Policy', content: policy },
        injectTo: 'head-prepend',
      },
    ],
    closeBundle: () => buildServiceWorker(folder),
  };
}
