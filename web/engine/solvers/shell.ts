/** Limber's own shell: a constant-strain membrane, and Morley's element for bending (Morley 1968; docs/modes.md). */

import type { SolverProfile } from './profile';
import { sheetFamily } from './sheet_family';

export const shell: SolverProfile = {
  name: 'shell',
  label: 'Shell',
  words: "Limber's own shell: membrane and Morley bending",
  stretch: 'membrane',
  bend: 'morley',
  mass: 'area',
  takes: { vertexMaps: true, constraintValues: true, vertexMasses: true },
  status: 'generic',
  isLocal: true,
  ...sheetFamily,
};
