/** The page's whole state: what the user wants, what has been computed from which inputs, how it is looked at. */

import { computed, signal } from '@preact/signals';
import type { Curvature, MeshAt, Progress, StrainGuidance } from '../../engine/core/core';
import { defaultSettings } from '../../engine/settings/options';
import type { Settings } from '../../engine/settings/options';
import { keyOf } from '../../engine/stages/stage';
import { STAGES } from '../../engine/stages/stages';
import type { Refusal } from './refusal';
import type {
  BodySummary,
  DeviationMarks,
  ExportResult,
  FitResult,
  HistorySummary,
  ModesResult,
  OpenedFile,
  PinsResult,
  ResultMetrics,
  WhyResult,
} from '../worker/protocol';

export type Step = 'model' | 'motion' | 'reduce' | 'test';
export type Layout = 'both' | 'slider' | 'original' | 'optimized';
export type FieldName = 'none' | 'strain' | 'curvature';
export type BrushTool = 'keep' | 'lock' | 'erase';
export type Theme = 'system' | 'light' | 'dark';

export interface Notice {
  kind: 'error' | 'info';
  text: string;
}

/** What the user wants. */
export const wants = {
  settings: signal<Settings>(defaultSettings()),
  body: signal(0),
  /** kept faces of the shown body; null: half */
  faces: signal<number | null>(null),
  exportOpen: signal(false),
  exportFields: signal(false),
  exportBinding: signal(false),
};

/** What has been computed; null until it is. `opened` counts files, so that results of an earlier one are never shown. */
export const results = {
  opened: signal(0),
  file: signal<OpenedFile | null>(null),
  body: signal<BodySummary | null>(null),
  pins: signal<PinsResult | null>(null),
  modes: signal<ModesResult | null>(null),
  guidance: signal<StrainGuidance | null>(null),
  curvature: signal<Curvature | null>(null),
  history: signal<HistorySummary | null>(null),
  marks: signal<DeviationMarks | null>(null),
  mesh: signal<MeshAt | null>(null),
  fitted: signal<FitResult | null>(null),
  metrics: signal<ResultMetrics | null>(null),
  why: signal<WhyResult | null>(null),
  exported: signal<ExportResult | null>(null),
};

/** How it is looked at. */
export const view = {
  step: signal<Step>('model'),
  layout: signal<Layout>('both'),
  /** of the stage: how much of it shows the original where both lie over each other */
  split: signal(0.5),
  field: signal<FieldName>('strain'),
  wire: signal(true),
  playing: signal(!matchMedia('(prefers-reduced-motion: reduce)').matches),
  amplitude: signal(8),
  speed: signal(1),
  theme: signal<Theme>('system'),
  helpOpen: signal(false),
  /** the vertex of the optimized mesh whose reasons are told, and whether it stays when the pointer leaves it */
  probe: signal<{ vertex: number; isHeld: boolean } | null>(null),
  /** the stage's left button pins vertices instead of turning the view */
  picking: signal(false),
  /** what the left button paints on the Reduce step, null: it turns the view; radius in % of the diagonal, softness 0..1 */
  brush: signal<{ tool: BrushTool | null; radius: number; softness: number }>({
    tool: null,
    radius: 6,
    softness: 0.5,
  }),
};

/** What is going on. */
export const status = {
  /** whether stages are running or about to */
  working: signal(false),
  busy: signal<{ what: string; progress: Progress | null } | null>(null),
  /** what was cancelled and waits for a word */
  paused: signal<string | null>(null),
  notice: signal<Notice | null>(null),
  /** the last text for the pins that does not hold, and why */
  refusedPins: signal<Refusal | null>(null),
  threads: signal(0),
};

export function changeSettings(change: Partial<Settings>): void {
  wants.settings.value = { ...wants.settings.value, ...change };
}

/** Whether the shown modes are those of earlier settings: others are on their way, or could not be found. */
export const areModesStale = computed(
  () => results.modes.value !== null && results.modes.value.key !== keyOf(STAGES.modes, wants.settings.value),
);

/** What is shown as optimized: the mesh of the history while the slider moves, the fitted one once that is there. */
export const shownMesh = computed(() => shownFit.value?.result ?? results.mesh.value);

/** What the fit of the shown mesh says; null until it is done. */
export const shownFit = computed(() => {
  const { value: fitted } = results.fitted;
  const settings = { ...wants.settings.value, targetFaces: wantedFaces.value };
  return fitted?.key === keyOf(STAGES.fitted, settings) ? fitted : null;
});

/** The reasons of the shown result, once they are known. */
export const shownWhy = computed(() => {
  const { value: why } = results.why;
  return why?.key === whyKey() ? why : null;
});

/** Of the reasons that the shown result asks for. */
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

/** How many faces the shown body should keep. */
export const wantedFaces = computed(() => {
  const total = results.body.value ? results.body.value.mesh.triangles.length / 3 : 0;
  return wants.faces.value ?? Math.floor(total / 2);
});
