// npm run build: sets up the machine and builds everything. With --core, only the C++ core.

import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readdirSync, readFileSync, statSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { buildWasm } from './setup/core.mjs';
import { root, run } from './setup/environment.mjs';
import { setUp } from './setup/setup.mjs';

/**
 * Builds what is out of date; returns the result of `setUp`. `coreOnly`: nothing but the core. `threadsOnly`: no command line and no
 * core without threads, which a page does not load where threads may share memory.
 */
export function build({ tests = false, coreOnly = false, threadsOnly = false } = {}) {
  const setup = setUp({ tests });
  console.log('Building the core ...');
  buildWasm(setup, threadsOnly ? ['threads'] : undefined);
  if (coreOnly) return setup;
  const vite = join(root, 'node_modules', 'vite', 'bin', 'vite.js');
  const bundle = (...args) => run(process.execPath, [vite, 'build', '--logLevel', 'warn', ...args]);
  whenChanged('samples', ['scripts/samples', 'vite.samples.config.ts'], 'public/samples/index.json', () => {
    console.log('Making the samples ...');
    bundle('--config', 'vite.samples.config.ts');
    run(process.execPath, ['build/samples/make-samples.mjs', 'public/samples']);
  });
  const shared = ['web/engine', 'package.json', 'package-lock.json'];
  if (!threadsOnly)
    whenChanged('cli', [...shared, 'web/cli', 'vite.cli.config.ts'], 'dist/cli/limber.mjs', () => {
      console.log('Building the command line ...');
      bundle('--config', 'vite.cli.config.ts');
    });
  whenChanged(
    'app',
    [...shared, 'web/app', 'web/service_worker', 'scripts/page', 'public', 'vite.config.ts'],
    'dist/app/index.html',
    () => {
      console.log('Building the page ...');
      bundle();
    },
  );
  return setup;
}

/** Runs `make` if any file below `inputs` has changed since the last time or `output` does not exist. */
function whenChanged(name, inputs, output, make) {
  const stamp = join(root, 'build', 'stamps', name);
  const state = fingerprint(inputs.map((input) => join(root, input)));
  if (existsSync(join(root, output)) && existsSync(stamp) && readFileSync(stamp, 'utf8') === state) return;
  make();
  mkdirSync(join(root, 'build', 'stamps'), { recursive: true });
  writeFileSync(stamp, fingerprint(inputs.map((input) => join(root, input))));
}

function fingerprint(paths) {
  const hash = createHash('sha256');
  const visit = (path) => {
    const entry = statSync(path);
    if (entry.isDirectory()) for (const name of readdirSync(path).sort()) visit(join(path, name));
    else hash.update(`${path}\0`).update(readFileSync(path));
  };
  for (const path of paths) if (existsSync(path)) visit(path);
  return hash.digest('hex');
}

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
  build({ coreOnly: process.argv.includes('--core') });
  console.log('Built.');
}
