// Takes one measurement in headless Chromium: a page with shared memory whose worker runs the core.

import { createServer } from 'node:http';
import { readFile } from 'node:fs/promises';
import { extname, join, resolve } from 'node:path';
import { chromium } from '@playwright/test';
import { findChromium } from '../../scripts/setup/environment.mjs';

const root = resolve(import.meta.dirname, '..', '..');
const types = {
  '.html': 'text/html',
  '.mjs': 'text/javascript',
  '.js': 'text/javascript',
  '.wasm': 'application/wasm',
};
const browserArguments = JSON.parse(await readFile(join(root, 'tests', 'browser-arguments.json'), 'utf8'));

const worker = `
  import { loadCore } from '/engine/load_core.js';
  import { runModes } from '/run_modes.mjs';
  onmessage = async ({ data: { threads, options } }) => {
    try {
      const core = await loadCore({ threads, wasmFolder: location.origin + '/wasm/' });
      const buffer = await (await fetch('/mesh.bin')).arrayBuffer();
      postMessage({ result: runModes(core, buffer, options) });
    } catch (error) {
      postMessage({ error: error.message });
    }
  };
`;

/** Serves the page, its worker, the core and the mesh, cross-origin isolated so that memory can be shared. */
async function serve(mesh) {
  const folders = {
    '/wasm/': join(root, 'public', 'wasm'),
    '/engine/': join(root, 'build', 'bench', 'engine'),
  };
  const contentOf = async (path) => {
    if (path === '/') return '<!doctype html><title>Modes</title>';
    if (path === '/worker.mjs') return worker;
    if (path === '/mesh.bin') return readFile(mesh);
    if (path === '/run_modes.mjs') return readFile(join(import.meta.dirname, 'run_modes.mjs'));
    const prefix = Object.keys(folders).find((folder) => path.startsWith(folder));
    if (!prefix || path.includes('..')) throw new Error(`${path} is not served`);
    return readFile(join(folders[prefix], path.slice(prefix.length)));
  };
  const server = createServer(async (request, response) => {
    const { pathname } = new URL(request.url, 'http://localhost');
    try {
      const content = await contentOf(pathname);
      const type = pathname === '/' ? 'text/html' : (types[extname(pathname)] ?? 'application/octet-stream');
      response.writeHead(200, {
        'content-type': type,
        'cross-origin-opener-policy': 'same-origin',
        'cross-origin-embedder-policy': 'require-corp',
      });
      response.end(content);
    } catch {
      response.writeHead(404).end();
    }
  });
  await new Promise((done) => server.listen(0, 'localhost', done));
  return server;
}

/** The result of runModes, measured in the browser's worker; throws if there is no Chromium. */
export async function runInBrowser(mesh, threads, options) {
  const executablePath = findChromium();
  if (!executablePath) throw new Error('No Chromium was found: install one or set CHROMIUM.');
  const server = await serve(mesh);
  const browser = await chromium.launch({ executablePath, args: browserArguments });
  try {
    const page = await browser.newPage();
    await page.goto(`http://localhost:${server.address().port}/`);
    const answer = await page.evaluate(
      (message) =>
        new Promise((done) => {
          const thread = new Worker('/worker.mjs', { type: 'module' });
          thread.onmessage = ({ data }) => done(data);
          thread.onerror = ({ message: error }) => done({ error });
          thread.postMessage(message);
        }),
      { threads, options },
    );
    if (answer.error) throw new Error(`In the browser: ${answer.error}`);
    return answer.result;
  } finally {
    await browser.close();
    server.close();
  }
}
