/** The request for a whole file. */

import type { Settings } from '../settings/options';
import { keyOf } from './stage';
import type { RunSettings } from './stage';
import { STAGES } from './stages';

export interface FileRequest {
  settings: Settings;
  /** the requested number of faces of the whole file; absent: the sum of the targets */
  faces?: number;
  /** targets[i]: the most faces that the result of body i of the file may have */
  targets: number[];
  /** levelTargets[n][i]: the same for further level n; absent: the share `lods[n]` of each body */
  levelTargets?: number[][];
  /** of every body, as in `RunSettings`; for files of which one body takes part */
  fewestFaces?: number;
  /** whether strain and curvature are written as attributes */
  fields: boolean;
  /** whether a binding file is written, which counts vertices of the result */
  binding?: boolean;
}

/** The settings of the run over body `i`. */
export const runSettings = (
  { settings, targets, levelTargets, fewestFaces, fields }: FileRequest,
  i: number,
): RunSettings => ({
  ...settings,
  targetFaces: targets[i],
  fewestFaces,
  ...(levelTargets ? { levelFaces: levelTargets.map((level) => level[i]) } : {}),
  fields,
});

/** A key that is equal for two requests if they give the same file with the same further levels. */
export function keyOfFile({
  settings,
  targets,
  levelTargets = [],
  fields,
  binding = false,
}: FileRequest): string {
  const shared = { ...settings, fields, targetFaces: 0 };
  const keys = [STAGES.written, STAGES.writtenLevels].map((stage) => keyOf(stage, shared));
  const { format, compress, lodStyle } = settings;
  const written = [format, compress, lodStyle, String(binding)].join(' ');
  return [...keys, written, String(settings.perBody), targets.join(' '), ...levelTargets.map(String)].join(
    '\n',
  );
}
