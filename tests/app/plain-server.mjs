// A static host without COOP and COEP headers, like most hosts: pages have no shared memory there.

import { createServer } from 'node:http';
import { readFile } from 'node:fs/promises';
import { extname, join, normalize } from 'node:path';

const folder = join(import.meta.dirname, '..', '..', 'dist', 'app');
const types = {
  '.html': 'text/html',
  '.js': 'text/javascript',
  '.css': 'text/css',
  '.json': 'application/json',
  '.svg': 'image/svg+xml',
  '.wasm': 'application/wasm',
  '.webmanifest': 'application/manifest+json',
};

createServer(async (request, response) => {
  const path = normalize(new URL(request.url, 'http://localhost').pathname);
  try {
    const bytes = await readFile(join(folder, path === '/' ? 'index.html' : path));
    response.writeHead(200, {
      'content-type': types[extname(path)] ?? (path === '/' ? 'text/html' : 'application/octet-stream'),
    });
    response.end(bytes);
  } catch {
    response.writeHead(404).end();
  }
}).listen(Number(process.argv[2]), 'localhost');
