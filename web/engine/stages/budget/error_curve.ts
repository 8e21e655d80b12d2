/** Stage: the deviation of a body by its number of faces, as estimated by the collapses. */

import type { History, Refused } from '../../core/core';
import { wholeEnds } from './deviation_limit';
import { historyStage } from '../history';
import { writtenFaces } from '../../body/layers';
import { preparedStage } from '../prepared';
import { declareStage } from '../stage';

/**
 * The largest estimate of all collapses so far (see History.errors), so that it never falls. Entry k is that after `ends[k]` collapses;
 * entry 0 is the original.
 */
export interface ErrorCurve {
  /** numbers of collapses that do not separate a collapse from its mirror image, ascending */
  ends: Uint32Array;
  /** faces of the level, descending */
  faces: Uint32Array;
  /** faces that are written for the level: with duplicate faces */
  written: Uint32Array;
  /** in units of the body, never falling */
  errors: Float64Array;
  /** of the body's bounding box */
  diagonal: number;
  /** why its last level has no fewer faces */
  refused: Refused;
}

export const errorCurveStage = declareStage({
  name: 'error curve',
  reads: [],
  needs: { prepared: preparedStage, history: historyStage },
  run: (_context, { prepared, history }): ErrorCurve => {
    const { layers, mesh } = prepared;
    const curve = errorCurve(history);
    const written = layers.most > 1 ? writtenFaces(layers, mesh, history, curve.ends) : curve.faces;
    return { ...curve, written, diagonal: prepared.diagonal, refused: history.refused };
  },
});

export function errorCurve(history: History): Pick<ErrorCurve, 'ends' | 'faces' | 'errors'> {
  const ends = Uint32Array.from(wholeEnds(history));
  const faces = new Uint32Array(ends.length);
  const errors = new Float64Array(ends.length);
  let [largest, done] = [0, 0];
  ends.forEach((end, k) => {
    for (; done < end; ++done) largest = Math.max(largest, history.errors?.[done] ?? 0);
    errors[k] = largest;
    faces[k] = end === 0 ? history.triangleCount : history.trianglesAfter[end - 1];
  });
  return { ends, faces, errors };
}

/** The number of collapses that are estimated to stay within `limit`, in units of the body. */
export function collapsesWithin(
  { ends, errors }: Pick<ErrorCurve, 'ends' | 'errors'>,
  limit: number,
): number {
  let [low, high] = [0, errors.length - 1];
  while (low < high) {
    const middle = Math.ceil((low + high) / 2);
    if (errors[middle] <= limit) low = middle;
    else high = middle - 1;
  }
  return ends[low];
}
