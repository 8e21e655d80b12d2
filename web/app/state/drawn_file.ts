/** The files that the stage can draw with their materials. */

import { computed } from '@preact/signals';
import { resultFileKey } from '../worker/protocol';
import { keptFaces, results, wants } from './store';

/** Larger files are drawn body by body, without their materials. */
const MAX_FACES_DRAWN = 600_000;

export const canDrawFile = (): boolean =>
  results.file.value!.bodies.reduce((sum, { faces }) => sum + faces, 0) <= MAX_FACES_DRAWN;

export const resultFileNow = (): string => resultFileKey(wants.settings.value, keptFaces.value);

/** The file of the shown result; null until it has been made. */
export const shownResultFile = computed(() => {
  const { value: made } = results.resultFile;
  return made?.key === resultFileNow() ? made : null;
});
