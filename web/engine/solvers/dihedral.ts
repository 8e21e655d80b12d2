/**
 * Springs along edges, and 1/2 k (d theta)^2 at the dihedral angle of inner edges, one k for all: position-based cloth (Mueller et
 * al. 2007) and the engines that follow it. The default of the bend constant is the bend ratio times the stiffness of the edges
 * times the square of the original's mean edge, so that it does not depend on units.
 */

import { netFamily } from './net_family';
import type { SolverProfile } from './profile';

export const dihedral: SolverProfile = {
  name: 'dihedral',
  label: 'Edges and hinges',
  words: 'springs along edges, hinges at dihedral angles',
  stretch: 'edge-springs',
  bend: 'hinge',
  mass: 'area',
  takes: { vertexMaps: true, constraintValues: true, vertexMasses: true },
  status: 'generic',
  isLocal: true,
  ...netFamily({ unit: 'N m', words: 'stiffness of every hinge' }, ({ meanEdge }) => meanEdge * meanEdge),
};
