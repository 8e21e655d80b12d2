/** Limber as a library. Nothing is loaded or started before the first call. */

export { close, compare, inspect, limber, modes, optimize, simulate, tune } from './calls';
export { LimberError } from './options';
export type {
  CompareOptions,
  CompareReport,
  FileLevel,
  InspectOptions,
  Level,
  Model,
  ModelFile,
  ModesOptions,
  ModesReport,
  ModesResult,
  OptimizedDocument,
  OptimizedGlb,
  OptimizeOptions,
  OptimizeReport,
  Reported,
  ResultBytes,
  ResultFile,
  RunOptions,
  SimulateOptions,
  SimulatePairReport,
  SimulateReport,
  SimulateResult,
  StageProgress,
  TuneOptions,
  TuneReport,
  TuneResult,
} from './options';
export type { Report } from '../engine/report/report';
export type { LevelReport } from '../engine/report/result_report';
export type { Settings } from '../engine/settings/options';
export { VERSION as version } from '../engine/core/version';
