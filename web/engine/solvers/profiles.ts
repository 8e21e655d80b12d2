/** The only list of solvers in TypeScript, in the order of the help: generic families first, then engines. */

import { blender } from './blender';
import { dihedral } from './dihedral';
import { hingeShell } from './hinge_shell';
import { jolt } from './jolt';
import { mujoco } from './mujoco';
import { newton } from './newton';
import type { SolverProfile } from './profile';
import { shell } from './shell';
import { springs } from './springs';

export const SOLVER_NAMES = [
  'shell',
  'hinge-shell',
  'dihedral',
  'springs',
  'jolt',
  'mujoco',
  'newton',
  'blender',
] as const;

export type SolverName = (typeof SOLVER_NAMES)[number];

/** Generic families of solvers, for users who do not know yet in which engine a result will move. */
export const GENERIC_SOLVERS = ['shell', 'hinge-shell', 'dihedral', 'springs'] as const;

export type GenericSolver = (typeof GENERIC_SOLVERS)[number];

const PROFILES: Readonly<Record<SolverName, SolverProfile>> = {
  shell,
  'hinge-shell': hingeShell,
  dihedral,
  springs,
  jolt,
  mujoco,
  newton,
  blender,
};

export const profileOf = (name: SolverName): SolverProfile => PROFILES[name];

/** One clause for each solver, for the help of a setting. */
export const describeSolvers = (): string =>
  SOLVER_NAMES.map((name) => `${name} (${PROFILES[name].words})`).join(', ');
