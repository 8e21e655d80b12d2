// The bundles of the npm package: the library for Node and for browsers, and the command line with the worker.

import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { gzipSync } from 'node:zlib';
import { build } from 'vite';
import { root } from '../setup/environment.mjs';

/** External, because its files are found relative to its installation. */
const DRACO = 'draco3dgltf';
/** External, because callers pass in its objects. */
const GLTF = '@gltf-transform/core';

/** No module of the library has side effects when loaded. */
const PURE = { treeshake: { moduleSideEffects: false } };

const source = (...path) => join(root, 'web', ...path);
const packed = (bytes) => gzipSync(bytes, { level: 9 }).toString('base64');

/** Settings of every bundle: `output` of rolldown, into `folder`; other files there are kept. */
const bundle = (folder, input, output, others = {}) => ({
  configFile: false,
  root,
  logLevel: 'error',
  publicDir: false,
  resolve: { alias: { 'ndarray-pixels': source('engine', 'document', 'write', 'no_pixels.ts') } },
  ...others,
  build: {
    outDir: folder,
    emptyOutDir: false,
    target: 'es2022',
    copyPublicDir: false,
    ...others.build,
    rolldownOptions: { input, output, ...others.build?.rolldownOptions },
  },
});

/** The command line, and the worker of the library in Node, with all dependencies except Draco, which finds its own files. */
const programs = (folder) =>
  bundle(
    folder,
    { 'cli/limber': source('cli', 'main.ts'), 'node/worker': source('library', 'work', 'node_main.ts') },
    { entryFileNames: '[name].mjs', chunkFileNames: 'shared/[name].mjs' },
    { ssr: { noExternal: true, external: [DRACO, 'gltf-validator'] }, build: { ssr: true } },
  );

/** The worker of the library in browsers: one file. */
const browserWorker = (folder) =>
  bundle(
    folder,
    { worker: source('library', 'work', 'browser_main.ts') },
    { entryFileNames: 'worker.js', codeSplitting: false },
    { build: { minify: true, assetsInlineLimit: Infinity, modulePreload: false } },
  );

/** The library for Node; glTF-Transform is imported from the caller's installation. */
const nodeLibrary = (folder) =>
  bundle(
    folder,
    { index: source('library', 'index.ts') },
    { entryFileNames: 'node/[name].mjs', chunkFileNames: 'node/[name].mjs' },
    { ssr: { noExternal: true, external: [GLTF] }, build: { ssr: true, rolldownOptions: PURE } },
  );

/**
 * The library for browsers; `payload` has the worker and the core as texts. The needed parts of glTF-Transform are
 * bundled, because the whole package refers to Node modules, which webpack and esbuild refuse for browsers.
 */
const browserLibrary = (folder, payload) =>
  bundle(
    folder,
    { index: source('library', 'index.ts') },
    { entryFileNames: 'browser/[name].mjs', chunkFileNames: 'browser/[name].mjs' },
    {
      plugins: [payloadPlugin(payload)],
      build: {
        lib: { entry: source('library', 'index.ts'), formats: ['es'] },
        minify: false,
        rolldownOptions: PURE,
      },
    },
  );

/** Resolves `payload:NAME` to the text of payload[NAME]. */
const payloadPlugin = (payload) => ({
  name: 'payload',
  resolveId: (id) => (id.startsWith('payload:') ? `\0${id.replace(':', '_')}` : null),
  load: (id) => (id.startsWith('\0payload_') ? payload[id.slice('\0payload_'.length)] : null),
});

/** The modules of the payload, from the files in `assets`. */
function payloadOf(assets) {
  const read = (name) => readFileSync(join(assets, name));
  const core = (build) => {
    const wasm = packed(read(`limber-${build}.wasm`));
    const glue = packed(startedFromBlob(read(`limber-${build}.js`).toString()));
    return `export const glue = '${glue}';\nexport const wasm = '${wasm}';\n`;
  };
  const worker = `export default '${packed(read('worker.js'))}';\n`;
  return { worker, single: core('single'), threads: core('threads') };
}

/** The glue of Emscripten starts its threads from a neighbouring file, which a blob does not have: they start from the blob itself. */
function startedFromBlob(glue) {
  const own = 'new URL(`limber-threads.js`,import.meta.url)';
  if (glue.includes('PThread') && !glue.includes(own))
    throw new Error(`The glue of the core does not have ${own}: scripts/package/bundles.mjs has to follow.`);
  return glue.replaceAll(own, 'import.meta.url');
}

/** Writes all bundles into `folder`, whose `assets` contain the core. Returns the ids of the modules that contributed code. */
export async function writeBundles(folder) {
  const modules = new Set();
  const run = async (config) => {
    const results = [await build(config)].flat();
    for (const { output } of results)
      for (const { modules: contained = {} } of output)
        for (const [id, { renderedLength }] of Object.entries(contained))
          if (renderedLength > 0) modules.add(id);
  };
  await run(programs(folder));
  await run(nodeLibrary(folder));
  await run(browserWorker(join(folder, 'assets')));
  await run(browserLibrary(folder, payloadOf(join(folder, 'assets'))));
  return modules;
}
