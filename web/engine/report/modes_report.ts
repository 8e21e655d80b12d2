/** The modes of all bodies, sorted together. */

import type { Model, ModeName, ModeSet } from '../core/core';
import { sum } from '../core/mesh';
import { coarseVerticesOf } from '../core/mode_set';

export interface SolveReport {
  /** whether every part was solved itself, none through a coarse copy */
  exact: boolean;
  /** vertices of the largest coarse copy; absent where exact */
  coarseVertices?: number;
  /** nonzeros of the largest factor L */
  factorNonzeros: number;
}

export interface ZeroModes {
  expected: number;
  found: number;
}

export interface ComponentReport {
  faces: number;
  model: Model;
  zeroModes: ZeroModes;
}

export interface ModeReport {
  /** rad/s */
  omega: number;
  /** Hz */
  frequency: number;
  residual: number;
  name: ModeName;
  component: number;
  /** laplacian: which principal axis it moves along */
  along?: string;
  /** the model has no physical frequencies: only their ratios mean something */
  nominal?: true;
}

const AXES = ['shortest', 'middle', 'longest'];

/** The keys of the report about vibration: model, components, zeroModes, modes, solve. */
export function modesReport(sets: ModeSet[]) {
  const components: ComponentReport[] = [];
  const modes: ModeReport[] = [];
  // No spread here: a file may have more parts than a call can take arguments.
  for (const set of sets) {
    const first = components.length;
    for (const mode of set.modes) modes.push(modeReport(mode, set.components[mode.component].model, first));
    for (const { faces, model, zeroModesExpected, zeroModesFound } of set.components)
      components.push({ faces, model, zeroModes: { expected: zeroModesExpected, found: zeroModesFound } });
  }
  modes.sort((a, b) => a.omega - b.omega || a.component - b.component);
  const models = new Set(components.map(({ model }) => model));
  return {
    model: models.size === 1 ? components[0].model : ('mixed' as const),
    components,
    zeroModes: {
      expected: sum(components.map(({ zeroModes }) => zeroModes.expected)),
      found: sum(components.map(({ zeroModes }) => zeroModes.found)),
    },
    modes,
    solve: solveReport(sets),
  };
}

function solveReport(sets: ModeSet[]): SolveReport {
  const largest = (values: number[]) => values.reduce((most, value) => Math.max(most, value), 0);
  const coarseVertices = largest(sets.map(coarseVerticesOf));
  const factorNonzeros = largest(sets.map((set) => set.factorNonzeros));
  return coarseVertices > 0
    ? { exact: false, coarseVertices, factorNonzeros }
    : { exact: true, factorNonzeros };
}

function modeReport(mode: ModeSet['modes'][number], model: Model, firstComponent: number): ModeReport {
  const { omega, residual, component, axis, name } = mode;
  return {
    omega,
    frequency: omega / (2 * Math.PI),
    residual,
    name,
    component: firstComponent + component,
    ...(axis >= 0 ? { along: AXES[axis] } : {}),
    ...(model === 'laplacian' ? { nominal: true as const } : {}),
  };
}
