/** Every stage of a run over a body, in the order in which they can be needed. */

import { constraintsStage, pinnedStage } from './constraints';
import { deviationMarksStage } from './budget/deviation_marks';
import { explanationStage } from './explanation';
import { fittedStage } from './fitted';
import { furtherLevelsStage } from './further_levels';
import { curvatureStage, guidanceStage, guidingModes } from './guidance';
import { historyStage } from './history';
import { levelStage } from './level';
import { calibrationStage, measuredStage } from './measured';
import { modesStage } from './modes';
import { preparedStage } from './prepared';
import { tunedStage } from './tuned';
import { writtenStage } from './written';
import { tunedLevelsStage, writtenLevelsStage } from './written_levels';

export const STAGES = {
  prepared: preparedStage,
  pinned: pinnedStage,
  constraints: constraintsStage,
  modes: modesStage,
  guidance: guidanceStage,
  curvature: curvatureStage,
  /** the modes, and null where the method follows none */
  guidingModes,
  history: historyStage,
  level: levelStage,
  fitted: fittedStage,
  measured: measuredStage,
  calibration: calibrationStage,
  explanation: explanationStage,
  deviationMarks: deviationMarksStage,
  tuned: tunedStage,
  written: writtenStage,
  furtherLevels: furtherLevelsStage,
  tunedLevels: tunedLevelsStage,
  writtenLevels: writtenLevelsStage,
};
