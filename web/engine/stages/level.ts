/** Stage: the history evaluated at a face count. */

import type { Core, MeshAt } from '../core/core';
import { wholeFaces } from './collapse_pairs';
import { keptHistoryStage } from './kept_history';
import type { KeptHistory } from './kept_history';
import { declareStage } from './stage';

export const levelStage = declareStage({
  name: 'level',
  reads: ['targetFaces'],
  needs: { kept: keptHistoryStage },
  run: ({ core }, { kept }, { targetFaces }) => levelAt(core, kept, targetFaces),
});

/** The largest mesh of the history with at most `faces` faces, or that of the floor. */
export function levelAt(core: Core, kept: KeptHistory, faces: number): MeshAt {
  return core.meshAt(kept.meshHandle, kept.historyHandle, wholeFaces(kept.history, faces));
}
