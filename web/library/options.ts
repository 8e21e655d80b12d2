/** The options of the library's calls: settings by the names of the table, and others. */

import type { Document } from '@gltf-transform/core';
import type { Fidelity } from '../engine/core/core';
import type { SimulationReport } from '../engine/report/motion_report';
import type { Report, ReportWith } from '../engine/report/report';
import type { LevelReport } from '../engine/report/result_report';
import type { FidelityReport } from '../engine/report/solver_report';
import type { CommandSettings, SettingName } from '../engine/settings/options';
import type { SolverName } from '../engine/solvers/profiles';

/** A file by name; a name may have a path relative to the other files. */
export interface ModelFile {
  name: string;
  bytes: Uint8Array;
}

/** Bytes of a result in a buffer of their own, as Blob, fetch and others require. */
export type ResultBytes = Uint8Array<ArrayBuffer>;

/** A file of a result. */
export interface ResultFile extends ModelFile {
  bytes: ResultBytes;
}

/**
 * A mesh to work on: a document of glTF-Transform, the bytes of a GLB, or a GLB, glTF, OBJ, STL, PLY or OFF file with the
 * files that it names, or a ZIP of these.
 */
export type Model = Document | Uint8Array | ArrayBuffer | readonly ModelFile[];

/** Settings by name, as in the table of the README without dashes (`strainWeight` is --strain-weight). */
export type InspectOptions = Partial<CommandSettings<'inspect'>>;

export type CompareOptions = Partial<CommandSettings<'compare'>>;

export interface OptimizeOptions extends Partial<CommandSettings<'optimize'>> {
  /** the most faces that may be left, of the whole file */
  faces?: number;
  /** the share of faces to keep, in (0, 1]; 0.5 without any other target */
  ratio?: number;
  /** write strain and curvature as attributes _STRAIN and _CURVATURE */
  fields?: boolean;
  /** find where each original vertex lies on the result; `binding` of the result has it */
  bind?: boolean;
  /** whether the Khronos validator checks the files that are made, true by default; notes tell errors that the model has not */
  validate?: boolean;
}

export interface TuneOptions extends Partial<CommandSettings<'tune'>> {
  solver: SolverName;
}

export interface ModesOptions extends Partial<CommandSettings<'modes'>> {
  /** write the modes as morph targets with an animation each; `shapes` of the result has the GLB */
  writesShapes?: boolean;
}

export interface SimulateOptions extends Partial<CommandSettings<'simulate'>> {
  /** the text of a binding file of `optimize`, which pins are carried over by; null, as of a result without one: none */
  binding?: string | null;
  /** the text of a settings file of `optimize` or `tune`; null, as of a result without one: none */
  settingsFile?: string | null;
  /** write the motion as morph targets with an animation; `recording` of the result has the GLB */
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
  /** Ends the work; the promise is rejected with its reason. */
  signal?: AbortSignal;
  onProgress?: (progress: StageProgress) => void;
  /**
   * Browsers only: the address of a folder with the files of `limber/assets`, for pages whose content security policy
   * forbids scripts and workers from blobs. It counts for later calls, too.
   */
  assets?: string | URL;
}

export interface Level {
  /** the bytes of its first file; null where the level is in the file of the first (`lodStyle`) */
  glb: ResultBytes | null;
  /** all of its files, the first one first, under names of their own: NAME_lod1.glb and so on */
  files: ResultFile[];
  report: LevelReport;
}

/** A level with files of its own. */
export interface FileLevel extends Level {
  glb: ResultBytes;
}

/** The result of a call with its report, in whose type the parts that are always present are not optional. */
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
  /** the bytes that the command line writes under the same settings: the first file, of another format where `format` says so */
  glb: ResultBytes;
  /**
   * All files that are written, that one first; a glTF has a buffer and images, an OBJ its materials. They have the name of the
   * model, `model` where it came without one, with the ending of the format. Those of the levels fit into the same folder.
   */
  files: ResultFile[];
}

/** `fidelity` has the errors of the vibration, and none of solvers. */
export type CompareReport = ReportWith<'output' | 'surface'> & { fidelity: Fidelity };

/** `fidelity` has the errors in the solver alone. */
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

/** Of two models. */
export type SimulatePairReport = SimulateReport &
  ReportWith<'output'> & {
    simulation: Required<Pick<SimulationReport, 'optimized' | 'speedup' | 'edgeRatio' | 'deviation'>>;
  };

export interface SimulateResult<OfCall extends SimulateReport = SimulateReport> extends Reported<OfCall> {
  /** null without `records` */
  recording: ResultBytes | null;
}

/** Bad input or an error inside; its message is one sentence that says what is wrong, where, and what to do. */
export class LimberError extends Error {
  override readonly name = 'LimberError';

  constructor(
    message: string,
    /** the setting that is refused; null where it is not a setting */
    readonly setting: SettingName | null = null,
    /** whether the error is internal, which is worth a report */
    readonly isInternal = false,
  ) {
    super(message);
  }
}
