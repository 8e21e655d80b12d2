/** The header of a PLY file: the elements that follow, and their encoding. */

import type { SourceFile } from './model';
import { excerpt, TextScanner } from './text_scanner';

export type PlyType = 'int8' | 'uint8' | 'int16' | 'uint16' | 'int32' | 'uint32' | 'float32' | 'float64';

export interface PlyProperty {
  name: string;
  type: PlyType;
  /** type of the length of a list; absent for other properties */
  countType?: PlyType;
}

export interface PlyElement {
  name: string;
  count: number;
  properties: PlyProperty[];
}

export interface PlyHeader {
  encoding: 'ascii' | 'little' | 'big';
  elements: PlyElement[];
  /** byte offset of the data after the header, and their line */
  bodyAt: number;
  bodyLine: number;
}

const ENCODINGS: Record<string, PlyHeader['encoding']> = {
  ascii: 'ascii',
  binary_little_endian: 'little',
  binary_big_endian: 'big',
};

const TYPES: Record<string, PlyType> = {
  char: 'int8',
  uchar: 'uint8',
  short: 'int16',
  ushort: 'uint16',
  int: 'int32',
  uint: 'uint32',
  float: 'float32',
  double: 'float64',
  int8: 'int8',
  uint8: 'uint8',
  int16: 'int16',
  uint16: 'uint16',
  int32: 'int32',
  uint32: 'uint32',
  float32: 'float32',
  float64: 'float64',
};

/** Throws an Error that names the line. */
export function readPlyHeader(file: SourceFile): PlyHeader {
  const scan = new TextScanner(file.name, file.bytes);
  if (scan.word() !== 'ply') scan.fail('a PLY file starts with "ply": export it again');
  scan.nextLine();
  let encoding: PlyHeader['encoding'] | undefined;
  const elements: PlyElement[] = [];
  for (let word = scan.word(); word !== 'end_header'; word = scan.word()) {
    if (word === 'format') encoding = readEncoding(scan);
    else if (word === 'element') elements.push(readElement(scan));
    else if (word === 'property') readProperty(scan, elements);
    else if (!['comment', 'obj_info', ''].includes(word)) scan.fail(`"${excerpt(word)}" is not PLY`);
    if (scan.atEnd) scan.fail('the header has no end_header: export it again');
    scan.nextLine();
  }
  scan.nextLine();
  if (!encoding) throw new Error(`${file.name}: the header has no format line: export it again.`);
  return { encoding, elements, bodyAt: scan.at, bodyLine: scan.line };
}

function readEncoding(scan: TextScanner): PlyHeader['encoding'] {
  const word = scan.word();
  if (Object.hasOwn(ENCODINGS, word)) return ENCODINGS[word];
  return scan.fail(`the format "${excerpt(word)}" is not one of ${Object.keys(ENCODINGS).join(', ')}`);
}

function readElement(scan: TextScanner): PlyElement {
  const name = scan.word();
  const count = scan.number(`the count of ${excerpt(name)}`);
  if (!Number.isInteger(count) || count < 0) scan.fail(`${count} is not a count`);
  return { name, count, properties: [] };
}

function readProperty(scan: TextScanner, elements: PlyElement[]): void {
  const element = elements[elements.length - 1] ?? scan.fail('a property comes before any element');
  const word = scan.word();
  if (word !== 'list') {
    element.properties.push({ type: typeNamed(scan, word), name: scan.word() });
    return;
  }
  const countType = typeNamed(scan, scan.word());
  element.properties.push({ countType, type: typeNamed(scan, scan.word()), name: scan.word() });
}

function typeNamed(scan: TextScanner, word: string): PlyType {
  return Object.hasOwn(TYPES, word) ? TYPES[word] : scan.fail(`"${excerpt(word)}" is not a PLY type`);
}
