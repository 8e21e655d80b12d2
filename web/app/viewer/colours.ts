/** Perceptually uniform colour maps. */

import { interpolateCividis, interpolateViridis } from 'd3-scale-chromatic';
import { DataTexture, LinearFilter, SRGBColorSpace } from 'three';

export type MapName = 'viridis' | 'cividis';

const MAPS: Record<MapName, (t: number) => string> = {
  viridis: interpolateViridis,
  cividis: interpolateCividis,
};

/** The colour at `t` in [0, 1] as CSS. */
export const colourAt = (map: MapName, t: number): string => MAPS[map](Math.min(1, Math.max(0, t)));

/** A CSS gradient from low to high. */
export function gradient(map: MapName): string {
  const stops = Array.from({ length: 11 }, (_, i) => colourAt(map, i / 10));
  return `linear-gradient(to right, ${stops.join(', ')})`;
}

/** The map as a texture, 256 x 1. */
export function mapTexture(map: MapName): DataTexture {
  const size = 256;
  const data = new Uint8Array(4 * size);
  for (let i = 0; i < size; i++) {
    const [r, g, b] = channels(colourAt(map, i / (size - 1)));
    data.set([r, g, b, 255], 4 * i);
  }
  const texture = new DataTexture(data, size, 1);
  texture.colorSpace = SRGBColorSpace;
  texture.minFilter = LinearFilter;
  texture.magFilter = LinearFilter;
  texture.needsUpdate = true;
  return texture;
}

/** Red, green and blue of "rgb(68, 1, 84)" or "#440154". */
function channels(css: string): [number, number, number] {
  const numbers = css.match(/\d+/g);
  if (css.startsWith('rgb') && numbers) return [Number(numbers[0]), Number(numbers[1]), Number(numbers[2])];
  const hex = Number.parseInt(css.slice(1), 16);
  return [(hex >> 16) & 255, (hex >> 8) & 255, hex & 255];
}
