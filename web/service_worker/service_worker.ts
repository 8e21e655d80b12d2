/**
 * The service worker: keeps all files of one version of the page, so that it works offline and a new version on the host
 * cannot take files away from an open page. It also adds the headers that many static hosts do not send.
 */

/** Written by the build, see scripts/page/offline.mjs. `files`: address relative to the page -> SHA-256. */
declare const BUILT: { files: Record<string, string>; version: string; headers: Record<string, string> };

const worker = self as unknown as ServiceWorkerGlobalScope;
const HASH_HEADER = 'X-Limber-Hash';
const scope = worker.registration.scope;
const FAMILY = `limber ${scope} `;
const CACHE = FAMILY + BUILT.version;
/** index.html in the list of files */
const PAGE = './';

const cacheNames = async (): Promise<string[]> =>
  (await caches.keys()).filter((name) => name.startsWith(FAMILY));

/** The same response with the headers of the page; a copy also forgets that it was redirected, which navigation refuses. */
function withHeaders(response: Response, body: BodyInit | null, more: Record<string, string> = {}): Response {
  const headers = new Headers(response.headers);
  for (const [name, value] of Object.entries({ ...BUILT.headers, ...more })) headers.set(name, value);
  // The body is no longer encoded.
  headers.delete('Content-Encoding');
  headers.delete('Content-Length');
  return new Response(body, { status: response.status, statusText: response.statusText, headers });
}

async function hashOf(bytes: ArrayBuffer): Promise<string> {
  const digest = new Uint8Array(await crypto.subtle.digest('SHA-256', bytes));
  return Array.from(digest, (byte) => byte.toString(16).padStart(2, '0')).join('');
}

/** Types by ending that browsers insist on and that some hosts do not know: modules are not run, and WebAssembly is slow to compile. */
const TYPES: Record<string, string> = {
  js: 'text/javascript',
  wasm: 'application/wasm',
};

function typeHeader(address: string): Record<string, string> {
  const type = TYPES[address.split('.').pop()!];
  return type ? { 'Content-Type': type } : {};
}

/** Throws where the host has another version of the file, as files of two versions do not work together. */
async function load(address: string, hash: string): Promise<Response> {
  const response = await fetch(address, { cache: 'no-cache' });
  if (!response.ok) throw new Error(`${address} could not be loaded: the host answered ${response.status}.`);
  const bytes = await response.arrayBuffer();
  if ((await hashOf(bytes)) !== hash) throw new Error(`${address} is of another version.`);
  return withHeaders(response, bytes, { ...typeHeader(address), [HASH_HEADER]: hash });
}

/** Some hosts show index.html under its name alone, and nothing or a list of files for its folder. */
const loadPage = (hash: string): Promise<Response> =>
  load(scope, hash).catch(() => load(`${scope}index.html`, hash));

/** Keeps all files; those that an earlier version has too are not loaded again. */
async function keepAll(): Promise<void> {
  const cache = await caches.open(CACHE);
  const earlier = await Promise.all((await cacheNames()).map((name) => caches.open(name)));
  const keep = async ([path, hash]: [string, string]): Promise<void> => {
    const address = new URL(path, scope).href;
    const known = (await Promise.all(earlier.map((one) => one.match(address)))).find(
      (response) => response?.headers.get(HASH_HEADER) === hash,
    );
    const loaded = () => (path === PAGE ? loadPage(hash) : load(address, hash));
    await cache.put(address, known ?? (await loaded()));
  };
  // One after the other, as the page itself is at work meanwhile; `isWhole` looks for the last one.
  const { [PAGE]: page, ...others } = BUILT.files;
  for (const entry of [...Object.entries(others), [PAGE, page] as [string, string]]) await keep(entry);
}

/** Whether all files of a version have arrived. */
const isWhole = async (name: string): Promise<boolean> =>
  (await (await caches.open(name)).match(scope)) !== undefined;

/** Keeps this version, the one before it, which other tabs may still show, and one that is on its way. */
async function removeOldest(): Promise<void> {
  const names = await cacheNames();
  const older = names.slice(0, names.indexOf(CACHE));
  const whole = await Promise.all(older.map(isWhole));
  const before = older.filter((_, i) => whole[i]).at(-1);
  await Promise.all(older.filter((name) => name !== before).map((name) => caches.delete(name)));
}

const isPage = (url: URL): boolean => url.href === scope || url.href === `${scope}index.html`;

async function answer(request: Request): Promise<Response> {
  const url = new URL(request.url);
  url.search = url.hash = '';
  const address = isPage(url) ? scope : url.href;
  const cache = await caches.open(CACHE);
  const kept = (await cache.match(address)) ?? (await caches.match(address));
  if (kept) return kept;
  const response = await fetch(request);
  return response.type === 'basic' && response.ok ? withHeaders(response, response.body) : response;
}

worker.addEventListener('install', (event) => event.waitUntil(keepAll()));
worker.addEventListener('activate', (event) =>
  event.waitUntil(removeOldest().then(() => worker.clients.claim())),
);
worker.addEventListener('fetch', (event) => {
  const { request } = event;
  if (request.method === 'GET' && request.url.startsWith(scope)) event.respondWith(answer(request));
});
worker.addEventListener('message', ({ data }) => {
  if (data === 'take over') void worker.skipWaiting();
});
