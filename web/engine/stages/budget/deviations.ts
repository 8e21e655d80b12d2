/** Stage: the measured deviation of any level of a history. */

import type { Core, MeshAt, TriangleMesh } from '../../core/core';
import type { PreparedBody } from '../../body/prepared_body';
import { keptHistoryStage } from '../kept_history';
import type { KeptHistory } from '../kept_history';
import { levelAt } from '../level';
import { isWithinDeviation, measureDeviation, withinArguments } from '../measure';
import { preparedStage } from '../prepared';
import { onceIn } from '../many_bodies/value_cache';
import { declareStage } from '../stage';

/** The deviations measured so far for the levels of a mesh and its history. */
interface KnownDeviations {
  /** by faces */
  exact: Map<number, number>;
  /** by faces and limit */
  within: Map<string, boolean>;
}

const nothing = (): KnownDeviations => ({ exact: new Map(), within: new Map() });

/** Measures levels and remembers the results, so that a cancelled search continues from there. */
export class Deviations {
  /** `known`: of a body with the same mesh and history. */
  constructor(
    private readonly core: Core,
    private readonly prepared: PreparedBody,
    private readonly kept: KeptHistory,
    private readonly known = nothing(),
  ) {}

  /** Of the level of at most `faces` faces, in % of the diagonal. */
  at(faces: number): number {
    const { exact } = this.known;
    const deviation = exact.get(faces) ?? measureDeviation(this.core, this.prepared, this.mesh(faces));
    exact.set(faces, deviation);
    return deviation;
  }

  /** Whether `at` is at most `limit`, in a fraction of its time. `level`: that level, if the caller has it. */
  isWithin(faces: number, limit: number, level?: MeshAt): boolean {
    const { exact, within } = this.known;
    const deviation = exact.get(faces);
    if (deviation !== undefined) return deviation <= limit;
    const key = withinKey(faces, limit);
    const is = within.get(key) ?? isWithinDeviation(this.core, this.prepared, this.mesh(faces, level), limit);
    within.set(key, is);
    return is;
  }

  /** The arguments of `isWithinDeviation` for a level; null if the answer is known. */
  comparisonFor(faces: number, limit: number): Comparison | null {
    const { exact, within } = this.known;
    const key = withinKey(faces, limit);
    if (exact.has(faces) || within.has(key)) return null;
    return { prepared: this.prepared, other: this.mesh(faces), results: within, key };
  }

  private mesh(faces: number, level?: MeshAt): TriangleMesh {
    return (level ?? levelAt(this.core, this.kept, faces)).mesh;
  }
}

const withinKey = (faces: number, limit: number): string => `${faces} ${limit}`;

/** A level that is yet to be compared with its original, and where the result is remembered. */
interface Comparison {
  prepared: PreparedBody;
  other: TriangleMesh;
  results: Map<string, boolean>;
  key: string;
}

/** The comparisons without duplicates: bodies of one shape share their results. */
function withoutRepetition<One extends Comparison>(all: (One | null)[]): One[] {
  const seen = new Map<One['results'], Set<string>>();
  return all.filter((one): one is One => {
    if (!one) return false;
    const keys = seen.get(one.results) ?? new Set<string>();
    const isNew = !keys.has(one.key);
    seen.set(one.results, keys.add(one.key));
    return isNew;
  });
}

/** Makes comparisons of `Deviations.isWithin` in parallel. */
export function compareInParallel(
  core: Core,
  questions: { deviations: Deviations; faces: number; limit: number }[],
): void {
  const asked = questions.map(({ deviations, faces, limit }) => {
    const comparison = deviations.comparisonFor(faces, limit);
    return comparison && { ...comparison, limit };
  });
  const unknown = withoutRepetition(asked);
  const answers = core.callAll(
    'isWithinHausdorff',
    unknown.map(({ prepared, other, limit }) => withinArguments(prepared, other, limit)),
  );
  answers.forEach((answer, i) => {
    const { results, key } = unknown[i];
    if (typeof answer === 'boolean') results.set(key, answer);
  });
}

export const deviationsStage = declareStage({
  name: 'deviations',
  reads: [],
  needs: { prepared: preparedStage, kept: keptHistoryStage },
  run: ({ core, cache }, { prepared, kept }) => {
    const inputs = [prepared.mesh, prepared.samples, kept.history];
    const known = onceIn(cache, 'deviations', inputs, nothing);
    return new Deviations(core, prepared, kept, known);
  },
});
