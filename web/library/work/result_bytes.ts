/** Bytes of results in memory of their own, whatever memory the caller gave the model in. */

import type { SourceFile } from '../../engine/document/open';
import type { ResultBytes, ResultFile } from '../options';

export const resultBytes = (bytes: Uint8Array): ResultBytes =>
  bytes.buffer instanceof ArrayBuffer ? (bytes as ResultBytes) : bytes.slice();

export const resultFiles = (files: SourceFile[]): ResultFile[] =>
  files.map(({ name, bytes }) => ({ name, bytes: resultBytes(bytes) }));
