/**
 * The worker in browsers. Its program and the core are texts in modules of the package, which every bundler understands, and
 * are started from blobs; with `assets` they are loaded from a folder of the page instead.
 */

import type { CoreAddress, Listener, StartedWorker, WorkMessage, WorkRequest } from './protocol';

type Build = 'single' | 'threads';

export async function startBrowserWorker(
  listener: Listener,
  { assets, threads }: { assets: string | null; threads: number },
): Promise<StartedWorker> {
  // Memory is shared in pages that are isolated from other origins; elsewhere the core has one thread.
  const build: Build = threads !== 1 && typeof SharedArrayBuffer !== 'undefined' ? 'threads' : 'single';
  const [program, core] = assets === null ? await fromBlobs(build) : fromFolder(assets);
  const worker = new Worker(program, { type: 'module', name: 'limber' });
  worker.addEventListener('message', ({ data }: MessageEvent<WorkMessage>) => listener.onMessage(data));
  worker.addEventListener('error', ({ message }) =>
    listener.onError(
      new Error(message || 'The worker of limber could not be started: see the README of the package.'),
    ),
  );
  return {
    core,
    post: (request: WorkRequest) => worker.postMessage(request),
    keepAlive: () => {},
    terminate: () => worker.terminate(),
  };
}

function fromFolder(assets: string): [string, CoreAddress] {
  const folder = new URL(assets.endsWith('/') ? assets : `${assets}/`, globalThis.location?.href).href;
  return [new URL('worker.mjs', folder).href, { wasmFolder: folder }];
}

/** Kept by the page: a worker that is started again needs them again. */
const blobs = new Map<Build, Promise<[string, CoreAddress]>>();

function fromBlobs(build: Build): Promise<[string, CoreAddress]> {
  const known = blobs.get(build) ?? makeBlobs(build);
  blobs.set(build, known);
  return known;
}

async function makeBlobs(build: Build): Promise<[string, CoreAddress]> {
  const texts = await (build === 'threads' ? import('payload:threads') : import('payload:single'));
  const { default: program } = await import('payload:worker');
  const [worker, glue] = [program, texts.glue].map((text) => addressOf(unpacked(text), 'text/javascript'));
  const wasm = addressOf(unpacked(texts.wasm), 'application/wasm');
  const addresses = {
    [`limber-${build}.mjs`]: await glue,
    [`limber-${build}.wasm`]: await wasm,
  };
  return [await worker, { wasmFolder: '', addresses }];
}

const addressOf = async (content: Promise<ArrayBuffer>, type: string): Promise<string> =>
  URL.createObjectURL(new Blob([await content], { type }));

/** The bytes that a text stands for: gzip in base64. */
function unpacked(text: string): Promise<ArrayBuffer> {
  const packed = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip'));
  return new Response(stream).arrayBuffer();
}
