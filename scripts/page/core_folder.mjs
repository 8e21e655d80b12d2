// A plugin of Vite for the built page: the core is in a folder that is named by a hash of its bytes, so that a page
// that is still open never loads the core of a newer version, or a mixture of both.

import { createHash } from 'node:crypto';
import { mkdirSync, readdirSync, readFileSync, renameSync } from 'node:fs';
import { join } from 'node:path';
import { root } from '../setup/environment.mjs';

function hashOf(folder) {
  const hash = createHash('sha256');
  for (const name of readdirSync(folder).sort())
    hash.update(`${name}\0`).update(readFileSync(join(folder, name)));
  return hash.digest('hex').slice(0, 12);
}

/** `core`: the folder with the core, whose files the build copies to wasm/ of the page. */
export function coreFolder(core = join(root, 'public', 'wasm')) {
  let [version, folder] = ['', ''];
  return {
    name: 'core-folder',
    apply: 'build',
    config: () => {
      version = hashOf(core);
      // See web/app/worker/core_folder.ts.
      return { define: { 'import.meta.env.CORE_FOLDER': JSON.stringify(`wasm/${version}/`) } };
    },
    configResolved: (config) => {
      folder = join(config.root, config.build.outDir, 'wasm');
    },
    writeBundle: () => {
      const names = readdirSync(core);
      mkdirSync(join(folder, version));
      for (const name of names) renameSync(join(folder, name), join(folder, version, name));
    },
  };
}
