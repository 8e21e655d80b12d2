/** Stage: the measured deviation of any level of a history. */

import type { Core, MeshAt } from '../../core/core';
import type { PreparedBody } from '../../body/prepared_body';
import { keptHistoryStage } from '../kept_history';
import type { KeptHistory } from '../kept_history';
import { levelAt } from '../level';
import { measureDeviation } from '../measure';
import { preparedStage } from '../prepared';
import { onceIn } from '../equal_work';
import { declareStage } from '../stage';

/** Measures levels and remembers what it has found, so that a cancelled search goes on from there. */
export class Deviations {
  /** `known`: by faces, of a body with the same mesh and history. */
  constructor(
    private readonly core: Core,
    private readonly prepared: PreparedBody,
    private readonly kept: KeptHistory,
    private readonly known = new Map<number, number>(),
  ) {}

  /** Of the level of at most `faces` faces, in % of the diagonal. `level`: that level, where it is at hand. */
  at(faces: number, level?: MeshAt): number {
    const known = this.known.get(faces);
    if (known !== undefined) return known;
    const { mesh } = level ?? levelAt(this.core, this.kept, faces);
    const deviation = measureDeviation(this.core, this.prepared, mesh);
    this.known.set(faces, deviation);
    return deviation;
  }
}

export const deviationsStage = declareStage({
  name: 'deviations',
  reads: [],
  needs: { prepared: preparedStage, kept: keptHistoryStage },
  run: ({ core, equalWork }, { prepared, kept }) => {
    const inputs = [prepared.mesh, prepared.samples, kept.history];
    const known = onceIn(equalWork, 'deviations', inputs, () => new Map<number, number>());
    return new Deviations(core, prepared, kept, known);
  },
});
