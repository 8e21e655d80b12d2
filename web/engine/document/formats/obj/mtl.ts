/** Reads material libraries of OBJ files (MTL), with the PBR keywords that Blender and other programs write. */

import type { SourceFile } from '../../model';
import { TextScanner } from '../../text_scanner';
import { readMap } from './mtl_map';
import type { MtlMap } from './mtl_map';

export type Rgb = [red: number, green: number, blue: number];

/** Values by keyword in lower case, as far as they are numbers. */
export interface MtlMaterial {
  /** not negative; linear light, see docs/formats.md */
  colours: Map<string, Rgb>;
  numbers: Map<string, number>;
  /** maps; of several lines with one keyword the first */
  maps: Map<string, MtlMap>;
}

const COLOURS = new Set(['kd', 'ks', 'ke']);
const NUMBERS = new Set(['ns', 'd', 'tr', 'pr', 'pm', 'illum']);
/** The limit on the pictures of a library, each of which is searched for. */
const MAX_PICTURES = 10_000;
const MAP = /^(map_|bump$|norm|disp|decal|refl)/;

/**
 * The materials with these names that the library defines; of several with one name the first. Throws an Error with one sentence
 * where the text is not UTF-8.
 */
export function readMtl({ name, bytes }: SourceFile, wanted: ReadonlySet<string>): Map<string, MtlMaterial> {
  const scan = new TextScanner(name, bytes);
  const materials = new Map<string, MtlMaterial>();
  let material: MtlMaterial | null = null;
  for (; !scan.atEnd; scan.nextLine()) {
    const keyword = scan.word().toLowerCase();
    if (keyword === 'newmtl') {
      const own = scan.rest();
      material = wanted.has(own) && !materials.has(own) ? emptyMaterial() : null;
      if (material) materials.set(own, material);
    } else if (material) readLine(material, keyword, scan);
  }
  return materials;
}

/** The pictures that the library names for any use, at most MAX_PICTURES. Throws as `readMtl` does. */
export function picturesNamed({ name, bytes }: SourceFile): string[] {
  const scan = new TextScanner(name, bytes);
  const lines = new Set<string>();
  for (; !scan.atEnd && lines.size < MAX_PICTURES; scan.nextLine())
    if (MAP.test(scan.word().toLowerCase())) lines.add(scan.rest());
  return [...new Set([...lines].map((line) => readMap(line).name))].filter((own) => own !== '');
}

const emptyMaterial = (): MtlMaterial => ({ colours: new Map(), numbers: new Map(), maps: new Map() });

function readLine({ colours, numbers, maps }: MtlMaterial, keyword: string, scan: TextScanner): void {
  if (COLOURS.has(keyword)) {
    const colour = readColour(scan);
    if (colour) colours.set(keyword, colour);
  } else if (NUMBERS.has(keyword)) {
    const value = readNumber(scan);
    if (Number.isFinite(value)) numbers.set(keyword, value);
  } else if (MAP.test(keyword) && !maps.has(keyword)) {
    const map = readMap(scan.rest());
    if (map.name !== '') maps.set(keyword, map);
  }
}

/** A word before the number, as in `d -halo 0.5`, is skipped. */
function readNumber(scan: TextScanner): number {
  const value = scan.numberOrNaN();
  return Number.isNaN(value) ? scan.numberOrNaN() : value;
}

/** One number stands for all three; null for a spectral curve or CIE XYZ, which are not read. */
function readColour(scan: TextScanner): Rgb | null {
  const red = scan.numberOrNaN();
  const [green, blue] = [scan.numberOrNaN(), scan.numberOrNaN()];
  const colour: Rgb = [red, ...(Number.isNaN(green) ? ([red, red] as const) : ([green, blue] as const))];
  return colour.every(Number.isFinite) ? (colour.map((value) => Math.max(0, value)) as Rgb) : null;
}
