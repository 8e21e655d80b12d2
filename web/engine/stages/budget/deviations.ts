/** Stage: the measured deviation of any level of a history. */

import type { Core, MeshAt, TriangleMesh } from '../../core/core';
import type { PreparedBody } from '../../body/prepared_body';
import { keptHistoryStage } from '../kept_history';
import type { KeptHistory } from '../kept_history';
import { levelAt } from '../level';
import { isWithinDeviation, measureDeviation } from '../measure';
import { preparedStage } from '../prepared';
import { onceIn } from '../many_bodies/equal_work';
import { declareStage } from '../stage';

/** What has been measured of the levels of a mesh and its history. */
interface KnownDeviations {
  /** by faces */
  exact: Map<number, number>;
  /** by faces and limit */
  within: Map<string, boolean>;
}

const nothing = (): KnownDeviations => ({ exact: new Map(), within: new Map() });

/** Measures levels and remembers what it has found, so that a cancelled search goes on from there. */
export class Deviations {
  /** `known`: of a body with the same mesh and history. */
  constructor(
    private readonly core: Core,
    private readonly prepared: PreparedBody,
    private readonly kept: KeptHistory,
    private readonly known = nothing(),
  ) {}

  /** Of the level of at most `faces` faces, in % of the diagonal. `level`: that level, where it is at hand. */
  at(faces: number, level?: MeshAt): number {
    const { exact } = this.known;
    const deviation = exact.get(faces) ?? measureDeviation(this.core, this.prepared, this.mesh(faces, level));
    exact.set(faces, deviation);
    return deviation;
  }

  /** Whether `at` is at most `limit`, which is found in a fraction of the time. */
  isWithin(faces: number, limit: number, level?: MeshAt): boolean {
    const { exact, within } = this.known;
    const deviation = exact.get(faces);
    if (deviation !== undefined) return deviation <= limit;
    const key = `${faces} ${limit}`;
    const is = within.get(key) ?? isWithinDeviation(this.core, this.prepared, this.mesh(faces, level), limit);
    within.set(key, is);
    return is;
  }

  private mesh(faces: number, level: MeshAt | undefined): TriangleMesh {
    return (level ?? levelAt(this.core, this.kept, faces)).mesh;
  }
}

export const deviationsStage = declareStage({
  name: 'deviations',
  reads: [],
  needs: { prepared: preparedStage, kept: keptHistoryStage },
  run: ({ core, equalWork }, { prepared, kept }) => {
    const inputs = [prepared.mesh, prepared.samples, kept.history];
    const known = onceIn(equalWork, 'deviations', inputs, nothing);
    return new Deviations(core, prepared, kept, known);
  },
});
