/** The Japanese texts of the page, divided among the files of this folder. */

import type { MessageTable } from '../message_table';
import { ENGINE } from './engine';
import { EXPORT_FORMS } from './export_forms';
import { FILE_ERRORS } from './file_errors';
import { FILE_NOTES } from './file_notes';
import { PAGE } from './page';
import { PANELS } from './panels';
import { PROGRESS } from './progress';
import { SETTINGS } from './settings';
import { SOLVERS } from './solvers';
import { STEPS } from './steps';
import { TEST_AND_EXPORT } from './test_and_export';

export const JAPANESE: MessageTable = {
  ...ENGINE,
  ...EXPORT_FORMS,
  ...FILE_ERRORS,
  ...FILE_NOTES,
  ...PAGE,
  ...PANELS,
  ...PROGRESS,
  ...SETTINGS,
  ...SOLVERS,
  ...STEPS,
  ...TEST_AND_EXPORT,
};
