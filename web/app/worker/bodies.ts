/** What the page is told of the bodies of an open file. */

import { describeHealth } from '../../engine/body/health';
import type { HealthNote } from '../../engine/body/health';
import type { PreparedBody } from '../../engine/body/prepared_body';
import { nodeMatrixOf } from '../../engine/document/placements';
import { defaultSettings } from '../../engine/settings/options';
import type { FileRun } from '../../engine/stages/file_run';
import { STAGES } from '../../engine/stages/stages';
import type { OpenedBody } from './protocol';

export function describeBodies({ runs, model }: FileRun): OpenedBody[] {
  const meshes = model.document.getRoot().listMeshes();
  return model.bodies.map((body, i) => ({
    name: body.name,
    faces: body.indices.length / 3,
    mesh: body.mesh,
    nodeMatrix: nodeMatrixOf(model.document, meshes[body.mesh]),
    health: runs[i] ? healthOf(runs[i].get(STAGES.prepared, defaultSettings())) : null,
  }));
}

export const healthOf = ({ body, weld, inspection }: PreparedBody): HealthNote[] =>
  describeHealth(body, weld, inspection);
