/** Takes runs over bodies through all their stages. */

import type { Core, TriangleMesh } from '../../../web/engine/core/core';
import type { OpenModel } from '../../../web/engine/document/open';
import type { Settings } from '../../../web/engine/settings/options';
import { BodyRun } from '../../../web/engine/stages/body_run';
import { guidingStrain } from '../../../web/engine/stages/guidance';
import { STAGES } from '../../../web/engine/stages/stages';
import { bodyOf } from './bodies';

/** A run over a body that does not come from a file. */
export const runOfMesh = (core: Core, mesh: TriangleMesh): BodyRun =>
  new BodyRun({ core, body: bodyOf(mesh), document: null });

/** A run over one body of a file. */
export const runOfModel = (core: Core, { bodies, document }: OpenModel, body = 0): BodyRun =>
  new BodyRun({ core, body: bodies[body], document });

/** The values of the stages for a target of `targetFaces` faces. */
export function optimized(run: BodyRun, settings: Settings, targetFaces: number) {
  const own = { ...settings, targetFaces, fields: false };
  const fitted = run.get(STAGES.fitted, own);
  return {
    prepared: run.get(STAGES.prepared, own),
    constraints: run.get(STAGES.constraints, own).constraints,
    /** null for a method without guidance */
    modes: run.get(STAGES.guidingModes, own),
    guidance: run.get(guidingStrain, own),
    curvature: run.get(STAGES.curvature, own),
    history: run.get(STAGES.history, own),
    fitted,
    result: fitted.result,
    frequency: fitted.frequency,
    measured: run.get(STAGES.measured, own),
    targetFaces,
  };
}

export type Optimized = ReturnType<typeof optimized>;
