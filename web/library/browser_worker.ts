/**
 * The worker in browsers. Its program and the core are texts in modules of the package, which every bundler understands, and
 * are started from blobs; with `assets` they are loaded from a folder of the page instead.
 */

import { LimberError } from './options';
import { SERVE_ASSETS } from './protocol';
import type { CoreAddress, Listener, StartedWorker, WorkMessage, WorkRequest } from './protocol';

type Build = 'single' | 'threads';

export async function startBrowserWorker(
  listener: Listener,
  { assets, threads }: { assets: string | null; threads: number },
): Promise<StartedWorker> {
  // Memory is shared in pages that are isolated from other origins; elsewhere the core has one thread.
  const build: Build = threads !== 1 && typeof SharedArrayBuffer !== 'undefined' ? 'threads' : 'single';
  const [program, core] = assets === null ? await fromBlobs(build) : fromFolder(assets);
  const refusal = assets === null ? BLOB_REFUSED : `${program} cannot be started: ${SERVE_ASSETS}`;
  const worker = new Worker(program, { type: 'module', name: 'limber' });
  worker.addEventListener('message', ({ data }: MessageEvent<WorkMessage>) => listener.onMessage(data));
  // An error in the program of the worker has a message, one in loading it has none.
  worker.addEventListener('error', ({ message }) =>
    listener.onError(message ? new Error(message) : new LimberError(refusal)),
  );
  return {
    core,
    post: (request: WorkRequest) => worker.postMessage(request),
    keepAlive: () => {},
    terminate: () => worker.terminate(),
  };
}

const BLOB_REFUSED =
  'The worker cannot be started from a blob, which the content security policy of the page may forbid: name a folder with the files of limber/assets as "assets".';

function fromFolder(assets: string): [string, CoreAddress] {
  const { protocol, href } = globalThis.location;
  // A caller that was started from a blob has no folder.
  const base = protocol === 'blob:' ? globalThis.origin : href;
  const folder = new URL(assets.endsWith('/') ? assets : `${assets}/`, base).href;
  return [new URL('worker.js', folder).href, { wasmFolder: folder }];
}

/** Kept by the page: a worker that is started again needs them again. */
const blobs = new Map<Build, Promise<[string, CoreAddress]>>();

function fromBlobs(build: Build): Promise<[string, CoreAddress]> {
  const known = blobs.get(build) ?? makeBlobs(build);
  blobs.set(build, known);
  // A part that could not be loaded is requested again by the next call.
  known.catch(() => blobs.delete(build));
  return known;
}

async function makeBlobs(build: Build): Promise<[string, CoreAddress]> {
  const texts = await (build === 'threads' ? import('payload:threads') : import('payload:single'));
  const { default: program } = await import('payload:worker');
  const [worker, glue] = [program, texts.glue].map((text) => addressOf(unpacked(text), 'text/javascript'));
  const wasm = addressOf(unpacked(texts.wasm), 'application/wasm');
  const addresses = {
    [`limber-${build}.js`]: await glue,
    [`limber-${build}.wasm`]: await wasm,
  };
  return [await worker, { wasmFolder: '', addresses }];
}

const addressOf = async (content: Promise<ArrayBuffer>, type: string): Promise<string> =>
  URL.createObjectURL(new Blob([await content], { type }));

/** Decodes a text: gzip in base64. */
function unpacked(text: string): Promise<ArrayBuffer> {
  const packed = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip'));
  return new Response(stream).arrayBuffer();
}
