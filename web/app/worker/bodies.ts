/** The description of the bodies of an open file for the page. */

import { describeHealth } from '../../engine/body/health';
import type { HealthNote } from '../../engine/body/health';
import { allFaces } from '../../engine/body/layers';
import type { PreparedBody } from '../../engine/body/prepared_body';
import { meshMatrices, otherScales } from '../../engine/document/placements';
import { defaultSettings } from '../../engine/settings/options';
import type { FileRun } from '../../engine/stages/file_run';
import { STAGES } from '../../engine/stages/stages';
import type { OpenedBody } from './protocol';

/** Their faces are those that a result can have: including duplicates, without degenerate ones, as the health report says. */
export function describeBodies({ runs, model }: FileRun): OpenedBody[] {
  const matrices = meshMatrices(model.document);
  return model.bodies.map((body, i) => {
    const prepared = runs[i]?.get(STAGES.prepared, defaultSettings());
    const { name, mesh, isScaledUnevenly } = body;
    return {
      ...{ name, mesh, isScaledUnevenly },
      faces: prepared ? allFaces(prepared.layers) : body.indices.length / 3,
      isScaledDifferently: otherScales(model.document, body) !== null,
      nodeMatrix: matrices[mesh],
      health: prepared ? healthOf(prepared) : null,
    };
  });
}

export const healthOf = ({ body, weld, inspection }: PreparedBody): HealthNote[] =>
  describeHealth(body, weld, inspection);
