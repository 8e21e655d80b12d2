/** Stages: the original and its history as the core keeps them, so that no tick of the slider copies them again. */

import type { History, HistoryHandle, MeshHandle } from '../core/core';
import { historyStage } from './history';
import { preparedStage } from './prepared';
import { declareStage } from './stage';

const keptMeshStage = declareStage({
  name: 'kept mesh',
  reads: [],
  needs: { prepared: preparedStage },
  run: ({ core }, { prepared }) => core.keepMesh(prepared.mesh),
  release: ({ core }, handle) => core.releaseMesh(handle),
});

/** A history, and the handles of itself and of the mesh that it began with. */
export interface KeptHistory {
  history: History;
  historyHandle: HistoryHandle;
  meshHandle: MeshHandle;
}

export const keptHistoryStage = declareStage({
  name: 'kept history',
  reads: [],
  needs: { mesh: keptMeshStage, history: historyStage },
  run: ({ core }, { mesh, history }): KeptHistory => ({
    history,
    historyHandle: core.keepHistory(history),
    meshHandle: mesh,
  }),
  release: ({ core }, { historyHandle }) => core.releaseHistory(historyHandle),
});
