/**
 * Newton 1.8, cloth of ModelBuilder.add_cloth_mesh in SolverVBD (newton/_src/solvers/vbd/particle_vbd_kernels.py). The membrane
 * is stable neo-Hookean (Smith et al. 2018) with mu = tri_ke and lambda = tri_ka in N/m, times the area of the triangle
 * (evaluate_neo_hookean_membrane_force_hessian); at rest it is linearised to the constant-strain membrane with these Lame
 * constants. Hinges are 1/2 edge_ke l (d theta)^2 (evaluate_dihedral_angle_based_bending_force_hessian), not divided by areas, so
 * that a coarse mesh is stiffer by its edges. tri_kd acts per area and edge_kd per length of the edge, both on rates; they follow
 * the stiffness, so that the damping ratio stays. `density` is kg/m2; masses are a third of the triangles around
 * (ModelBuilder.add_cloth_mesh). Triangles, edges and particles can have values of their own. VBD solves
 * one vertex after the other: where a substep is no longer than the inverse of the fastest vibration, an iteration leaves about a
 * third of the error at most; with substeps that are much longer no practical number of `iterations` keeps cloth from being too soft.
 */

import { hingeOfPlate, plateConstants } from './plate';
import { meshIndependent, withEdge } from './profile';
import type { Change, SolverProfile } from './profile';

const withStretch = ({ stretch }: Change): number => stretch;
const withBend = ({ bend }: Change): number => bend;

export const newton: SolverProfile = {
  name: 'newton',
  label: 'Newton',
  words: 'Newton: cloth in its VBD solver',
  stretch: 'membrane',
  bend: 'hinge-length',
  mass: 'area',
  takes: { vertexMaps: true, constraintValues: true, vertexMasses: true },
  status: 'verified',
  isLocal: true,
  parameters: [
    { name: 'tri_ke', unit: 'N/m', min: 1e-12, max: 1e15, words: 'shear stiffness of triangles' },
    { name: 'tri_ka', unit: 'N/m', min: 0, max: 1e15, words: 'area stiffness of triangles' },
    { name: 'edge_ke', unit: 'N', min: 0, max: 1e15, words: 'bending stiffness of edges' },
    { name: 'density', unit: 'kg/m2', min: 1e-12, max: 1e9, words: 'mass of a square metre' },
    {
      name: 'tri_kd',
      unit: 'N s/m',
      min: 0,
      max: 1e15,
      words: 'damping of triangles',
      role: 'damping',
      scaling: withStretch,
    },
    { name: 'edge_kd', unit: 'N s', min: 0, max: 1e15, words: 'damping of edges', scaling: withBend },
    {
      name: 'tri_drag',
      unit: '',
      min: 0,
      max: 1e9,
      words: 'drag of the air on triangles',
      role: 'air',
      scaling: meshIndependent,
    },
    {
      name: 'particle_radius',
      unit: 'm',
      min: 0,
      max: 1e6,
      words: 'of every particle in contacts',
      role: 'collisionThickness',
      scaling: withEdge,
    },
    {
      name: 'particle_self_contact_margin',
      unit: 'm',
      min: 0,
      max: 1e6,
      words: 'distance at which cloth touches itself',
      role: 'selfCollisionDistance',
      scaling: withEdge,
    },
    {
      name: 'soft_contact_mu',
      unit: '',
      min: 0,
      max: 100,
      words: 'friction of contacts',
      role: 'friction',
      scaling: meshIndependent,
    },
    { name: 'iterations', unit: '', min: 1, max: 1e6, words: 'of VBD per substep', scaling: meshIndependent },
  ],
  defaults(material, { meanEdge }) {
    const { stretch, secondStretch } = plateConstants(material);
    return {
      tri_ke: stretch,
      tri_ka: secondStretch,
      edge_ke: hingeOfPlate(material) / meanEdge,
      density: material.density * material.thickness,
      ...{ tri_kd: 0, edge_kd: 0, tri_drag: 0 },
      particle_radius: material.thickness / 2,
      particle_self_contact_margin: material.thickness,
      soft_contact_mu: 0.5,
      iterations: 10,
    };
  },
  constants: ({ tri_ke, tri_ka, edge_ke, density }, { unit }) => ({
    stretch: tri_ke,
    secondStretch: tri_ka,
    bend: edge_ke,
    poisson: 0,
    surfaceDensity: density,
    unit,
  }),
  elastic: ({ stretch, secondStretch, bend, surfaceDensity }) => ({
    tri_ke: stretch,
    tri_ka: secondStretch,
    edge_ke: bend,
    density: surfaceDensity,
  }),
};
