/** Which corners of a result get the normals of their sources, and which get normals computed from faces. */

import type { Accessor, Primitive } from '@gltf-transform/core';
import type { CornerSources, TriangleMesh } from '../../core/core';
import type { Body, PrimitiveSpan } from '../model';
import { ALL_HARD } from './normals';
import type { ResultNormals } from './normals';
import { CARRIED, isUntouched, wholeShare } from '../vertices';
import type { PrimitiveGeometry } from '../vertices';

/** The fields of an ExportedBody that normals follow from. */
interface Shaded {
  body: Body;
  mesh: TriangleMesh;
  inputOfTriangle: Uint32Array;
  sources: CornerSources | null;
  hardCosine: number | null;
}

/**
 * Per corner: CARRIED if its normal comes from its source or it has none, otherwise the key of a computed normal. `smoothed`:
 * primitives without normals get smooth ones.
 */
export function normalKeys(
  primitive: Primitive,
  span: PrimitiveSpan,
  { body, inputOfTriangle, sources, hardCosine }: Shaded,
  { normals, smoothed }: { normals: ResultNormals; smoothed: boolean },
): (corner: number) => number {
  const accessor = primitive.getAttribute('NORMAL');
  if (!accessor && smoothed) return (corner) => normals.smoothKey(corner);
  if (!accessor || !sources || hardCosine === null) return () => CARRIED;
  return (corner) => {
    const t = Math.floor(corner / 3);
    const source = inputOfTriangle[t];
    // The corners of a recut quad have normals of two faces.
    const isAsItWas = isUntouched(sources, t, source) && !body.recut?.[source];
    if (isAsItWas) return CARRIED;
    const key = normals.smoothKey(corner);
    if (hardCosine === ALL_HARD) return key;
    const whole = wholeShare(sources.barycentric, corner);
    if (whole < 0) return key;
    const vertex = body.indices[3 * sources.triangle[corner] + whole] - span.firstVertex;
    return isOnSameSide(accessor.getElement(vertex, []), key, normals) ? CARRIED : key;
  };
}

/**
 * Normals as floats: carried where `normalKey` says so, or where the carried one comes from the same side of all hard edges as
 * the computed one; otherwise computed.
 */
export function normalsOf(
  carried: Accessor | null,
  { normalKey }: PrimitiveGeometry,
  normals: ResultNormals,
): Float32Array<ArrayBuffer> {
  const written = new Float32Array(3 * normalKey.length);
  normalKey.forEach((key, i) => {
    const own = carried?.getElement(i, []);
    const keepsOwn = own && (key === CARRIED || isOnSameSide(own, key, normals));
    written.set(keepsOwn ? own : normals.at(key), 3 * i);
  });
  return written;
}

/** Whether a carried normal is within the angle of hard edges of the computed one: beyond it a hard edge lies between them. */
function isOnSameSide(carried: number[], key: number, normals: ResultNormals): boolean {
  const computed = normals.at(key);
  const cosine = carried[0] * computed[0] + carried[1] * computed[1] + carried[2] * computed[2];
  return cosine >= normals.hardCosine;
}
