// The headers of the page. `npm start` sends them; on hosts that send none, the service worker adds them.

/** Shared memory needs a cross-origin isolated page; without these headers the core runs on one thread. */
const isolation = {
  'Cross-Origin-Opener-Policy': 'same-origin',
  'Cross-Origin-Embedder-Policy': 'require-corp',
  'Cross-Origin-Resource-Policy': 'same-origin',
};

/** The content security policy. Scripts only come from the page's own files, and none is created from text. */
export const policy = [
  "default-src 'self'",
  "script-src 'self' 'wasm-unsafe-eval'",
  "style-src 'self'",
  "img-src 'self' data: blob:",
  "media-src 'self' blob:",
  "connect-src 'self' data: blob:",
  "worker-src 'self'",
  "object-src 'none'",
  "base-uri 'none'",
  "form-action 'none'",
].join('; ');

export const headers = { ...isolation, 'Content-Security-Policy': policy };

/** The module reloading of the development server needs inline scripts, so it sends no policy. */
export const developmentHeaders = isolation;
