/** Data URIs (RFC 2397): the reader supports only those in base64. */

import type { GLTF } from '@gltf-transform/core';

/** The JSON with all data of buffers and images in base64. */
export const inBase64 = (json: GLTF.IGLTF): GLTF.IGLTF => ({
  ...json,
  ...(json.buffers ? { buffers: json.buffers.map(withBase64) } : {}),
  ...(json.images ? { images: json.images.map(withBase64) } : {}),
});

function withBase64<One extends { uri?: string }>(one: One): One {
  const { uri } = one;
  if (typeof uri !== 'string' || !/^data:/i.test(uri)) return one;
  const comma = uri.indexOf(',');
  const [head, data] = [uri.slice('data:'.length, comma), uri.slice(comma + 1)];
  if (comma < 0 || head.endsWith(';base64')) return one;
  const type = head.replace(/;base64$/i, '');
  const isEncoded = type !== head;
  return { ...one, uri: `data:${type};base64,${isEncoded ? data : btoa(bytesOf(data))}` };
}

/** A character for each byte of a percent-encoded text. */
const bytesOf = (text: string): string =>
  text
    .replace(/%([0-9a-f]{2})/gi, (_, digits: string) => String.fromCharCode(parseInt(digits, 16)))
    .replace(/[^\0-\xff]/g, '?');
