/**
 * Jolt Physics 5: edges with `mCompliance`, "inverse of the stiffness of the spring", and dihedral bends with their own
 * compliance (SoftBodySharedSettings::Edge and ::DihedralBend, EBendType::Dihedral), both solved by XPBD as
 * compliance / dt^2 (SoftBodyMotionProperties::ApplyEdgeConstraints, ApplyDihedralBendConstraints); `mInvMass` of a vertex is 1
 * unless set; velocities are multiplied by 1 - mLinearDamping dt; a step has mNumIterations substeps
 * (SoftBodyCreationSettings). Shear constraints, which CreateConstraints adds to quads, are not used. Edges or bends can have
 * compliances of their own.
 */

import { hingeOfPlate, springOfPlate } from './plate';
import { meshIndependent, withEdge } from './profile';
import type { SolverProfile } from './profile';

export const jolt: SolverProfile = {
  name: 'jolt',
  label: 'Jolt',
  words: 'Jolt Physics: edges and dihedral bends',
  stretch: 'edge-springs',
  bend: 'hinge',
  mass: 'vertex',
  takes: { vertexMaps: true, constraintValues: true, vertexMasses: true },
  status: 'verified',
  isLocal: true,
  parameters: [
    { name: 'compliance', alias: 'mCompliance', unit: 'm/N', min: 1e-15, max: 1e9, words: 'of every edge' },
    {
      name: 'bendCompliance',
      alias: 'mBendCompliance',
      unit: 'rad/(N m)',
      min: 1e-15,
      max: 1e15,
      words: 'of every dihedral bend',
    },
    { name: 'invMass', alias: 'mInvMass', unit: '1/kg', min: 1e-9, max: 1e9, words: 'of every vertex' },
    {
      name: 'linearDamping',
      alias: 'mLinearDamping',
      unit: '1/s',
      min: 0,
      max: 1000,
      words: 'rate at which velocities decay',
      role: 'damping',
      scaling: meshIndependent,
    },
    {
      name: 'vertexRadius',
      alias: 'mVertexRadius',
      unit: 'm',
      min: 0,
      max: 1e3,
      words: 'distance that vertices keep from other bodies',
      role: 'collisionThickness',
      scaling: withEdge,
    },
    {
      name: 'friction',
      alias: 'mFriction',
      unit: '',
      min: 0,
      max: 10,
      words: "Coulomb's coefficient",
      role: 'friction',
      scaling: meshIndependent,
    },
  ],
  defaults(material, { area, vertices }) {
    return {
      compliance: 1 / springOfPlate(material),
      bendCompliance: 1 / hingeOfPlate(material),
      invMass: vertices / (material.density * material.thickness * area),
      linearDamping: 0.1,
      vertexRadius: 0,
      friction: 0.2,
    };
  },
  constants: ({ compliance, bendCompliance, invMass }, { area, vertices, unit }) => ({
    stretch: 1 / compliance,
    secondStretch: 0,
    bend: 1 / bendCompliance,
    poisson: 0,
    surfaceDensity: vertices / invMass / area,
    unit,
  }),
  elastic: ({ stretch, bend, surfaceDensity }, { area, vertices }) => ({
    compliance: 1 / stretch,
    bendCompliance: 1 / bend,
    invMass: vertices / (surfaceDensity * area),
  }),
};
