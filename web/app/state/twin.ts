/** The state of the Test step: both bodies in motion, and how they are shown. */

import { computed, signal } from '@preact/signals';
import type { CollisionScene } from '../../engine/core/core';
import { defaultModelOf } from '../../engine/motion/default_model';
import type { DefaultModel } from '../../engine/motion/default_model';
import type { TwinSample } from '../../engine/motion/twin';
import type { TunedBody } from '../../engine/solvers/tuned_body';
import type { TwinFrame } from '../worker/simulation_protocol';
import { STAGES } from '../../engine/stages/stages';
import { results, view, wantedKey, wants } from './store';

/** Where the pins come from: the scenario, the two upper corners, or the Motion step. */
export type PinSource = 'scenario' | 'corners' | 'pins';

export const twin = {
  playing: signal(!matchMedia('(prefers-reduced-motion: reduce)').matches),
  layout: signal<'beside' | 'over'>('beside'),
  /** draw the original as the optimized body carries it */
  driven: signal(false),
  heat: signal(false),
  /** measure the noise floor even if the motion then becomes slower than real time */
  alwaysNoise: signal(false),
  /** simulate the result with its tuned parameters in the solver of the settings */
  wantsTuned: signal(false),
  /** the user does not know in which solver the result will move; only used while the settings name none */
  isSolverUnknown: signal(false),
  /** whether the model is wanted with settings for all generic solvers */
  wantsGeneric: signal(false),
  /** null: the pins of the Motion step if there are any */
  chosenPinSource: signal<PinSource | null>(null),
  /** what is on screen; null until a simulation has started */
  frame: signal<TwinFrame | null>(null),
  /** the latest frame, updated a few times a second, for displayed numbers */
  numbers: signal<TwinFrame | null>(null),
  samples: signal<TwinSample[]>([]),
  /** the largest deviation of any point since the start, % */
  worst: signal(0),
  /** what both bodies can touch */
  collisionScene: signal<CollisionScene | null>(null),
  /** why nothing can be simulated, in one sentence */
  failure: signal<string | null>(null),
};

/** The chosen source of the pins, or a fitting one if none is chosen or there are no pins. */
export const pinSource = computed<PinSource>(() => {
  const hasPins = wants.settings.value.pins !== '';
  const { value: chosen } = twin.chosenPinSource;
  if (chosen === null) return hasPins ? 'pins' : 'scenario';
  return chosen === 'pins' && !hasPins ? 'scenario' : chosen;
});

/** Whether the shown result has to be tuned for the Test step. */
export const isTuningWanted = computed(
  () => view.step.value === 'test' && twin.wantsTuned.value && wants.settings.value.solver !== 'none',
);

/** The simulated tuning; null: the untuned result, also until it has been tuned. */
export const usedTuning = computed<TunedBody | null>(() => {
  const { value: found } = results.tuned;
  if (!isTuningWanted.value || !found) return null;
  return found.key === wantedKey(STAGES.tuned) ? found.tuned : null;
});

/** The models with which the shown body can move without the solver of an engine. */
export const defaultModel = computed<DefaultModel>(() => {
  const { value: body } = results.body;
  return body ? defaultModelOf(body.inspection) : 'solid';
});

/** Whether original and result have an inside: cells of the same size in both. A calibrated body is a shell. */
export const haveLattice = computed(() => {
  const { solver, material, calibrate } = wants.settings.value;
  return solver === 'none' && material === 'solid' && !calibrate && defaultModel.value !== 'shell';
});
