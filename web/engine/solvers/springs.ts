/**
 * Springs along edges and, weaker, between the two corners opposite each inner edge: what many games use (Provot 1995). One
 * stiffness for each kind on any mesh.
 */

import { netFamily } from './net_family';
import type { SolverProfile } from './profile';

export const springs: SolverProfile = {
  name: 'springs',
  label: 'Springs',
  words: 'springs along edges and across them',
  stretch: 'edge-springs',
  bend: 'cross-springs',
  mass: 'area',
  takes: { vertexMaps: true, constraintValues: true, vertexMasses: true },
  status: 'generic',
  isLocal: true,
  ...netFamily({ unit: 'N/m', words: 'stiffness of every spring across an edge' }, () => 1),
};
