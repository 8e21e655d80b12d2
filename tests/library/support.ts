/** Folders as users of the package have them, and the programs that they run in them. */

import { spawnSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { createServer } from 'node:http';
import type { Server } from 'node:http';
import type { AddressInfo } from 'node:net';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

export const root = join(import.meta.dirname, '..', '..');
export const fixture = (name: string) => join(import.meta.dirname, 'fixtures', name);

/** Runs a program; throws with all its output where it fails. Returns stdout. */
export function run(folder: string, program: string, ...args: string[]): string {
  const { status, stdout, stderr, error } = spawnSync(program, args, { cwd: folder, encoding: 'utf8' });
  if (status !== 0)
    throw new Error(`${program} ${args.join(' ')} failed: ${error?.message ?? ''}${stdout}${stderr}`);
  return stdout;
}

export const node = (folder: string, ...args: string[]) => run(folder, process.execPath, ...args);

export function makeFolder(name: string): string {
  const folder = mkdtempSync(join(tmpdir(), `limber-${name}-`));
  writeFileSync(join(folder, 'package.json'), '{ "private": true, "type": "module" }\n');
  return folder;
}

/** Installs packages by name and version, or from a tarball, into a folder. */
export const install = (folder: string, ...packages: string[]) =>
  run(folder, 'npm', 'install', '--prefer-offline', '--no-audit', '--no-fund', '--save-exact', ...packages);

/** The programs of a document by the name in their first line: blocks of JavaScript that begin with "// NAME". */
export function programsOf(document: string): Map<string, string> {
  const blocks = readFileSync(join(root, document), 'utf8').matchAll(/```js\n\/\/ (\S+\.mjs)\n([^]*?)```/g);
  return new Map([...blocks].map(([, name, text]) => [name, text]));
}

export const listFiles = (folder: string): string[] =>
  readdirSync(folder, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map((entry) => join(entry.parentPath, entry.name).slice(folder.length + 1));

const TYPES: Record<string, string> = {
  html: 'text/html',
  js: 'text/javascript',
  mjs: 'text/javascript',
  wasm: 'application/wasm',
};

/** Serves a folder with these headers; returns the address, with a final slash. */
export async function serve(
  folder: string,
  headers: Record<string, string>,
): Promise<{ address: string; server: Server }> {
  const server = createServer((request, response) => {
    const path = new URL(request.url!, 'http://localhost').pathname.replace(/\/$/, '/index.html');
    try {
      const bytes = readFileSync(join(folder, path));
      const type = TYPES[path.split('.').pop()!] ?? 'application/octet-stream';
      response.writeHead(200, { 'Content-Type': type, ...headers }).end(bytes);
    } catch {
      response.writeHead(404).end();
    }
  });
  await new Promise<void>((resolve) => server.listen(0, 'localhost', resolve));
  return { address: `http://localhost:${(server.address() as AddressInfo).port}/`, server };
}

/** A folder with a page that loads `script`. */
export function writePage(folder: string, script: string): void {
  mkdirSync(folder, { recursive: true });
  writeFileSync(
    join(folder, 'index.html'),
    `<!doctype html><link rel="icon" href="data:,"><script type="module" src="${script}"></script>\n`,
  );
}
