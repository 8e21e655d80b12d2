/** Stage: the measured deviation of any level of a history after its fit, as it would be exported. */

import { constraintsStage } from '../constraints';
import { FIT_SETTINGS, fitSettings, fittedLevelAt } from '../fit';
import { keptHistoryStage } from '../kept_history';
import { measureDeviation } from '../measure';
import { preparedStage } from '../prepared';
import { declareStage } from '../stage';
import { deviationsStage } from './deviations';

/** The deviation of the level of at most `faces` faces, in % of the diagonal; results are remembered. */
export type DeviationAt = (faces: number) => number;

export const fittedDeviationsStage = declareStage({
  name: 'fitted deviations',
  reads: FIT_SETTINGS,
  needs: {
    prepared: preparedStage,
    constraints: constraintsStage,
    kept: keptHistoryStage,
    deviations: deviationsStage,
  },
  derive: fitSettings,
  run: ({ core }, { prepared, constraints, kept, deviations }, settings): DeviationAt => {
    if (settings === null) return (faces) => deviations.at(faces);
    const known = new Map<number, number>();
    const request = { constraints: constraints.constraints, settings };
    return (faces) => {
      if (!known.has(faces)) {
        const { mesh } = fittedLevelAt(core, { prepared, kept }, faces, request).result;
        known.set(faces, measureDeviation(core, prepared, mesh));
      }
      return known.get(faces)!;
    };
  },
});
