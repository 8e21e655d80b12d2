/** The calls between the page and its one worker: plain data, with the bytes of files moved rather than copied. */

import type {
  CoreOptions,
  Curvature,
  Inspection,
  MeshAt,
  ModeSet,
  Progress,
  Refused,
  StrainGuidance,
  TriangleMesh,
  WhyKept,
} from '../../engine/core/core';
import type {
  Certificate,
  FittedResult,
  FrequencyFinding,
  GuardFinding,
} from '../../engine/body/body_result';
import type { HealthNote } from '../../engine/body/health';
import type { FileContents } from '../../engine/document/facts/contents';
import type { Body, SourceFile } from '../../engine/document/open';
import type { Validation } from '../../engine/document/validate';
import type { Stored } from '../../engine/document/write/compression';
import type { Report } from '../../engine/report/report';
import type { Settings } from '../../engine/settings/options';
import type { DeviationMark } from '../../engine/stages/budget/deviation_marks';
import { drawnSettings } from './export_form';
import { errorCurveStage } from '../../engine/stages/budget/error_curve';
import { keyOfFile } from '../../engine/stages/file_request';
import { keyOf } from '../../engine/stages/stage';
import type { TunedBody } from '../../engine/solvers/tuned_body';
import type { SharedFaces } from '../../engine/stages/budget/file_targets';
import type { ComparedMethod, MethodResult } from '../../engine/stages/equal_budget/equal_budget';

export interface Started {
  threads: number;
  /** the job's four words in shared memory; null in the single-threaded build */
  job: Int32Array | null;
}

export interface OpenedBody extends Pick<Body, 'name' | 'mesh' | 'isScaledUnevenly'> {
  faces: number;
  /** whether the scene shows it at other scales than that of its first node, too */
  isScaledDifferently: boolean;
  /** from the space of the mesh to that of the scene, column by column */
  nodeMatrix: number[];
  /** null: it cannot be used, and no export changes it */
  health: HealthNote[] | null;
}

/** The messages of the worker while a call runs. */
export interface CallProgress extends Progress {
  /** 0..1 of the work on all bodies of a file; absent: only the phase is known */
  share?: number;
}

export interface OpenedFile {
  name: string;
  format: string;
  bodies: OpenedBody[];
  /** the first body that can be used */
  first: number;
  contents: FileContents;
  /** bytes of all its files */
  size: number;
  /** how its vertices are stored */
  stored: Stored['kind'];
  notes: string[];
  /** what an export omits, in plain words */
  dropped: string[];
}

export interface BodySummary {
  mesh: TriangleMesh;
  diagonal: number;
  /** units of the file per unit of the mesh, by the node that uses the body */
  scale: number;
  inspection: Inspection;
  minAngle: number;
  meanMinAngle: number;
  health: HealthNote[];
  /** per vertex of the file: its vertex in `mesh`, or NONE */
  vertexOfSource: Uint32Array;
  /** names of attributes that can say which vertices are pinned */
  pinAttributes: string[];
}

/** The vertices pinned by a text. */
export interface PinsResult {
  text: string;
  /** of the prepared mesh, ascending */
  vertices: Uint32Array;
}

/** The regions of the body that each mode strains. */
export interface StrainOverview {
  /** strips[ordinal * STRIP + i]: mean strain rank of that mode along the body's longest axis */
  strips: Float32Array;
  /** ranks[ordinal * faces + t]: the strain rank of triangle t in that mode, 255 the highest */
  ranks: Uint8Array;
  /** shared[a * modesPerComponent + b]: the part of the hot faces of ordinal a that are hot in ordinal b too, see report/hot_spots.ts */
  shared: Float32Array;
}

export interface ModesResult extends ModeSet {
  /** of the stage, see keyOf */
  key: string;
}

export interface OverviewResult extends StrainOverview {
  /** of the modes, see keyOf */
  key: string;
}

export const STRIP = 24;

export interface HistorySummary {
  faces: number;
  floorFaces: number;
  refused: Refused;
  /** see isBlockedBySeams */
  blockedBySeams: boolean;
  /** a sentence if a symmetry is requested that the body does not have; otherwise empty */
  note: string;
  seconds: number;
  /** identifies the history for the worker that replays it, see replay.ts */
  replayId: string;
  /** of the stage, see keyOf */
  key: string;
}

export interface WhyResult extends WhyKept {
  /** of the stage, see keyOf */
  key: string;
}

export interface DeviationMarks {
  marks: DeviationMark[];
  /** of the stage, see keyOf */
  key: string;
}

export interface FitResult extends Omit<FittedResult, 'result'> {
  /** null: the level of the history at that number of faces, which the page already has */
  result: MeshAt | null;
  /** null if frequencies are not a target */
  frequency: FrequencyFinding | null;
  /** null if no deviation has stopped it */
  guard: GuardFinding | null;
  /** of the stage, see keyOf */
  key: string;
}

/** The result tuned to move like the original in the solver of the settings. */
export interface TunedResult {
  /** null without a solver */
  tuned: TunedBody | null;
  /** of the stage, see keyOf */
  key: string;
}

export interface ResultMetrics {
  /** of the measured result, see keyOf */
  key: string;
  minAngle: number;
  meanMinAngle: number;
  /** % of the diagonal */
  hausdorff: number;
  mean: number;
  certificate: Certificate;
  inspection: Inspection;
}

export interface ExportRequest {
  /** write strain and curvature as attributes */
  fields: boolean;
  /** write the binding of the original's vertices to the result */
  binding: boolean;
  /** name of the file, from which those of its levels follow */
  output: string;
}

export interface ExportedLevel {
  name: string;
  faces: number;
  bytes: Uint8Array;
  /** all files of it, that one first */
  files: SourceFile[];
  /** null if the validator does not support the format */
  validation: Validation | null;
}

/** A level of detail for drawing, whatever its saved format. */
export interface DrawnLevel {
  /** a GLB; not checked by the validator */
  bytes: Uint8Array;
  faces: number;
  /** largest distance from the original, % of the diagonal */
  deviation: number;
}

/** All levels, the first one first. */
export interface DrawnLevels {
  levels: DrawnLevel[];
  /** see drawnLevelsKey */
  key: string;
}

export interface ExportResult {
  bytes: Uint8Array;
  /** all files of the result, that one first */
  files: SourceFile[];
  /** null if the validator does not support the format */
  validation: Validation | null;
  /** of the opened file; null if the validator does not support its format */
  inputValidation: Validation | null;
  report: Report;
  faces: number;
  /** the most faces that all bodies together may have: `--faces` of the command line */
  targetFaces: number;
  levels: ExportedLevel[];
  /** text of the binding file; null: not requested */
  binding: string | null;
  /** text of the settings file of the solver; null: none */
  settings: string | null;
  /** what the format omits from the file, in plain words */
  lost: string[];
  /** see exportKey */
  key: string;
}

/** The model without a solver, and what each generic solver needs to move it like the original. */
export interface GenericFiles {
  /** a ZIP archive: the model, and a settings file for each solver */
  archive: Uint8Array;
  /** see exportedFilesKey */
  key: string;
}

/** The numbers of faces to keep. */
export interface KeptFaces {
  /** of all bodies without their own number together; null: `ratio` of their faces */
  faces: number | null;
  /** in (0, 1]; absent: half */
  ratio?: number;
  /** indices of bodies, and their own numbers of faces */
  own: [number, number][];
}

/** How faces are distributed among the bodies; see SharedFaces. */
export interface SharesResult extends SharedFaces {
  /** see sharesKey */
  key: string;
}

/** The result in its file, for drawing with its materials. */
export interface ResultFile {
  /** a GLB; not checked by the validator */
  bytes: Uint8Array;
  /** per body of the file: its number of faces; 0 if it is excluded */
  faces: number[];
  /** see resultFileKey */
  key: string;
}

/** Text that is equal if two results are the same file. */
export const resultFileKey = (settings: Settings, kept: KeptFaces): string =>
  exportedFilesKey(drawnSettings(settings), kept, { fields: false, binding: false, output: '' });

/** Text that is equal if all levels are the same. */
export const drawnLevelsKey = resultFileKey;

/** Text that is equal if faces are distributed in the same way. */
export const sharesKey = (settings: Settings, kept: KeptFaces): string =>
  [keyOf(errorCurveStage, settings), settings.maxDeviation, settings.perBody, JSON.stringify(kept)].join(
    '\n',
  );

/** Text that is equal if two exports are the same, including their reports, which quote every setting. */
export const exportKey = (settings: Settings, kept: KeptFaces, request: ExportRequest): string =>
  [exportedFilesKey(settings, kept, request), JSON.stringify(settings)].join('\n');

/** The same without the reports. */
export function exportedFilesKey(settings: Settings, kept: KeptFaces, request: ExportRequest): string {
  const { fields, binding, output } = request;
  const file = { settings, targets: [], fields };
  return [keyOfFile(file), JSON.stringify(kept), binding, output].join('\n');
}

/** Every call throws an Error with one sentence; a cancelled call throws an Error whose message is CANCELLED. */
export interface WorkerApi {
  /** `lifeLock`: see keepAlive. */
  start(
    options: Pick<CoreOptions, 'wasmFolder' | 'threads' | 'memory'>,
    onProgress: (progress: CallProgress) => void,
    lifeLock: string,
  ): Promise<Started>;
  /** See warm_up.ts; a call stops it. */
  warmUp(): Promise<void>;
  /** Each new history is also sent to this port, see replay.ts. */
  connect(port: MessagePort): void;
  open(files: SourceFile[]): Promise<OpenedFile>;
  /** The open file as a GLB with its companion files packed in, for drawing next to its result; see drawOriginal. */
  original(): Promise<Uint8Array>;
  /** The file with the result of every body, without the validator's verdict. */
  resultFile(settings: Settings, kept: KeptFaces): Promise<ResultFile>;
  /** The file with each level of detail, for display. */
  drawnLevels(settings: Settings, kept: KeptFaces): Promise<DrawnLevels>;
  prepare(body: number, settings: Settings): Promise<BodySummary>;
  /** Throws if the text of the pins refers to something that the body does not have. */
  pins(body: number, settings: Settings): Promise<PinsResult>;
  modes(body: number, settings: Settings): Promise<ModesResult>;
  /** Compares the strain of all modes. */
  overview(body: number, settings: Settings): Promise<OverviewResult>;
  guidance(body: number, settings: Settings): Promise<StrainGuidance>;
  curvature(body: number, settings: Settings): Promise<Curvature>;
  history(body: number, settings: Settings): Promise<HistorySummary>;
  marks(body: number, settings: Settings): Promise<DeviationMarks>;
  meshAt(body: number, settings: Settings, faces: number): Promise<MeshAt>;
  /** The exported mesh: fitted if the settings request it. */
  fit(body: number, settings: Settings, faces: number): Promise<FitResult>;
  /** Tunes the mesh of `fit` in the solver of the settings. */
  tune(body: number, settings: Settings, faces: number): Promise<TunedResult>;
  /** `faces`: of the result that is explained. */
  why(body: number, settings: Settings, faces: number): Promise<WhyResult>;
  measure(body: number, settings: Settings, faces: number): Promise<ResultMetrics>;
  /** The result of one method for the body at a number of faces; see resultAtBudget. */
  methodAtBudget(
    body: number,
    settings: Settings,
    budget: { name: ComparedMethod; faces: number },
  ): Promise<MethodResult>;
  /** The numbers of faces that the bodies keep; collapses the edges of all bodies first. */
  shares(settings: Settings, kept: KeptFaces): Promise<SharesResult>;
  export(settings: Settings, kept: KeptFaces, request: ExportRequest): Promise<ExportResult>;
  /** The same without a solver, with a settings file for each generic solver. */
  genericFiles(settings: Settings, kept: KeptFaces, request: ExportRequest): Promise<GenericFiles>;
  /** The files of archives, and the other files unchanged. Throws if an archive cannot be unpacked. */
  unpack(files: SourceFile[]): Promise<SourceFile[]>;
  /** A ZIP archive of files by name. */
  pack(files: Record<string, Uint8Array>): Promise<Uint8Array>;
}

export const CANCELLED = 'cancelled';

/** The beginning of an error message after which the core cannot be used any more; the reason follows. */
export const CORE_BROKEN = 'core broken: ';
