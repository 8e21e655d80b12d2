/** Stages: the further levels of a body tuned like its result, and as the exporter takes them. */

import { MATERIAL_SETTINGS } from '../body/material';
import type { ExportedBody } from '../document/export';
import { calibrationOf } from '../motion/simulation';
import { exportedSettings } from '../report/settings_file';
import { pinnedStage } from './constraints';
import { furtherLevelsStage } from './further_levels';
import { preparedStage } from './prepared';
import { declareStage, where } from './stage';
import { pinnedOfResult, TUNE_SETTINGS, tuneMesh, tuneSettings } from './tune';
import { exportedBody, writtenFields } from './written';

const tunedLevels = declareStage({
  name: 'tuned levels',
  reads: TUNE_SETTINGS,
  needs: { prepared: preparedStage, levels: furtherLevelsStage, pinned: pinnedStage },
  derive: tuneSettings,
  run: ({ core }, { prepared, levels, pinned }, settings) =>
    levels.map(({ result }) =>
      tuneMesh(
        core,
        prepared,
        { mesh: result.mesh, pinned: pinnedOfResult(pinned, result), pinnedOriginal: pinned },
        settings!,
      ),
    ),
});

/** One for each of `lods`, in their order; null where no solver is asked for. */
export const tunedLevelsStage = where(tunedLevels, ['solver'], ({ solver }) => solver !== 'none');

/** The further levels as the exporter takes them. */
export const writtenLevelsStage = declareStage({
  name: 'written levels',
  reads: ['calibrate', ...MATERIAL_SETTINGS],
  needs: {
    prepared: preparedStage,
    levels: furtherLevelsStage,
    fields: writtenFields,
    tuned: tunedLevelsStage,
  },
  derive: ({ calibrate, ...material }) => ({ calibration: calibrate ? material : null }),
  run: ({ core }, { prepared, levels, fields, tuned }, { calibration }) =>
    levels.map(({ result }, i): ExportedBody => ({
      ...exportedBody(core, prepared, result, fields),
      ...(tuned ? { settings: exportedSettings(tuned[i]) } : {}),
      ...(calibration ? { calibration: calibrationOf(core, prepared, result.mesh, calibration) } : {}),
    })),
});
