/** Changes a valid input into one that a reader has never seen. */

import type { Choices } from './choices';

/** Numbers at which code tends to break, as text. */
const NUMBERS =
  '0 -0 1 -1 2 3 255 256 65535 65536 2147483647 2147483648 4294967295 4294967296 9007199254740993 1e-30 1e30 1e39 1e308 1e999 -1e999 NaN Infinity .5 1. 1e 0x10 1_000 ١'.split(
    ' ',
  );
/** Words and characters that mean something to one of the readers. */
const WORDS = [
  '',
  ' ',
  '\n',
  '\r',
  '\t',
  '\0',
  '\uFEFF',
  '#',
  '\\',
  '\\\n',
  '/',
  '//',
  '-',
  '+',
  '=',
  ',',
  ';',
  ':',
  '*',
  '?',
  '|',
  '"',
  "'",
  '{}',
  '[]',
  'null',
  'true',
  '__proto__',
  'constructor',
  'toString',
  '../',
  'data:,',
  'v',
  'f',
  'vn',
  'vt',
  'usemtl',
  'list',
  'uchar',
  'double',
  'element',
  'property',
  'endsolid',
  '😀',
];

const text = (bytes: Uint8Array) => String.fromCharCode(...bytes.subarray(0, 60_000));
const bytesOf = (words: string) => Uint8Array.from(words, (letter) => letter.charCodeAt(0) & 255);

/** Replaces, inserts, removes or repeats a stretch of bytes. */
function mutateBytes(bytes: Uint8Array, choices: Choices): Uint8Array {
  if (bytes.length === 0) return Uint8Array.of(choices.below(256));
  const at = choices.below(bytes.length);
  const end = Math.min(bytes.length, at + 1 + choices.below(choices.pick([1, 4, 16, 256])));
  switch (choices.below(5)) {
    case 0: {
      const changed = bytes.slice();
      changed[at] ^= 1 << choices.below(8);
      return changed;
    }
    case 1: {
      const changed = bytes.slice();
      for (let i = at; i < Math.min(at + 4, bytes.length); ++i) changed[i] = choices.pick([0, 255, 127, 128]);
      return changed;
    }
    case 2:
      return joined(bytes.subarray(0, at), bytes.subarray(end));
    case 3:
      return joined(bytes.subarray(0, end), bytes.subarray(at));
    default:
      return bytes.slice(0, at);
  }
}

function joined(...parts: Uint8Array[]): Uint8Array {
  const whole = new Uint8Array(parts.reduce((length, part) => length + part.length, 0));
  let at = 0;
  for (const part of parts) {
    whole.set(part, at);
    at += part.length;
  }
  return whole;
}

/** Replaces, inserts, removes, repeats or swaps words of a text. */
export function mutateText(words: string, choices: Choices): string {
  const tokens = words.match(/[\w.+-]+|\s+|./gsu) ?? [''];
  const at = choices.below(tokens.length);
  const other = choices.below(tokens.length);
  switch (choices.below(6)) {
    case 0:
      tokens[at] = choices.pick(NUMBERS);
      break;
    case 1:
      tokens[at] = choices.pick(WORDS);
      break;
    case 2:
      tokens.splice(at, 0, choices.pick(WORDS));
      break;
    case 3:
      tokens.splice(at, 1 + choices.below(8));
      break;
    case 4:
      tokens.splice(at, 0, ...tokens.slice(other, other + 1 + choices.below(20)));
      break;
    default:
      [tokens[at], tokens[other]] = [tokens[other], tokens[at]];
  }
  return tokens.join('');
}

/** JSON after so many changes. */
export function mutateJson(json: unknown, times: number, choices: Choices): unknown {
  let changed = json;
  for (let left = times; left > 0; --left) changed = mutateValue(changed, choices);
  return changed;
}

/** The text of JSON after so many changes to its values and, sometimes, one to its words. */
export function mutatedJsonText(json: unknown, times: number, choices: Choices): string {
  const words = JSON.stringify(mutateJson(json, times, choices));
  return choices.chance(0.3) ? mutateText(words, choices) : words;
}

/** A word of the given letters, shorter than `end`. */
export function anyWord(letters: readonly string[], end: number, choices: Choices): string {
  return Array.from({ length: choices.below(end) }, () => choices.pick(letters)).join('');
}

/** A value of JSON replaced by one of another kind, or a key removed or renamed. */
function mutateValue(json: unknown, choices: Choices): unknown {
  const copy: unknown = structuredClone(json);
  const places: { owner: Record<string, unknown>; key: string }[] = [];
  const visit = (value: unknown) => {
    if (value === null || typeof value !== 'object') return;
    const owner = value as Record<string, unknown>;
    for (const key of Object.keys(owner)) {
      places.push({ owner, key });
      visit(owner[key]);
    }
  };
  visit(copy);
  if (places.length === 0) return copy;
  const { owner, key } = choices.pick(places);
  const values = [null, true, -1, 0, 1.5, 1e9, 2 ** 32, 1e308, '', 'x', [], {}, [0], [[]], { a: 1 }];
  if (choices.chance(0.2)) delete owner[key];
  else if (choices.chance(0.2)) owner[key] = structuredClone(choices.pick(places).owner);
  else if (choices.chance(0.3) && typeof owner[key] === 'number')
    owner[key] = (owner[key] as number) + choices.below(9) - 4;
  else owner[key] = choices.pick(values);
  return copy;
}

/** Between one and eight changes to the bytes of a file, by what the bytes are. */
export function mutateFile(bytes: Uint8Array, choices: Choices, isText: boolean): Uint8Array {
  let changed = bytes;
  for (let left = 1 + choices.below(choices.pick([1, 2, 8])); left > 0; --left)
    changed =
      isText && choices.chance(0.8)
        ? bytesOf(mutateText(text(changed), choices))
        : mutateBytes(changed, choices);
  return changed;
}

/** The JSON of a GLB and the chunk of its buffer, which begins with a header of 8 bytes. */
export function partsOfGlb(glb: Uint8Array): { json: unknown; chunk: Uint8Array } {
  const length = new DataView(glb.buffer, glb.byteOffset, glb.byteLength).getUint32(12, true);
  return { json: JSON.parse(text(glb.subarray(20, 20 + length))), chunk: glb.subarray(20 + length) };
}

/** A GLB whose JSON is changed, with lengths that agree with it. */
export function mutateGlbJson(glb: Uint8Array, choices: Choices): Uint8Array {
  const { json, chunk } = partsOfGlb(glb);
  const words = bytesOf(JSON.stringify(mutateJson(json, 1 + choices.below(3), choices)));
  const padded = new Uint8Array(Math.ceil(words.length / 4) * 4).fill(32);
  padded.set(words);
  const header = new DataView(new ArrayBuffer(20));
  [0x46546c67, 2, 20 + padded.length + chunk.length, padded.length, 0x4e4f534a].forEach((word, i) =>
    header.setUint32(4 * i, word, true),
  );
  return joined(new Uint8Array(header.buffer), padded, chunk);
}
