/** The whole state of the page: the user's settings, the results computed from them, and the display. */

import { faceCount } from '../../engine/core/mesh';
import { computed, signal } from '@preact/signals';
import type { Curvature, MeshAt, StrainGuidance } from '../../engine/core/core';
import { defaultSettings } from '../../engine/settings/options';
import type { Settings } from '../../engine/settings/options';
import { keyOf } from '../../engine/stages/stage';
import type { Stage } from '../../engine/stages/stage';
import { STAGES } from '../../engine/stages/stages';
import type { Refusal } from './refusal';
import type {
  BodySummary,
  DeviationMarks,
  DrawnLevels,
  ExportResult,
  GenericFiles,
  FitResult,
  TunedResult,
  HistorySummary,
  ModesResult,
  OverviewResult,
  OpenedFile,
  PinsResult,
  CallProgress,
  KeptFaces,
  ResultFile,
  ResultMetrics,
  SharesResult,
  WhyResult,
} from '../worker/protocol';

export type Step = 'model' | 'motion' | 'reduce' | 'test';
export type Layout = 'both' | 'slider' | 'original' | 'optimized';
export type FieldName = 'none' | 'strain' | 'curvature';
export type LookName = 'textured' | 'matcap' | 'clay' | 'checker';
export type BrushTool = 'keep' | 'lock' | 'erase';
export type Theme = 'system' | 'light' | 'dark';

export interface Notice {
  kind: 'error' | 'info';
  text: string;
  /** a button next to the text */
  action?: { label: string; run(): void };
}

/** The user's settings. */
export const wants = {
  settings: signal<Settings>(defaultSettings()),
  body: signal(0),
  /** kept faces of all bodies without a number of their own; null: half */
  faces: signal<number | null>(null),
  /** kept faces of bodies that have a number of their own, by the number of the body */
  own: signal<ReadonlyMap<number, number>>(new Map()),
  exportOpen: signal(false),
  exportFields: signal(false),
  exportBinding: signal(false),
  /** whether levels of detail are displayed */
  levelsShown: signal(false),
};

/** The computed results; null until then. `opened` counts files, so that results of an earlier file are never shown. */
export const results = {
  opened: signal(0),
  file: signal<OpenedFile | null>(null),
  body: signal<BodySummary | null>(null),
  pins: signal<PinsResult | null>(null),
  modes: signal<ModesResult | null>(null),
  overview: signal<OverviewResult | null>(null),
  guidance: signal<StrainGuidance | null>(null),
  curvature: signal<Curvature | null>(null),
  history: signal<HistorySummary | null>(null),
  /** how faces are distributed among the bodies; not needed for a file with one body */
  shares: signal<SharesResult | null>(null),
  marks: signal<DeviationMarks | null>(null),
  mesh: signal<MeshAt | null>(null),
  fitted: signal<FitResult | null>(null),
  tuned: signal<TunedResult | null>(null),
  metrics: signal<ResultMetrics | null>(null),
  why: signal<WhyResult | null>(null),
  exported: signal<ExportResult | null>(null),
  genericFiles: signal<GenericFiles | null>(null),
  /** the file as a GLB, for drawing with its materials */
  originalFile: signal<Uint8Array | null>(null),
  resultFile: signal<ResultFile | null>(null),
  drawnLevels: signal<DrawnLevels | null>(null),
};

/** The display of bodies. */
export const view = {
  step: signal<Step>('model'),
  layout: signal<Layout>('both'),
  /** the share of the viewport that shows the original in the slider layout */
  split: signal(0.5),
  /** the field that colours the mesh on each step */
  fields: signal<Record<Step, FieldName>>({ model: 'none', motion: 'strain', reduce: 'none', test: 'none' }),
  /** the look of a mesh without a field */
  look: signal<LookName>('textured'),
  isFlat: signal(false),
  /** whether the stage shows the whole scene, not just the chosen body */
  isWhole: signal(true),
  /** indices of hidden bodies */
  hidden: signal<ReadonlySet<number>>(new Set()),
  /** whether the file's own animation plays */
  animated: signal(false),
  /** whether the meshes swing on the Reduce step */
  swings: signal(false),
  /** null: if triangles are large enough to be distinguished */
  wire: signal<boolean | null>(null),
  playing: signal(!matchMedia('(prefers-reduced-motion: reduce)').matches),
  amplitude: signal(8),
  speed: signal(1),
  theme: signal<Theme>('system'),
  helpOpen: signal(false),
  /** the panel shown in a narrow window, which has room for one */
  sheet: signal<'settings' | 'facts' | 'closed'>('settings'),
  /** the vertex of the optimized mesh whose card is shown, and whether the card stays when the pointer leaves it */
  hover: signal<{ vertex: number; stays: boolean } | null>(null),
  /** whether the left button pins vertices instead of rotating the view */
  picking: signal(false),
  /** what the left button paints on the Reduce step (null: it rotates the view); radius in % of the diagonal, softness 0..1 */
  brush: signal<{ tool: BrushTool | null; radius: number; softness: number }>({
    tool: null,
    radius: 6,
    softness: 0.5,
  }),
};

const isComputing = signal(false);
const isReplaying = signal(false);

/** The current activity of the page. */
export const status = {
  /** whether the runner has tasks to run */
  isComputing,
  /** whether the history is being replayed */
  isReplaying,
  /** whether stages are running or about to run */
  working: computed(() => isComputing.value || isReplaying.value),
  /** `left`: remaining seconds of the current phase, or of all bodies, see remaining.ts */
  busy: signal<{ what: string; progress: CallProgress | null; left: number | null } | null>(null),
  /** the stopped tasks, which wait to be resumed */
  paused: signal<readonly string[]>([]),
  notice: signal<Notice | null>(null),
  /** the last refused text for the pins, and the reason */
  refusedPins: signal<Refusal | null>(null),
  threads: signal(0),
};

/** The field that colours the mesh on this step. */
export const shownField = computed(() => view.fields.value[view.step.value]);

export function chooseField(field: FieldName): void {
  view.fields.value = { ...view.fields.value, [view.step.value]: field };
}

export function changeSettings(change: Partial<Settings>): void {
  wants.settings.value = { ...wants.settings.value, ...change };
}

/** Whether the shown modes belong to earlier settings: new ones are being computed, or could not be found. */
export const areModesStale = computed(
  () => results.modes.value !== null && results.modes.value.key !== keyOf(STAGES.modes, wants.settings.value),
);

/** The comparison of the shown modes; null until it has been made. */
export const shownOverview = computed(() => {
  const { value: made } = results.overview;
  return made && made.key === results.modes.value?.key ? made : null;
});

/** Whether the history belongs to earlier settings: a new one is being made, was cancelled, or could not be made. */
export const isHistoryStale = computed(
  () =>
    results.history.value !== null &&
    results.history.value.key !== keyOf(STAGES.history, wants.settings.value),
);

/** The mesh shown as optimized: that of the history while the slider moves, then the fitted one. */
export const shownMesh = computed(() => shownFit.value?.result ?? results.mesh.value);

/** The key of a stage's result for the current settings and faces. */
export const wantedKey = (stage: Stage<unknown, keyof Settings | 'fewestFaces' | 'targetFaces'>): string =>
  keyOf(stage, { ...wants.settings.value, targetFaces: wantedFaces.value });

/** The fit of the shown mesh; null until it is finished. */
export const shownFit = computed(() => {
  const { value: fitted } = results.fitted;
  return fitted?.key === wantedKey(STAGES.fitted) ? fitted : null;
});

/** Whether a limit on the deviation or on the frequencies has stopped the shown result above the wanted faces. */
export const isLimited = computed(() => {
  const { value: fit } = shownFit;
  return fit !== null && (fit.guard !== null || fit.frequency?.isBinding === true);
});

/** The measures of the shown mesh; null until they are finished. */
export const shownMetrics = computed(() => {
  const { value: metrics } = results.metrics;
  return metrics?.key === wantedKey(STAGES.measured) ? metrics : null;
});

/** Why the vertices of the shown result are kept; null until known. */
export const shownWhy = computed(() => {
  const { value: why } = results.why;
  return why?.key === whyKey() ? why : null;
});

/** Whether the stage draws files with their materials, if it has them. */
export const isFileDrawn = computed(() => {
  const { value: step } = view.step;
  if (shownField.value !== 'none' || isBrushing.value) return false;
  return step === 'model' || (step === 'reduce' && !view.swings.value);
});

/** The key of the reasons for the shown result. */
export const whyKey = (): string =>
  keyOf(STAGES.explanation, {
    ...wants.settings.value,
    targetFaces: (shownMesh.value?.mesh.triangles.length ?? 0) / 3,
  });

/** Whether the pick tool is in use. */
export const isPicking = computed(
  () => view.picking.value && view.step.value === 'motion' && results.body.value !== null,
);

/** Whether the brush is in use. */
export const isBrushing = computed(
  () => view.brush.value.tool !== null && view.step.value === 'reduce' && results.body.value !== null,
);

/** Whether the shown body takes its faces from a number that several bodies share. */
export const isSharing = computed(
  () => (results.file.value?.bodies.length ?? 0) > 1 && !wants.own.value.has(wants.body.value),
);

/** The numbers of faces to keep, in the form of the worker's calls. */
export const keptFaces = computed((): KeptFaces => ({
  faces: (results.file.value?.bodies.length ?? 0) > 1 ? wants.faces.value : wantedFaces.value,
  own: [...wants.own.value],
}));

/** The number of faces that the shown body should keep. */
export const wantedFaces = computed((): number => {
  const total = results.body.value ? faceCount(results.body.value.mesh) : 0;
  const half = Math.floor(total / 2);
  const own = wants.own.value.get(wants.body.value);
  if (isSharing.value) return results.shares.value?.targets[wants.body.value] ?? half;
  return own ?? wants.faces.value ?? half;
});

/** The state of the slider of the kept faces. */
export const slider = computed(() => {
  const { value: history } = results.history;
  const { value: shares } = results.shares;
  if (isSharing.value)
    return {
      isReady: shares !== null,
      fewest: shares?.fewest ?? 0,
      faces: shares?.faces ?? 0,
      wanted: wants.faces.value ?? shares?.wanted ?? 0,
      refused: shares?.refused ?? null,
    };
  return {
    isReady: history !== null,
    fewest: history?.floorFaces ?? 0,
    faces: history?.faces ?? results.body.value?.inspection.faces ?? 0,
    wanted: wantedFaces.value,
    refused: history?.refused ?? null,
  };
});

/** Sets the number of faces of the bodies that the slider controls. */
export function keepFaces(faces: number): void {
  if (wants.own.value.has(wants.body.value)) setOwnFaces(faces);
  else wants.faces.value = faces;
}

/** Gives the shown body its own number of faces; null: it shares with the others again. */
export const setOwnFaces = (faces: number | null): void => setFacesOf(wants.body.value, faces);

/** Gives any body its own number of faces; null: it shares with the others again. */
export function setFacesOf(body: number, faces: number | null): void {
  const own = new Map(wants.own.value);
  if (faces === null) own.delete(body);
  else own.set(body, faces);
  wants.own.value = own;
}
