/** What is to be known of further levels of detail, in words. */

import { grouped } from '../core/words';

/** A level as it is written. */
export interface WrittenLevel {
  /** the name of its file, or the one that it would have */
  file: string;
  /** as they are in the file */
  faces: number;
}

/**
 * A sentence without its full stop for each further level that has more faces than the result itself. `lods`: what the reader knows the
 * setting of further levels as.
 */
export const describeFinerLevels = (faces: number, levels: readonly WrittenLevel[], lods: string): string[] =>
  levels
    .filter((level) => level.faces > faces)
    .map(
      ({ file, faces: own }) =>
        `${file}: a further level has ${grouped(own)} faces, and the result ${grouped(faces)}: give smaller shares of the original to ${lods}`,
    );
