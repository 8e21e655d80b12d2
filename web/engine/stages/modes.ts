/** Stage: the elastic modes of every component. */

import { MATERIAL_SETTINGS, materialOf } from '../body/material';
import type { MaterialSettings } from '../body/material';
import type { PinnedVertices } from '../body/pins';
import type { PreparedBody } from '../body/prepared_body';
import type { Model, ModeSet } from '../core/core';
import { faceCount, vertexCount } from '../core/mesh';
import { resolveModel } from '../settings/options';
import type { Settings } from '../settings/options';
import { pinnedStage } from './constraints';
import { preparedStage } from './prepared';
import { coreCall, resultOf } from './many_bodies/core_call';
import type { CoreCall } from './many_bodies/core_call';
import { declareStage } from './stage';

export interface ModesRequest extends MaterialSettings, Pick<Settings, 'modeCount' | 'direction' | 'exact'> {
  /** resolved for the method */
  model: 'auto' | Model;
  /** see RunContext */
  guidedBodies?: number;
}

export const modesStage = declareStage({
  name: 'modes',
  reads: ['method', 'model', 'modeCount', 'direction', 'exact', ...MATERIAL_SETTINGS],
  needs: { prepared: preparedStage, pinned: pinnedStage },
  derive: ({ method, ...settings }): ModesRequest => ({
    ...settings,
    model: resolveModel({ method, model: settings.model }),
  }),
  run: ({ core, guidedBodies, isTooSmallToMove, cache }, { prepared, pinned }, request) =>
    isTooSmallToMove
      ? withoutModes(prepared, request)
      : resultOf(core, cache, modesCall(prepared, pinned, { ...request, guidedBodies })),
  firstCalls: ({ guidedBodies, isTooSmallToMove }, { prepared, pinned }, request) =>
    isTooSmallToMove ? [] : [modesCall(prepared, pinned, { ...request, guidedBodies })],
});

/** The modes of a body that is not analysed: none, of one part. */
function withoutModes({ mesh, inspection }: PreparedBody, { model }: ModesRequest): ModeSet {
  const part = {
    faces: faceCount(mesh),
    model:
      model !== 'auto' ? model : inspection.boundaryLoops === 0 ? ('solid' as const) : ('shell' as const),
    host: 0,
    coarseVertices: 0,
    zeroModesExpected: 0,
    zeroModesFound: 0,
    modeCount: 0,
  };
  return {
    modes: [],
    components: [part],
    modesPerComponent: 0,
    shapes: new Float32Array(),
    componentOfVertex: new Uint32Array(vertexCount(mesh)),
    factorNonzeros: 0,
  };
}

/** The material is that of the body in the scale of its first node. */
export function modesCall(
  prepared: PreparedBody,
  pinned: PinnedVertices,
  request: ModesRequest,
): CoreCall<'findModes'> {
  const { model, modeCount, direction, exact } = request;
  return coreCall('findModes', prepared.mesh, {
    model,
    modeCount,
    direction: ['x', 'y', 'z'].indexOf(direction),
    pinned,
    exact,
    guidedParts: request.guidedBodies,
    ...materialOf(prepared, request),
  });
}
