/** Converts normals, UVs and colours of formats without a scene to glTF's conventions. */

import { length3 } from '../core/exact_math';
import type { SurfaceAttributes } from './surface';

/** Attributes as read: normals of any length, UVs from the lower left corner, sRGB colours in [0, 1]. */
export interface RawAttributes {
  /** normals[3 * v + c] */
  normals?: Float32Array;
  /** uvs[2 * v + c] */
  uvs?: Float32Array;
  /** colours[3 * v + c] */
  colours?: Float32Array;
  /** opacities[v] in [0, 1], of vertices that have colours */
  opacities?: Float32Array;
}

/** Drops the normals if one that `indices` uses has no direction; UVs and colours that are not finite become 0, opacities 1. */
export function attributesOfRaw(
  { normals, uvs, colours, opacities }: RawAttributes,
  indices: Uint32Array,
): SurfaceAttributes {
  const unit = normals ? unitNormals(normals, indices) : null;
  return {
    ...(unit ? { NORMAL: unit } : {}),
    ...(uvs ? { TEXCOORD_0: uvs.map((value, i) => (i % 2 === 0 ? finite(value) : 1 - finite(value))) } : {}),
    ...(colours ? { COLOR_0: coloursOf(colours, opacities) } : {}),
  };
}

const finite = (value: number): number => (Number.isFinite(value) ? value : 0);

function unitNormals(normals: Float32Array, indices: Uint32Array): Float32Array | null {
  const unit = new Float32Array(normals.length);
  const isUsed = new Uint8Array(normals.length / 3);
  for (const vertex of indices) isUsed[vertex] = 1;
  for (let v = 0; v < isUsed.length; ++v) {
    const [x, y, z] = normals.subarray(3 * v, 3 * v + 3);
    const length = length3(x, y, z);
    if (length > 0 && Number.isFinite(length)) unit.set([x / length, y / length, z / length], 3 * v);
    else if (isUsed[v]) return null;
    else unit[3 * v + 2] = 1;
  }
  return unit;
}

/** Three numbers for each vertex, or four where it has an opacity. */
function coloursOf(colours: Float32Array, opacities: Float32Array | undefined): Uint16Array {
  const linear = Uint16Array.from(colours, linearOf);
  if (!opacities) return linear;
  const all = new Uint16Array(4 * opacities.length);
  opacities.forEach((opacity, v) => {
    all.set(linear.subarray(3 * v, 3 * v + 3), 4 * v);
    all[4 * v + 3] = Math.round(65535 * Math.min(1, Math.max(0, Number.isFinite(opacity) ? opacity : 1)));
  });
  return all;
}

/** sRGB to linear light (IEC 61966-2-1). Rounding to 16 bits hides differences in `**` between JavaScript engines. */
function linearOf(value: number): number {
  const clamped = Math.min(1, Math.max(0, finite(value)));
  const linear = clamped <= 0.04045 ? clamped / 12.92 : ((clamped + 0.055) / 1.055) ** 2.4;
  return Math.round(65535 * linear);
}
