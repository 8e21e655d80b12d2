/** Warnings about further levels of detail. */

import { grouped } from '../core/words';

/** A written level. */
export interface WrittenLevel {
  /** the name of its file, or the one that it would have */
  file: string;
  /** the number of faces in the file */
  faces: number;
}

/**
 * A sentence without its full stop for each further level that has more faces than the result itself. `lods`: the reader's name for the
 * setting of further levels.
 */
export const describeFinerLevels = (faces: number, levels: readonly WrittenLevel[], lods: string): string[] =>
  levels
    .filter((level) => level.faces > faces)
    .map(
      ({ file, faces: own }) =>
        `${file}: a further level has ${grouped(own)} faces, more than the ${grouped(faces)} of the result: give ${lods} smaller shares of the original`,
    );
