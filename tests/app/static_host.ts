/** A host of static files without any headers, whose files and network a test can change while pages are open. */

import { cpSync, mkdtempSync } from 'node:fs';
import { readFile } from 'node:fs/promises';
import { createServer } from 'node:http';
import type { AddressInfo } from 'node:net';
import { tmpdir } from 'node:os';
import { extname, join, normalize } from 'node:path';

const types: Record<string, string> = {
  '.html': 'text/html',
  '.js': 'text/javascript',
  '.css': 'text/css',
  '.json': 'application/json',
  '.svg': 'image/svg+xml',
  '.png': 'image/png',
  '.wasm': 'application/wasm',
  '.webmanifest': 'application/manifest+json',
};

export interface StaticHost {
  /** address of the served files, below a folder of the host */
  address: string;
  /** a copy of what was built, which the test may change */
  folder: string;
  /** Ends the host; open pages can load nothing more. */
  close(): Promise<void>;
}

const PREFIX = '/tools/limber/';

/** `built`: the folder below `dist` that is served; `isPlain`: by a host that shows no index.html for a folder and has no type for .wasm. */
export async function startHost(built: 'app' | 'site' = 'app', isPlain = false): Promise<StaticHost> {
  const folder = mkdtempSync(join(tmpdir(), 'limber-host-'));
  cpSync(join(import.meta.dirname, '..', '..', 'dist', built), folder, { recursive: true });
  const index = isPlain ? 'none' : 'index.html';
  const typeOf = (ending: string) =>
    (isPlain && ending === '.wasm' ? undefined : types[ending]) ?? 'application/octet-stream';
  const server = createServer((request, response) => {
    const path = normalize(new URL(request.url!, 'http://localhost').pathname);
    const name = path.startsWith(PREFIX) ? path.slice(PREFIX.length) || index : 'none';
    readFile(join(folder, name)).then(
      (bytes) => response.writeHead(200, { 'content-type': typeOf(extname(name)) }).end(bytes),
      () => response.writeHead(404).end(),
    );
  });
  await new Promise<void>((resolve) => server.listen(0, 'localhost', resolve));
  const { port } = server.address() as AddressInfo;
  return {
    address: `http://localhost:${port}${PREFIX}`,
    folder,
    close: () =>
      new Promise((resolve) => {
        server.close(() => resolve());
        server.closeAllConnections();
      }),
  };
}
