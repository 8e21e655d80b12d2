/**
 * The shell of most research simulators: a constant-strain membrane, and hinges 1/2 (3 D l^2 / (A1 + A2)) (d theta)^2 at inner
 * edges (Grinspun, Hirani, Desbrun, Schroeder 2003, Discrete Shells; ARCSim and others).
 */

import type { SolverProfile } from './profile';
import { sheetFamily } from './sheet_family';

export const hingeShell: SolverProfile = {
  name: 'hinge-shell',
  label: 'Discrete Shells',
  words: 'membrane, and hinges as in Discrete Shells',
  stretch: 'membrane',
  bend: 'hinge-area',
  mass: 'area',
  takes: { vertexMaps: true, constraintValues: true, vertexMasses: true },
  status: 'generic',
  isLocal: true,
  ...sheetFamily,
};
