/** The whole state of the page: what the user wants, what has been computed from it, and how it is shown. */

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
  /** a button beside the text */
  action?: { label: string; run(): void };
}

/** What the user wants. */
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
  /** whether levels of detail are looked at */
  levelsShown: signal(false),
};

/** What has been computed; null until then. `opened` counts files, so that results of an earlier file are never shown. */
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
  /** how faces are shared out over the bodies; a file of one body needs none */
  shares: signal<SharesResult | null>(null),
  marks: signal<DeviationMarks | null>(null),
  mesh: signal<MeshAt | null>(null),
  fitted: signal<FitResult | null>(null),
  tuned: signal<TunedResult | null>(null),
  metrics: signal<ResultMetrics | null>(null),
  why: signal<WhyResult | null>(null),
  exported: signal<ExportResult | null>(null),
  genericFiles: signal<GenericFiles | null>(null),
  /** the file as a GLB, to be drawn with its materials */
  originalFile: signal<Uint8Array | null>(null),
  resultFile: signal<ResultFile | null>(null),
  drawnLevels: signal<DrawnLevels | null>(null),
};

/** How bodies are shown. */
export const view = {
  step: signal<Step>('model'),
  layout: signal<Layout>('both'),
  /** the share of the viewport that shows the original in the slider layout */
  split: signal(0.5),
  /** what the mesh is coloured by on each step */
  fields: signal<Record<Step, FieldName>>({ model: 'none', motion: 'strain', reduce: 'none', test: 'none' }),
  /** how a mesh without a field looks */
  look: signal<LookName>('textured'),
  isFlat: signal(false),
  /** whether the stage shows the whole scene, and not the chosen body alone */
  isWhole: signal(true),
  /** numbers of bodies that are not shown */
  hidden: signal<ReadonlySet<number>>(new Set()),
  /** whether the file's own animation plays */
  animated: signal(false),
  /** whether the meshes swing on the Reduce step */
  swings: signal(false),
  /** null: where triangles are large enough to be told apart */
  wire: signal<boolean | null>(null),
  playing: signal(!matchMedia('(prefers-reduced-motion: reduce)').matches),
  amplitude: signal(8),
  speed: signal(1),
  theme: signal<Theme>('system'),
  helpOpen: signal(false),
  /** the panel that a narrow window shows, which has room for one */
  sheet: signal<'settings' | 'facts' | 'closed'>('settings'),
  /** the vertex of the optimized mesh whose card is shown, and whether the card stays when the pointer leaves it */
  hover: signal<{ vertex: number; stays: boolean } | null>(null),
  /** whether the left button pins vertices instead of turning the view */
  picking: signal(false),
  /** what the left button paints on the Reduce step (null: it turns the view); radius in % of the diagonal, softness 0..1 */
  brush: signal<{ tool: BrushTool | null; radius: number; softness: number }>({
    tool: null,
    radius: 6,
    softness: 0.5,
  }),
};

const isComputing = signal(false);
const isReplaying = signal(false);

/** What is going on. */
export const status = {
  /** whether the runner has tasks to run */
  isComputing,
  /** whether the history is being replayed */
  isReplaying,
  /** whether stages are running or about to run */
  working: computed(() => isComputing.value || isReplaying.value),
  /** `left`: remaining seconds of the phase that the progress counts, or of all bodies, see remaining.ts */
  busy: signal<{ what: string; progress: CallProgress | null; left: number | null } | null>(null),
  /** the tasks that were stopped, and that wait to be run again */
  paused: signal<readonly string[]>([]),
  notice: signal<Notice | null>(null),
  /** the last text for the pins that was refused, and why */
  refusedPins: signal<Refusal | null>(null),
  threads: signal(0),
};

/** What the mesh is coloured by on this step. */
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

/** The comparison of the modes that are shown; null while it is still to be made. */
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

/** The mesh that is shown as optimized: that of the history while the slider moves, then the fitted one. */
export const shownMesh = computed(() => shownFit.value?.result ?? results.mesh.value);

/** The key that the result of a stage has where it is one of the wanted settings and faces. */
export const wantedKey = (stage: Stage<unknown, keyof Settings | 'fewestFaces' | 'targetFaces'>): string =>
  keyOf(stage, { ...wants.settings.value, targetFaces: wantedFaces.value });

/** The fit of the shown mesh; null until it is done. */
export const shownFit = computed(() => {
  const { value: fitted } = results.fitted;
  return fitted?.key === wantedKey(STAGES.fitted) ? fitted : null;
});

/** Whether a limit on the deviation or on the frequencies has ended the shown result above the wanted faces. */
export const isLimited = computed(() => {
  const { value: fit } = shownFit;
  return fit !== null && (fit.guard !== null || fit.frequency?.isBinding === true);
});

/** What has been measured on the shown mesh; null until it is done. */
export const shownMetrics = computed(() => {
  const { value: metrics } = results.metrics;
  return metrics?.key === wantedKey(STAGES.measured) ? metrics : null;
});

/** Why the vertices of the shown result are kept; null until it is known. */
export const shownWhy = computed(() => {
  const { value: why } = results.why;
  return why?.key === whyKey() ? why : null;
});

/** Whether the stage draws files with their materials, where it has them. */
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

/** Whether the shown body has faces from a number that several bodies share. */
export const isSharing = computed(
  () => (results.file.value?.bodies.length ?? 0) > 1 && !wants.own.value.has(wants.body.value),
);

/** How many faces are to be kept, as the worker is asked. */
export const keptFaces = computed((): KeptFaces => ({
  faces: (results.file.value?.bodies.length ?? 0) > 1 ? wants.faces.value : wantedFaces.value,
  own: [...wants.own.value],
}));

/** How many faces the shown body should keep. */
export const wantedFaces = computed((): number => {
  const total = results.body.value ? faceCount(results.body.value.mesh) : 0;
  const half = Math.floor(total / 2);
  const own = wants.own.value.get(wants.body.value);
  if (isSharing.value) return results.shares.value?.targets[wants.body.value] ?? half;
  return own ?? wants.faces.value ?? half;
});

/** What the slider of the kept faces shows. */
export const slider = computed(() => {
  const { value: history } = results.history;
  const { value: shares } = results.shares;
  if (isSharing.value)
    return {
      isReady: shares !== null,
      fewest: shares?.fewest ?? 0,
      faces: shares?.faces ?? 0,
      wanted: wants.faces.value ?? shares?.wanted ?? 0,
    };
  return {
    isReady: history !== null,
    fewest: history?.floorFaces ?? 0,
    faces: history?.faces ?? results.body.value?.inspection.faces ?? 0,
    wanted: wantedFaces.value,
  };
});

/** Keeps so many faces, of what the slider stands for. */
export function keepFaces(faces: number): void {
  if (wants.own.value.has(wants.body.value)) setOwnFaces(faces);
  else wants.faces.value = faces;
}

/** Gives the shown body a number of faces of its own; null: it shares with the others again. */
export const setOwnFaces = (faces: number | null): void => setFacesOf(wants.body.value, faces);

/** Gives any body a number of faces of its own; null: it shares with the others again. */
export function setFacesOf(body: number, faces: number | null): void {
  const own = new Map(wants.own.value);
  if (faces === null) own.delete(body);
  else own.set(body, faces);
  wants.own.value = own;
}
