/** Lines of a material library that name a picture: options, and a file name that may have blanks. */

export interface MtlMap {
  /** as the library has it, with slashes between folders and without quotes */
  name: string;
  /** of the UVs, which count from the lower left corner: scale * uv + offset */
  scale: [u: number, v: number];
  offset: [u: number, v: number];
  /** of bumps and normals */
  strength: number;
  /** whether the picture is not repeated */
  isClamped: boolean;
}

/** What follows an option: exactly one word, or up to a number of numbers. */
const WORDS_OF = new Map<string, { word: true } | { numbers: number }>([
  ...['-blendu', '-blendv', '-cc', '-clamp', '-colorspace', '-imfchan', '-type'].map(
    (option) => [option, { word: true }] as const,
  ),
  ...['-bm', '-boost', '-texres'].map((option) => [option, { numbers: 1 }] as const),
  ['-mm', { numbers: 2 }],
  ...['-o', '-s', '-t'].map((option) => [option, { numbers: 3 }] as const),
]);

const NUMBER = /^[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?$/;

/** The most characters that are read of a line; no path is longer. */
const MAX_LETTERS = 1 << 13;

/** The rest of a line after its keyword; options may stand on either side of the name. */
export function readMap(rest: string): MtlMap {
  const line = rest.slice(0, MAX_LETTERS);
  const words = [...line.matchAll(/\S+/g)];
  const options = new Map<string, string[]>();
  const named: RegExpExecArray[] = [];
  let isNamed = false;
  for (let i = 0; i < words.length; ++i) {
    const option = words[i][0].toLowerCase();
    const given = argumentsOf(option, words.slice(i + 1, i + 4));
    if (given) {
      options.set(option, given);
      i += given.length;
      isNamed = named.length > 0;
    } else if (!isNamed) named.push(words[i]);
  }
  return { name: nameOf(line, named), ...valuesOf(options) };
}

/** The words of an option among those that follow it; null where it is none. */
function argumentsOf(option: string, following: RegExpExecArray[]): string[] | null {
  const form = WORDS_OF.get(option);
  if (!form) return null;
  const words = following.map(([word]) => word);
  if ('word' in form) return words.slice(0, 1);
  const other = words.findIndex((word) => !NUMBER.test(word));
  return words.slice(0, Math.min(form.numbers, other < 0 ? words.length : other));
}

/** The file name, with the blanks between its words. */
function nameOf(line: string, words: RegExpExecArray[]): string {
  if (words.length === 0) return '';
  const last = words[words.length - 1];
  const name = line.slice(words[0].index, last.index + last[0].length);
  return name.replaceAll('"', '').replaceAll('\\', '/').trim();
}

function valuesOf(options: Map<string, string[]>): Omit<MtlMap, 'name'> {
  const number = (option: string, i: number, otherwise: number): number => {
    const value = Number(options.get(option)?.[i] ?? NaN);
    return Number.isFinite(Math.fround(value)) ? value : otherwise;
  };
  return {
    scale: [number('-s', 0, 1), number('-s', 1, 1)],
    offset: [number('-o', 0, 0), number('-o', 1, 0)],
    strength: number('-bm', 0, 1),
    isClamped: options.get('-clamp')?.[0]?.toLowerCase() === 'on',
  };
}
