/** The options of the library's calls: settings by the names of the table, and others. */

import type { Document } from '@gltf-transform/core';
import type { VibrationReport } from '../engine/report/fidelity_report';
import type { SimulationReport } from '../engine/report/motion_report';
import type { Report, ReportWith } from '../engine/report/report';
import type { LevelReport } from '../engine/report/result_report';
import type { FidelityReport } from '../engine/report/solver_report';
import type { CommandSettings, SettingName } from '../engine/settings/options';
import type { SolverName } from '../engine/solvers/profiles';

/** A file with its name, which may include a path relative to the other files. */
export interface ModelFile {
  name: string;
  bytes: Uint8Array;
}

/** Bytes of a result in a buffer of their own, which Blob, fetch and others accept. */
export type ResultBytes = Uint8Array<ArrayBuffer>;

/** A file of a result. */
export interface ResultFile extends ModelFile {
  bytes: ResultBytes;
}

/**
 * A model to work on: a document of glTF-Transform, the bytes of a GLB, or a list of files: a GLB, glTF, OBJ, STL, PLY or OFF file
 * with the files that it refers to, or a ZIP of these.
 */
export type Model = Document | Uint8Array | ArrayBuffer | readonly ModelFile[];

/** The settings of `limber inspect`; the README lists all settings by their flags. `maxDeviation` is --max-deviation. */
export type InspectOptions = Partial<CommandSettings<'inspect'>>;

export type CompareOptions = Partial<CommandSettings<'compare'>>;

export interface OptimizeOptions extends Partial<CommandSettings<'optimize'>> {
  /** the largest number of faces to keep, of the whole file */
  faces?: number;
  /** the share of faces to keep, in (0, 1]; 0.5 if no other target is given */
  ratio?: number;
  /** whether to write strain and curvature as attributes _STRAIN and _CURVATURE */
  fields?: boolean;
  /** whether to find where each original vertex lies on the result, and return it as `binding` */
  bind?: boolean;
  /** whether to check the written files with the Khronos validator (default: true); errors that the model does not have are noted */
  validate?: boolean;
}

export interface TuneOptions extends Partial<CommandSettings<'tune'>> {
  solver: SolverName;
}

export interface ModesOptions extends Partial<CommandSettings<'modes'>> {
  /** whether to write the modes as morph targets, each with an animation, and return this GLB as `shapes` */
  writesShapes?: boolean;
}

export interface SimulateOptions extends Partial<CommandSettings<'simulate'>> {
  /** the `binding` that `optimize` has returned, by which pins are transferred to the other model; null: by closest points */
  binding?: string | null;
  /** the `settingsFile` that `optimize` or `tune` has returned, with which the other model is simulated; null: without one */
  settingsFile?: string | null;
  /** whether to write the motion as morph targets with an animation, and return this GLB as `recording` */
  records?: boolean;
}

/** The progress of a run. */
export interface StageProgress {
  /** the body that is worked on; '' before the first */
  body: string;
  /** the stage of its run: "modes", "history", "fitted" and so on; "opening" before the first */
  stage: string;
  /** what the core does in it: "solving for modes" */
  phase: string;
  /** of the phase, in [0, 1] */
  fraction: number;
}

export interface RunOptions {
  /** Aborting it ends the work; the promise is then rejected with its reason. */
  signal?: AbortSignal;
  onProgress?: (progress: StageProgress) => void;
  /**
   * Browsers only: the address of a folder with the files of `limber/assets`, for pages whose content security policy
   * forbids scripts and workers from blobs. It applies to later calls, too.
   */
  assets?: string | URL;
}

export interface Level {
  /** the bytes of its first file; null if the level is in the file of the result itself (`lodStyle`) */
  glb: ResultBytes | null;
  /** all of its files, `glb` first, under names of their own: NAME_lod1.glb and so on */
  files: ResultFile[];
  report: LevelReport;
}

/** A level with files of its own. */
export interface FileLevel extends Level {
  glb: ResultBytes;
}

/** The report and the notes of a call. The type of the report requires the parts that the call always produces. */
export interface Reported<OfCall extends Report = Report> {
  report: OfCall;
  /** notes on the run, as clauses: "164 seam vertices welded" */
  notes: string[];
}

export type OptimizeReport = ReportWith<'output' | 'surface' | 'stop'>;

interface Optimized<OneLevel extends Level> extends Reported<OptimizeReport> {
  /** one for each of `lods` */
  levels: OneLevel[];
  /** the text of the binding file; null without `bind` */
  binding: string | null;
  /** the text of the settings file; null without a solver */
  settingsFile: string | null;
}

export interface OptimizedDocument extends Optimized<FileLevel> {
  /** the document that was given, changed */
  document: Document;
}

export interface OptimizedGlb<OneLevel extends Level = Level> extends Optimized<OneLevel> {
  /** the bytes of the first file: a GLB unless `format` names another format */
  glb: ResultBytes;
  /**
   * All files of the result, that one first: a glTF has a buffer and images, an OBJ has materials. They have the name of the model, or
   * `model` if it came without one, with the extension of the format. Those of the levels fit into the same folder.
   */
  files: ResultFile[];
}

/** `fidelity` has the errors of the vibration, or says in `failure` why they are missing, and none of solvers. */
export type CompareReport = ReportWith<'output' | 'surface'> & { fidelity: VibrationReport };

/** `fidelity` has only the errors in the solver. */
export type TuneReport = ReportWith<'output'> & { fidelity: Required<Pick<FidelityReport, 'solvers'>> };

export interface TuneResult extends Reported<TuneReport> {
  settingsFile: string;
}

export type ModesReport = ReportWith<'model' | 'components' | 'zeroModes' | 'modes' | 'solve'>;

export interface ModesResult extends Reported<ModesReport> {
  /** null without `writesShapes` */
  shapes: ResultBytes | null;
}

export type SimulateReport = ReportWith<'simulation'>;

/** The report on two models. */
export type SimulatePairReport = SimulateReport &
  ReportWith<'output'> & {
    simulation: Required<Pick<SimulationReport, 'optimized' | 'speedup' | 'edgeRatio' | 'deviation'>>;
  };

export interface SimulateResult<OfCall extends SimulateReport = SimulateReport> extends Reported<OfCall> {
  /** null without `records` */
  recording: ResultBytes | null;
}

/** Bad input or an internal error. Its message is one sentence that says what is wrong, where, and what to do. */
export class LimberError extends Error {
  override readonly name = 'LimberError';

  constructor(
    message: string,
    /** the setting that is refused; null if it is something else */
    readonly setting: SettingName | null = null,
    /** whether the error is a bug in Limber; please report it */
    readonly isInternal = false,
  ) {
    super(message);
  }
}
