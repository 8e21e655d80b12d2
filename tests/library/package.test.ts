// The package as its users have it: the tarball, installed into empty folders. Bundlers are installed there too, for they are no
// part of the repository; npm takes them from its cache or the registry.

import { createHash } from 'node:crypto';
import { copyFileSync, cpSync, readFileSync, rmSync, statSync, writeFileSync } from 'node:fs';
import type { Server } from 'node:http';
import { join } from 'node:path';
import { chromium } from '@playwright/test';
import type { Browser, Page } from '@playwright/test';
import { afterAll, beforeAll, describe, expect, it } from 'vitest';
import { glbFile, startDocument, addMesh, primitiveOf } from '../engine/support/gltf';
import { torus } from '../engine/support/shapes';
import {
  fixture,
  install,
  listFiles,
  makeFolder,
  node,
  programsOf,
  root,
  run,
  serve,
  writePage,
} from './support';

const BUNDLERS = ['webpack@5.112.2', 'esbuild@0.28.2'];
const ISOLATION = {
  'Cross-Origin-Opener-Policy': 'same-origin',
  'Cross-Origin-Embedder-Policy': 'require-corp',
};

const packed = join(root, 'dist', 'package');
const manifest = () => JSON.parse(readFileSync(join(packed, 'package.json'), 'utf8'));
const tool = (...path: string[]) => join(root, 'node_modules', ...path);

let folder: string;
let bundling: string;
/** of the bytes that the command line writes */
let expected: string;
let tarball: string;

const hash = (path: string) => createHash('sha256').update(readFileSync(path)).digest('hex');

beforeAll(async () => {
  node(root, 'scripts/package/pack.mjs');
  tarball = join(root, 'dist', `limber-${manifest().version}.tgz`);
  folder = makeFolder('package');
  install(folder, tarball, '@gltf-transform/extensions@4.5.1');
  const document = startDocument();
  addMesh(document, 'ring', [primitiveOf(document, torus())]);
  for (const name of ['ring.glb', 'chair.glb'])
    writeFileSync(join(folder, name), (await glbFile(document)).bytes);
  node(
    folder,
    'node_modules/limber/cli/limber.mjs',
    'optimize',
    'ring.glb',
    'cli.glb',
    '--ratio',
    '0.5',
    '--quiet',
  );
  expected = hash(join(folder, 'cli.glb'));
}, 240_000);

afterAll(() => {
  for (const made of [folder, bundling]) if (made) rmSync(made, { recursive: true, force: true });
});

describe('the tarball', () => {
  it('has the programs, the core, declarations, schemas and notices, and nothing else, in less than 5 MB', () => {
    const names = listFiles(packed);
    const allowed =
      /^((cli|node|shared|browser)\/[\w-]+(\.module)?\.mjs|assets\/(worker|limber-(single|threads))\.(js|wasm)|types\/[\w/]+\.d\.ts|schemas\/(report|settings|batch)\.schema\.json|(limber\.1|package\.json|README\.md|LICENSE|THIRD-PARTY-NOTICES\.md))$/;
    expect(names.filter((name) => !allowed.test(name))).toEqual([]);
    for (const name of ['cli/limber.mjs', 'assets/limber-threads.wasm', 'assets/worker.js', 'LICENSE'])
      expect(names).toContain(name);
    expect(statSync(tarball).size).toBeLessThan(5e6);
  });

  it('is described by the manifest of the repository and asks for nothing of the page', () => {
    const repository = JSON.parse(readFileSync(join(root, 'package.json'), 'utf8'));
    const { name, version, license, sideEffects, dependencies } = manifest();
    expect([name, version, license, sideEffects]).toEqual(['limber', repository.version, 'MIT', false]);
    expect(Object.keys(dependencies)).toEqual(['@gltf-transform/core', 'draco3dgltf', 'gltf-validator']);
    const installed = listFiles(join(folder, 'node_modules')).map((path) => path.split('/')[0]);
    for (const name of ['three', 'preact', 'sharp', 'comlink']) expect(installed).not.toContain(name);
  });

  it('names the licence of every package that it contains', () => {
    const notices = readFileSync(join(packed, 'THIRD-PARTY-NOTICES.md'), 'utf8');
    for (const name of ['Eigen', 'Spectra', '@gltf-transform/core', 'draco3dgltf', 'meshoptimizer', 'earcut'])
      expect(notices).toMatch(new RegExp(`^## .*${name} `, 'm'));
  });
});

describe('in Node', () => {
  it('npx limber --version says the version', () => {
    expect(run(folder, 'npx', 'limber', '--version').trim()).toBe(manifest().version);
  });

  const programs = new Map([...programsOf('docs/library.md'), ...programsOf('README.md')]);

  it('the documents have programs', () =>
    expect([...programs.keys()]).toEqual(['transform.mjs', 'optimize.mjs', 'all.mjs', 'readme.mjs']));

  it.each([...programs.keys()])('%s of the documents runs', (name) => {
    rmSync(join(folder, 'small.glb'), { force: true });
    writeFileSync(join(folder, name), programs.get(name)!);
    node(folder, name);
    if (name === 'all.mjs') return;
    const small = statSync(join(folder, 'small.glb')).size;
    expect(small).toBeLessThan(statSync(join(folder, 'chair.glb')).size);
  });

  it('bytes, documents of one and several buffers, and threads give the bytes of the command line', () => {
    copyFileSync(fixture('same.mjs'), join(folder, 'same.mjs'));
    const found = JSON.parse(node(folder, 'same.mjs'));
    const { split, merged, ...others } = found;
    expect(others).toEqual({ bytes: expected, oneThread: expected, document: expected });
    expect(split).toBe(merged);
  });

  it('refuses, stops and recovers', () => {
    copyFileSync(fixture('stops.mjs'), join(folder, 'stops.mjs'));
    expect(JSON.parse(node(folder, 'stops.mjs'))).toEqual({
      setting: [
        'LimberError',
        'strainWeight',
        'strainWeight is -2: give a number from 0 to 1000 (default: 1).',
      ],
      ratio: ['LimberError', null, 'ratio is 2: give a number above 0 and up to 1.'],
      option: [
        'LimberError',
        null,
        'inspect does not take "ratio", which is no option: see the README of the package.',
      ],
      model: [
        'LimberError',
        null,
        'The bytes of the model do not start with "glTF", as those of a GLB do: give a model of another format with its name, as in [{ name: "chair.obj", bytes }].',
      ],
      before: 'stop before',
      running: 'stop at modes',
      waiting: ['stop waiting', true],
      thrown: 'by the caller',
      closed: 'The library was closed while it worked.',
      documentKept: true,
      after: 288,
    });
  });

  it('importing it loads and starts nothing', () => {
    const program = `
      const all = await import('limber');
      await new Promise((resolve) => setTimeout(resolve, 100));
      console.log(JSON.stringify([Object.keys(all), process.getActiveResourcesInfo(), 'Worker' in globalThis]));`;
    const [names, resources, hasWorker] = JSON.parse(node(folder, '--input-type=module', '-e', program));
    expect(names).toEqual([
      'LimberError',
      'close',
      'compare',
      'inspect',
      'limber',
      'modes',
      'optimize',
      'simulate',
      'tune',
      'version',
    ]);
    expect([resources, hasWorker]).toEqual([[], false]);
  });

  it.each(['node16', 'nodenext', 'bundler'])(
    'its types, and programs of the documents, hold under tsc --strict with moduleResolution %s',
    (resolution) => {
      copyFileSync(fixture('types.ts'), join(folder, 'types.ts'));
      const sources = [...programs].map(([name, text]) => {
        const source = name.replace('.mjs', '.mts');
        writeFileSync(join(folder, source), text);
        return source;
      });
      const module = resolution === 'bundler' ? 'esnext' : resolution;
      const flags = ['--strict', '--noEmit', '--target', 'es2022', '--lib', 'esnext,dom'];
      flags.push('--types', 'node', '--typeRoots', tool('@types'));
      flags.push('--module', module, '--moduleResolution', resolution);
      node(folder, tool('typescript', 'bin', 'tsc'), ...flags, 'types.ts', ...sources);
    },
  );
});

describe('in browsers', () => {
  let browser: Browser;
  const servers: Server[] = [];

  beforeAll(async () => {
    bundling = makeFolder('bundling');
    cpSync(folder, bundling, { recursive: true });
    install(bundling, ...BUNDLERS, '@gltf-transform/extensions@4.5.1');
    for (const name of ['page.js', 'document.js']) copyFileSync(fixture(name), join(bundling, name));
    const args = JSON.parse(readFileSync(join(root, 'tests', 'browser-arguments.json'), 'utf8'));
    browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium', args });
  }, 120_000);

  afterAll(async () => {
    for (const server of servers) server.close();
    await browser?.close();
  });

  /** Bundles ENTRY.js into OUT/, in which index.html loads it; with `isNodeExternal` modules of Node are left out of it, which the whole of glTF-Transform asks for. */
  const BUNDLE: Record<string, (entry: string, out: string, isNodeExternal: boolean) => void> = {
    vite: (entry, out) => {
      writePage(bundling, `./${entry}.js`);
      node(bundling, tool('vite', 'bin', 'vite.js'), 'build', '--outDir', out, '--logLevel', 'error');
    },
    webpack: (entry, out, isNodeExternal) => {
      const config = {
        mode: 'production',
        entry: `./${entry}.js`,
        output: { path: join(bundling, out) },
        performance: { hints: false },
        ...(isNodeExternal ? { externals: { 'node:fs': '{}', 'node:path': '{}' } } : {}),
      };
      node(bundling, '--input-type=module', '-e', webpackProgram(config));
      writePage(join(bundling, out), './main.js');
    },
    esbuild: (entry, out, isNodeExternal) => {
      const flags = ['--bundle', '--format=esm', '--splitting', `--outdir=${out}`, '--log-level=error'];
      run(
        bundling,
        'npx',
        'esbuild',
        `${entry}.js`,
        ...flags,
        ...(isNodeExternal ? ['--external:node:*'] : []),
      );
      writePage(join(bundling, out), `./${entry}.js`);
    },
  };

  const webpackProgram = (config: object) =>
    `import webpack from 'webpack';
     webpack(${JSON.stringify(config)}, (error, stats) => {
       if (error || stats.hasErrors()) throw error ?? new Error(stats.toString());
     });`;

  async function visit(
    out: string,
    headers: Record<string, string>,
    query = '',
    prepare: (page: Page) => Promise<unknown> = async () => {},
  ) {
    copyFileSync(join(folder, 'ring.glb'), join(bundling, out, 'ring.glb'));
    const { address, server } = await serve(join(bundling, out), headers);
    servers.push(server);
    const page = await browser.newPage();
    await prepare(page);
    // Printed, since a strict policy forbids what evaluates in the page.
    const printed = page.waitForEvent('console', {
      predicate: (message) => message.text().startsWith('found '),
      timeout: 60_000,
    });
    await page.goto(`${address}${query}`);
    const text = (await printed).text().slice('found '.length);
    await page.close();
    return JSON.parse(text) as Record<string, unknown>;
  }

  const asExpected = (threads: unknown) => ({
    glb: expected,
    threads,
    stages: expect.arrayContaining(['prepared', 'modes', 'history', 'fitted', 'measured', 'written']),
    reason: 'TimeoutError',
    solver: 'springs',
  });

  it.each(Object.keys(BUNDLE))(
    'a bundle of %s runs on threads where it may, on one elsewhere',
    async (name) => {
      BUNDLE[name]('page', name, false);
      expect(await visit(name, {})).toEqual(asExpected(1));
      const isolated = await visit(name, ISOLATION);
      expect(isolated).toEqual(asExpected(isolated.threads));
      expect(isolated.threads).toBeGreaterThan(1);
    },
  );

  it.each(Object.keys(BUNDLE))('a bundle of %s takes documents of glTF-Transform', async (name) => {
    BUNDLE[name]('document', `${name}-document`, true);
    expect(await visit(`${name}-document`, {})).toEqual({ glb: expected });
  });

  it('runs from a folder of the page where its content security policy forbids blobs', async () => {
    BUNDLE.esbuild('page', 'strict', false);
    cpSync(join(packed, 'assets'), join(bundling, 'strict', 'limber'), { recursive: true });
    const policy =
      "default-src 'none'; script-src 'self' 'unsafe-eval'; worker-src 'self'; connect-src 'self'; img-src data:";
    const headers = { ...ISOLATION, 'Content-Security-Policy': policy };
    const refused = await visit('strict', headers);
    expect(refused.error).toMatch(/^LimberError: The worker cannot be started from a blob, /);
    const served = await visit('strict', headers, '?assets=/limber/');
    expect(served).toEqual(asExpected(served.threads));
  });

  it('asks again for a part of the bundle that did not arrive', async () => {
    BUNDLE.esbuild('page', 'again', false);
    const loseOne = (page: Page) => page.route('**/_payload_single*', (route) => route.abort(), { times: 1 });
    expect(await visit('again', {}, '?again', loseOne)).toEqual({ ...asExpected(1), missed: 'LimberError' });
  });

  it('tells of a folder that has not all of its files', async () => {
    BUNDLE.esbuild('page', 'gone', false);
    const out = join(bundling, 'gone');
    const asked = () => visit('gone', {}, '?assets=/limber/');
    const cure = 'serve all files of limber/assets, of this version and unchanged, from its folder.';
    const address = 'http://localhost:\\d+/limber/';
    expect((await asked()).error).toMatch(
      new RegExp(`^LimberError: ${address}worker.js cannot be started: ${cure}$`),
    );
    cpSync(join(packed, 'assets'), join(out, 'limber'), { recursive: true });
    rmSync(join(out, 'limber', 'limber-single.wasm'));
    expect((await asked()).error).toMatch(
      new RegExp(`^LimberError: The core in ${address} cannot be loaded: ${cure}$`),
    );
  });

  it('what is not used is left out', () => {
    writeFileSync(
      join(bundling, 'nothing.js'),
      "import { optimize } from 'limber';\nimport 'limber';\nconsole.log('nothing');\n",
    );
    const text = run(
      bundling,
      'npx',
      'esbuild',
      'nothing.js',
      '--bundle',
      '--format=esm',
      '--log-level=error',
    );
    expect(text).not.toMatch(/limber|gltf/i);
  });
});
