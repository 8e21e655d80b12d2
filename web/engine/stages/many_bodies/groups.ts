/** Groups of small bodies that are run together. */

import type { Core } from '../../core/core';
import { vertexCount } from '../../core/mesh';
import type { FileRun } from '../file_run';
import { preparedStage } from '../prepared';
import type { RunSettings } from '../stage';

export type Usable = FileRun['usable'];

/**
 * A body with more vertices gets all threads for itself. On two threads, half of this limit takes 35 % longer for bodies of 3000 vertices, and twice
 * this limit, with groups of twice the size, saves 27 % for bodies of 6000.
 */
const MAX_VERTICES = 4000;
/**
 * The vertices of a group, few enough that progress is visible and cancelling loses little. Half of it takes 7 % longer for 2000 bodies of 68 vertices
 * and 39 % for bodies of 3000; twice as much changes times by less than 9 %.
 */
const GROUP_VERTICES = 8000;

/** Small bodies that follow each other, together; all others alone. */
export function groupsOf(core: Core, some: Usable, settingsOf: (i: number) => RunSettings): Usable[] {
  const groups: Usable[] = [];
  let room = 0;
  for (const usable of some) {
    const size = vertexCount(usable.run.get(preparedStage, settingsOf(usable.i)).mesh);
    const isSmall = core.threads > 1 && size <= MAX_VERTICES;
    if (isSmall && size <= room) {
      groups[groups.length - 1].push(usable);
      room -= size;
    } else {
      groups.push([usable]);
      room = isSmall ? GROUP_VERTICES - size : 0;
    }
  }
  return groups;
}
