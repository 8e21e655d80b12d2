/** What the built command line loads before it knows what there is to do. */

import { readFileSync } from 'node:fs';
import { expect, it } from 'vitest';

const folder = new URL('../../dist/cli/', import.meta.url);

/** The text of a chunk and of all that it imports before it runs. */
function textsOf(name: string, texts = new Map<string, string>()): Map<string, string> {
  if (texts.has(name)) return texts;
  const text = readFileSync(new URL(name, folder), 'utf8');
  texts.set(name, text);
  for (const [, next] of text.matchAll(/^(?:import|export)\b[^;]*?"\.\/([\w.-]+\.mjs)"/gm))
    textsOf(next, texts);
  return texts;
}

it('arguments are parsed and refused without loading the glTF reader and the stages', () => {
  const texts = textsOf('program.mjs');
  expect(texts.size).toBeGreaterThan(4);
  const all = [...texts.values()].join('');
  expect(all.length).toBeLessThan(200_000);
  expect(all).not.toContain('@gltf-transform');
  // So that the bound says something.
  const work = [...textsOf('optimize.mjs').values()].join('');
  expect(work.length).toBeGreaterThan(400_000);
});
