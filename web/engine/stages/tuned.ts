/** Stage: the result, tuned to move like the original in a solver. */

import { pinnedStage } from './constraints';
import { fittedStage } from './fitted';
import { preparedStage } from './prepared';
import { declareStage, where } from './stage';
import { pinnedOfResult, TUNE_SETTINGS, tuneMesh, tuneSettings } from './tune';

export const tunedResultStage = declareStage({
  name: 'tuned',
  reads: TUNE_SETTINGS,
  needs: { prepared: preparedStage, fitted: fittedStage, pinned: pinnedStage },
  derive: tuneSettings,
  run: ({ core }, { prepared, fitted: { result }, pinned }, settings) =>
    tuneMesh(
      core,
      prepared,
      { mesh: result.mesh, pinned: pinnedOfResult(pinned, result), pinnedOriginal: pinned },
      settings!,
    ),
});

/** null where no solver is asked for. */
export const tunedStage = where(tunedResultStage, ['solver'], ({ solver }) => solver !== 'none');
