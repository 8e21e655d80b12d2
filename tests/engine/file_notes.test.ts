// Each note of the readers on a file has a Japanese sentence, with its numbers and names.

import { afterEach, beforeEach, expect, test } from 'vitest';
import { JAPANESE } from '../../web/app/language/japanese/table';
import { shown } from '../../web/app/language/language';
import { sentence } from '../../web/app/language/say';
import { describeMissing } from '../../web/engine/document/checks/companions';
import { describeFallbacks } from '../../web/engine/document/checks/fallback_images';
import { withoutImageless } from '../../web/engine/document/checks/imageless';
import { Omissions } from '../../web/engine/document/formats/obj/omissions';
import { readObj } from '../../web/engine/document/obj';

beforeEach(() => {
  shown.value = { language: 'ja', table: JAPANESE };
});
afterEach(() => {
  shown.value = { language: 'en', table: {} };
});

/** Names that stay as they are: of files, formats and statements. */
const NAMES = /glTF|PNG|JPEG|OBJ|UTF-8|MB|norm|map_\w+|\w+\.(png|mtl)/g;

/** Fails for a note that is shown in English, whole or in part. */
function expectJapanese(notes: string[]): void {
  expect(notes).not.toEqual([]);
  for (const note of notes) expect(sentence(note).replaceAll(NAMES, '')).not.toMatch(/[A-Za-z]{2}/);
}

test.each([
  '1 material',
  '2 materials with 1 texture',
  '2 morph targets',
  '1 camera',
  '2 further scenes',
  '1 primitive of points or lines',
  'further sets of UVs (TEXCOORD_1)',
  'attribute _WIND',
  'extension KHR_lights_punctual',
])('what a format cannot hold: %s', (note) => {
  const words = sentence(note)
    .replace('TEXCOORD_1', '')
    .replace(/_WIND|KHR\w+|UV/, '');
  expect(words).not.toMatch(/[a-z]/i);
});

test.each(['missing', 'format', 'heights', 'opacity', 'metal', 'undefined', 'library'] as const)(
  'materials of OBJ: %s',
  (kind) => {
    const omissions = new Omissions();
    omissions.add(kind, 'a.png');
    expectJapanese(omissions.notes());
    for (const name of 'bcdefg') omissions.add(kind, `${name}.png`);
    expectJapanese(omissions.notes());
  },
);

test.each([[['a.mtl']], [['a.mtl', 'b.mtl']], [['../a.mtl']], [['../a.mtl', 'b.mtl']]])(
  'libraries of OBJ that are not there: %s',
  (names) => {
    const omissions = new Omissions();
    omissions.addMissingLibraries(names);
    expectJapanese(omissions.notes());
  },
);

test.each([
  ['f 1 2 3 4', ''],
  ['f 1 2 3', 'l 1 2'],
  ['f 1 2 3', 'p 1\np 2'],
  ['f 1 2 3', 'nonsense 1'],
  ['f 1 2 3', 'nonsense 1\nnonsense 2'],
  ['f 1 2 3', 'f 1 2'],
])('lines of OBJ: %j %j', (face, line) => {
  const text = `v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n${face}\n${line}\n`;
  const { surfaces, notes } = readObj({ name: 'a.obj', bytes: new TextEncoder().encode(text) });
  expectJapanese([...notes, ...surfaces.flatMap((surface) => surface.notes)]);
});

test.each([1, 2])('textures of glTF, %i', (count) => {
  const pictures = Array.from({ length: count }, (_, i) => `${i}.png`);
  expectJapanese(describeMissing(pictures));
  const textures = pictures.map(() => ({}));
  const materials = pictures.map((_, index) => ({ normalTexture: { index } }));
  const asset = { version: '2.0' };
  expectJapanese(withoutImageless({ asset, textures, materials }).notes);
  const webp = { source: 0, extensions: { EXT_texture_webp: { source: 1 } } };
  expectJapanese(describeFallbacks({ asset, textures: pictures.map(() => webp) }));
});
