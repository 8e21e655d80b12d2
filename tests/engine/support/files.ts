/** Tiny input files, and errors about them. */

import type { SourceFile } from '../../../web/engine/document/open';

export function textFile(name: string, text: string): SourceFile {
  return { name, bytes: new TextEncoder().encode(text) };
}

/** A unit square of two triangles as OBJ lines. */
export const SQUARE_OBJ = 'v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n';

/** The message of the Error that `run` throws or rejects with; '' if there is none. */
export async function failureOf(run: () => unknown): Promise<string> {
  try {
    await run();
  } catch (error) {
    return (error as Error).message;
  }
  return '';
}
