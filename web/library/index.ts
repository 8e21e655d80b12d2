/** Limber as a library. Nothing is loaded or started before the first call. */

export { close, compare, inspect, limber, modes, optimize, simulate, tune } from './calls';
export { LimberError } from './options';
export type {
  CommonOptions,
  Level,
  Model,
  ModelFile,
  ModesOptions,
  ModesResult,
  OptimizedDocument,
  OptimizedGlb,
  OptimizeOptions,
  Reported,
  RunOptions,
  SimulateOptions,
  SimulateResult,
  StageProgress,
  TuneOptions,
  TuneResult,
} from './options';
export type { Report } from '../engine/report/report';
export type { Settings } from '../engine/settings/options';
export { VERSION as version } from '../engine/core/version';
