/**
 * Blender 4.5, the cloth modifier with angular bending (source/blender/simulation/intern/SIM_mass_spring.cpp,
 * cloth_calc_spring_force). Edges are springs of the stiffness tension / (mean length of all springs), the same for all of them.
 * Set compression to tension: then springs resist both ways alike. Shear springs exist in quads alone. Bending gives each corner
 * opposite an inner edge the force 0.1 bending l dtheta / 3 (implicit_blender.c, spring_angular), as a hinge of the stiffness
 * 0.1 bending (A1 + A2) / 3 does (tests/bench/engines/blender_engine.py); the panel takes hinges by length with the same mean.
 * `mass` is that of every vertex, and there is no map for it. Air acts on every vertex with 0.01 air times its velocity
 * (SIM_mass_spring_force_drag). Stiffness can vary by vertex groups, towards the maxima.
 *
 * Dampings and air are forces by velocity, whatever the mass: what a motion loses in a frame goes with them over the mass. Damping
 * of bending is explicit (spring_angular): d p p^T with p = (1, 1, -1, -1) / 3 on a flat hinge, so that a step of 1 / quality frames
 * blows up where bending_damping is above about mass quality. Blender's defaults are for its default mass.
 *
 * Units: gravity enters times 0.001 and time counts in frames (cloth_calc_force), so that gravity is real where a frame lasts
 * sqrt(0.001) s, 31.6 frames a second. In that time stiffness in N/m is 1000 times what the modifier has.
 */

import type { MeshFacts } from './mesh_facts';
import { hingeOfPlate, springOfPlate } from './plate';
import { meshIndependent, perVertex, withEdge } from './profile';
import type { Change, SolverProfile } from './profile';

/** 1 / (seconds in a frame)^2 */
const TIME = 1000;
const HINGE = 0.1;
/** kg, of a vertex in Blender's default cloth */
const DEFAULT_MASS = 0.3;
/** The largest factor on Blender's defaults at which air and damping of edges stay within their ranges. */
const LARGEST_SHARE = 10;

/** The mean stiffness (N m) of a hinge for `bending` 1: a third of the areas of both of its triangles. */
const hingeOf = ({ area, faces }: MeshFacts): number => (TIME * HINGE * 2 * area) / (3 * faces);

/** Damping follows the stiffness. Bending has the length of its edge in its stiffness, not in its damping. */
const withSpring = ({ stretch }: Change): number => stretch;
const withHinge = ({ bend }: Change): number => bend;

export const blender: SolverProfile = {
  name: 'blender',
  label: 'Blender',
  words: 'Blender: the cloth modifier with angular bending',
  stretch: 'edge-springs',
  bend: 'hinge-length',
  mass: 'vertex',
  takes: { vertexMaps: true, constraintValues: false, vertexMasses: false },
  status: 'verified',
  isLocal: false,
  parameters: [
    {
      name: 'tension',
      alias: 'tension_stiffness',
      unit: '',
      min: 1e-9,
      max: 10000,
      words: 'stiffness of edges, for compression too',
    },
    {
      name: 'shear',
      alias: 'shear_stiffness',
      unit: '',
      min: 0,
      max: 10000,
      words: 'stiffness of the diagonals of quads, of which triangles have none',
      scaling: ({ stretch, edge }) => stretch * edge,
    },
    {
      name: 'bending',
      alias: 'bending_stiffness',
      unit: '',
      min: 0,
      max: 10000,
      words: 'stiffness of hinges',
    },
    { name: 'mass', unit: 'kg', min: 1e-9, max: 1e9, words: 'of every vertex' },
    {
      name: 'air',
      alias: 'air_damping',
      unit: '',
      min: 0,
      max: 10,
      words: 'viscosity of the air',
      role: 'air',
      scaling: perVertex,
    },
    {
      name: 'tension_damping',
      unit: '',
      min: 0,
      max: 50,
      words: 'damping of edges',
      role: 'damping',
      scaling: withSpring,
    },
    { name: 'bending_damping', unit: '', min: 0, max: 1000, words: 'damping of hinges', scaling: withHinge },
    {
      name: 'distance_min',
      unit: 'm',
      min: 0.001,
      max: 1,
      words: 'distance to what it touches',
      role: 'collisionThickness',
      scaling: withEdge,
    },
    {
      name: 'self_distance_min',
      unit: 'm',
      min: 0.001,
      max: 0.1,
      words: 'distance between its own parts',
      role: 'selfCollisionDistance',
      scaling: withEdge,
    },
    {
      name: 'friction',
      unit: '',
      min: 0,
      max: 80,
      words: 'of what it touches',
      role: 'friction',
      scaling: meshIndependent,
    },
    {
      name: 'quality',
      unit: '',
      min: 1,
      max: 1000,
      words: 'steps per frame',
      role: 'substeps',
      scaling: meshIndependent,
    },
  ],
  // Half of what blew up on sheets (docs/engine-models.md).
  stepLimit: {
    name: 'bending_damping',
    most: ({ mass, quality }) => (mass * quality) / 2,
    words: 'half of mass times quality',
  },
  defaults(material, facts, given) {
    const { area, vertices, meanEdge } = facts;
    const mass = given.mass ?? (material.density * material.thickness * area) / vertices;
    // Air and damping are scaled with the mass of a vertex, so that it moves like one of Blender's default cloth.
    const share = Math.min(LARGEST_SHARE, mass / DEFAULT_MASS);
    return {
      tension: (springOfPlate(material) * meanEdge) / TIME,
      bending: hingeOfPlate(material) / hingeOf(facts),
      mass,
      shear: 5,
      ...{ air: share, tension_damping: 5 * share, bending_damping: 0.5 * share },
      ...{ distance_min: 0.015, self_distance_min: 0.015, friction: 5, quality: 20 },
    };
  },
  constants({ tension, bending, mass }, facts) {
    const { area, vertices, meanEdge, unit } = facts;
    return {
      stretch: (TIME * tension) / meanEdge,
      secondStretch: 0,
      bend: (bending * hingeOf(facts)) / meanEdge,
      poisson: 0,
      surfaceDensity: (mass * vertices) / area,
      unit,
    };
  },
  elastic({ stretch, bend, surfaceDensity }, facts) {
    const { area, vertices, meanEdge } = facts;
    return {
      tension: (stretch * meanEdge) / TIME,
      bending: (bend * meanEdge) / hingeOf(facts),
      mass: (surfaceDensity * area) / vertices,
    };
  },
};
