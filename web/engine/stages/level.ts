/** Stage: the history evaluated at a face count. */

import type { PreparedBody } from '../body/prepared_body';
import type { Core, History, MeshAt } from '../core/core';
import { wholeFaces } from './collapse_pairs';
import { historyStage } from './history';
import { preparedStage } from './prepared';
import { declareStage } from './stage';

export const levelStage = declareStage({
  name: 'level',
  reads: ['targetFaces'],
  needs: { prepared: preparedStage, history: historyStage },
  run: ({ core }, { prepared, history }, { targetFaces }) => levelAt(core, prepared, history, targetFaces),
});

/** The largest mesh of the history with at most `faces` faces, or that of the floor. */
export function levelAt(core: Core, prepared: PreparedBody, history: History, faces: number): MeshAt {
  return core.meshAt(prepared.mesh, history, wholeFaces(history, faces));
}
