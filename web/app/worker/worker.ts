/** The worker's entry: runs the engine, one call at a time. */

import { expose, transfer } from 'comlink';
import { zipSync } from 'fflate';
import { pinAttributes } from '../../engine/body/pin_attributes';
import { PHASES } from '../../engine/core/core';
import type { Core, History, Progress, TriangleMesh } from '../../engine/core/core';
import { loadCore } from '../../engine/core/load_core';
import { unpacked } from '../../engine/document/archive/read_zip';
import { contentsOf } from '../../engine/document/facts/contents';
import { droppedByExport } from '../../engine/document/export';
import { isGlb } from '../../engine/document/glb';
import { openModel } from '../../engine/document/open';
import type { OpenModel } from '../../engine/document/open';
import { validateGlb } from '../../engine/document/validate';
import type { Validation } from '../../engine/document/validate';
import { isBlockedBySeams } from '../../engine/report/stop_report';
import { checkSettings, defaultSettings } from '../../engine/settings/options';
import type { Settings } from '../../engine/settings/options';
import type { BodyRun } from '../../engine/stages/body_run';
import { FileRun } from '../../engine/stages/file_run';
import { requestFile, shareFaces } from '../../engine/stages/budget/file_targets';
import type { RequestedFile } from '../../engine/stages/budget/file_targets';
import { resultAtBudget } from '../../engine/stages/equal_budget/equal_budget';
import { FileOutput } from '../../engine/stages/file_output';
import type { WorkSpan } from '../../engine/stages/many_bodies/file_progress';
import { keyOf } from '../../engine/stages/stage';
import { STAGES } from '../../engine/stages/stages';
import { describeBodies, healthOf } from './bodies';
import { carrySettingErrors } from './errors';
import { drawnSettings } from './export_form';
import { drawLevels, drawOriginal, exportAll, exportForGeneric } from './exporting';
import { handOver } from './handing_over';
import { keepAlive } from './life';
import {
  CANCELLED,
  CORE_BROKEN,
  drawnLevelsKey,
  exportedFilesKey,
  exportKey,
  resultFileKey,
  sharesKey,
} from './protocol';
import type { CallProgress, KeptFaces, WorkerApi } from './protocol';
import type { HandedHistory } from './replay';
import { strainOverview } from './strain_overview';
import { warmUp } from './warm_up';

let core: Core;
let file: FileRun | null = null;
let tell: (progress: CallProgress) => void = () => undefined;
/** of the work on all bodies; null: the running call processes one body */
let span: WorkSpan | null = null;

/** Whether the engine is warming up. */
let isWarmingUp = false;

/** Reports the progress of the running call to the page. */
function tellProgress(progress: Progress): void {
  if (isWarmingUp) return;
  const share = span ? span.done + (span.next - span.done) * progress.fraction : undefined;
  tell({ ...progress, share });
}

/** Receives the progress of work on many bodies. */
function takeSpan(fresh: WorkSpan | null): void {
  span = fresh;
  // The progress of the last call of the core does not apply to the next one.
  if (core.job) Atomics.store(core.job, 1, PHASES.indexOf('idle'));
  tellProgress({ phase: 'idle', fraction: 0 });
}

function openedFile(): FileRun {
  if (!file) throw new Error('No file is open: open one first.');
  return file;
}

function runOf(body: number): BodyRun {
  const run = openedFile().runs[body];
  if (!run) throw new Error('No file is open: open one first.');
  return run;
}

let historyPort: MessagePort | null = null;
let handed: { history: History; id: string } | null = null;

/** Sends a history to the worker that replays it, unless that worker already has it; returns its id there. */
function handHistory(mesh: TriangleMesh, history: History): string {
  if (handed?.history === history) return handed.id;
  handed = { history, id: crypto.randomUUID() };
  historyPort?.postMessage({ id: handed.id, mesh, history } satisfies HandedHistory);
  return handed.id;
}

/** Errors lose their name on the way to the page: a cancelled call is identified by its message. */
async function translateErrors<T>(make: () => T | Promise<T>): Promise<T> {
  isWarmingUp = false;
  span = null;
  file?.progress.restart();
  try {
    return await make();
  } catch (error) {
    if (error instanceof WebAssembly.RuntimeError) throw new Error(CORE_BROKEN + error.message);
    throw error instanceof Error && error.name === 'Cancelled' ? new Error(CANCELLED) : error;
  }
}

/** What the page asks of the file: as the command line does. */
const askedOf = (settings: Settings, { faces, own, ratio }: KeptFaces, fields: boolean): RequestedFile => ({
  settings,
  fields,
  faces,
  ratio: faces === null ? (ratio ?? HALF) : null,
  own: new Map(own),
});

/** Prepares all bodies, so that an unusable file never replaces the open one; `notes`: on bodies that are skipped. */
function startRun(opened: OpenModel): { fresh: FileRun; notes: string[] } {
  const onProgress = opened.bodies.length > 1 ? takeSpan : undefined;
  const fresh = new FileRun(core, opened, { guides: true, onProgress, caller: 'page' });
  try {
    return { fresh, notes: fresh.prepare(defaultSettings()) };
  } catch (error) {
    fresh.dispose();
    throw error;
  }
}

/** The bytes of the open file if it is a GLB. */
let openedGlb: Uint8Array | null = null;
let inputVerdict: Promise<Validation> | null = null;

/** The validator only reads the input once, when a result is first compared with it. */
async function verdictOnInput(): Promise<Validation | null> {
  if (!openedGlb) return null;
  return (inputVerdict ??= validateGlb(openedGlb));
}

/** The share of the faces that is kept without a requested number. */
const HALF = 0.5;

/** The same files give the same archive. */
const ZIP_TIME = new Date(1980, 0, 1);

const api: WorkerApi = {
  start: async (options, onProgress, lifeLock) => {
    await keepAlive(lifeLock);
    tell = onProgress;
    core = await loadCore({ ...options, onProgress: tellProgress });
    return { threads: core.threads, job: core.job };
  },
  warmUp: async () => {
    isWarmingUp = true;
    await warmUp(core, () => isWarmingUp);
    isWarmingUp = false;
  },
  connect: (port) => {
    [historyPort, handed] = [port, null];
  },
  open: (files) =>
    translateErrors(async () => {
      const opened = await openModel(files);
      if (opened.bodies.length === 0)
        throw new Error(`${opened.name} has no triangles: export a mesh with faces.`);
      const { fresh, notes } = startRun(opened);
      file?.dispose();
      file = fresh;
      openedGlb = files.find(({ name, bytes }) => name === opened.name && isGlb(bytes))?.bytes ?? null;
      inputVerdict = null;
      return {
        name: opened.name,
        format: opened.format,
        bodies: describeBodies(fresh),
        first: fresh.usable[0].i,
        contents: contentsOf(opened),
        size: files.reduce((all, { bytes }) => all + bytes.length, 0),
        stored: opened.stored?.kind ?? 'none',
        notes: [...opened.notes, ...notes],
        dropped: droppedByExport(opened),
      };
    }),
  original: () =>
    translateErrors(async () => {
      const bytes = await drawOriginal(openedFile());
      return transfer(bytes, [bytes.buffer]);
    }),
  resultFile: (settings, kept) =>
    translateErrors(async () => {
      checkSettings(settings);
      const request = requestFile(openedFile(), askedOf(drawnSettings(settings), kept, false));
      const output = new FileOutput(openedFile(), request);
      output.fit();
      const bytes = await output.glb();
      const faces = openedFile().runs.map(() => 0);
      const { usable } = openedFile();
      output.writtenFacesOfBodies().forEach((written, n) => (faces[usable[n].i] = written));
      return transfer({ bytes, faces, key: resultFileKey(settings, kept) }, [bytes.buffer]);
    }),
  drawnLevels: (settings, kept) =>
    translateErrors(async () => {
      checkSettings(settings);
      const request = requestFile(openedFile(), askedOf(drawnSettings(settings), kept, false));
      const levels = await drawLevels(openedFile(), request);
      const buffers = levels.map(({ bytes }) => bytes.buffer);
      return transfer({ levels, key: drawnLevelsKey(settings, kept) }, buffers);
    }),
  prepare: (body, settings) =>
    translateErrors(() => {
      checkSettings(settings);
      const prepared = runOf(body).get(STAGES.prepared, settings);
      const { mesh, diagonal, inspection, quality, weld, body: source } = prepared;
      const { minAngle, meanMinAngle } = quality;
      const { document, bodies } = openedFile().model;
      return handOver({
        mesh,
        diagonal,
        scale: source.scale,
        inspection,
        minAngle,
        meanMinAngle,
        health: healthOf(prepared),
        vertexOfSource: weld.vertexOfSource,
        pinAttributes: pinAttributes(document, bodies[body]),
      });
    }),
  pins: (body, settings) =>
    translateErrors(() =>
      handOver({ text: settings.pins, vertices: runOf(body).get(STAGES.pinned, settings) }),
    ),
  modes: (body, settings) =>
    translateErrors(() => {
      checkSettings(settings);
      return handOver({ ...runOf(body).get(STAGES.modes, settings), key: keyOf(STAGES.modes, settings) });
    }),
  overview: (body, settings) =>
    translateErrors(() => {
      checkSettings(settings);
      const run = runOf(body);
      const { mesh } = run.get(STAGES.prepared, settings);
      const overview = strainOverview(core, mesh, run.get(STAGES.modes, settings));
      return handOver({ ...overview, key: keyOf(STAGES.modes, settings) });
    }),
  guidance: (body, settings) =>
    translateErrors(() => {
      checkSettings(settings);
      return handOver(runOf(body).get(STAGES.guidance, settings));
    }),
  curvature: (body, settings) => translateErrors(() => handOver(runOf(body).get(STAGES.curvature, settings))),
  history: (body, settings) =>
    translateErrors(() => {
      checkSettings(settings);
      const run = runOf(body);
      const history = run.get(STAGES.history, settings);
      const { triangleCount, trianglesAfter, refused } = history;
      const { note } = run.get(STAGES.constraints, settings);
      const prepared = run.get(STAGES.prepared, settings);
      const blockedBySeams = isBlockedBySeams(prepared, refused, settings);
      const floorFaces = trianglesAfter.at(-1) ?? triangleCount;
      const seconds = run.secondsOf(STAGES.history, settings);
      const replayId = handHistory(prepared.mesh, history);
      const key = keyOf(STAGES.history, settings);
      return { faces: triangleCount, floorFaces, refused, blockedBySeams, note, seconds, replayId, key };
    }),
  marks: (body, settings) =>
    translateErrors(() => ({
      marks: runOf(body).get(STAGES.deviationMarks, settings),
      key: keyOf(STAGES.deviationMarks, settings),
    })),
  meshAt: (body, settings, targetFaces) =>
    translateErrors(() => handOver(runOf(body).get(STAGES.level, { ...settings, targetFaces }))),
  fit: (body, settings, targetFaces) =>
    translateErrors(() => {
      const [run, own] = [runOf(body), { ...settings, targetFaces }];
      const fitted = run.get(STAGES.fitted, own);
      const isSame = fitted.result === run.get(STAGES.level, own);
      return handOver({ ...fitted, result: isSame ? null : fitted.result, key: keyOf(STAGES.fitted, own) });
    }),
  tune: (body, settings, targetFaces) =>
    translateErrors(() => {
      const own = { ...settings, targetFaces };
      return { tuned: runOf(body).get(STAGES.tuned, own), key: keyOf(STAGES.tuned, own) };
    }),
  why: (body, settings, targetFaces) =>
    translateErrors(() => {
      const own = { ...settings, targetFaces };
      return handOver({ ...runOf(body).get(STAGES.explanation, own), key: keyOf(STAGES.explanation, own) });
    }),
  measure: (body, settings, targetFaces) =>
    translateErrors(() => {
      const own = { ...settings, targetFaces };
      const measured = runOf(body).get(STAGES.measured, own);
      const { quality, distance, certificate, inspection } = measured;
      const { minAngle, meanMinAngle } = quality;
      const { hausdorff, mean } = distance;
      const key = keyOf(STAGES.measured, own);
      return { key, minAngle, meanMinAngle, hausdorff, mean, certificate, inspection };
    }),
  methodAtBudget: (body, settings, budget) =>
    translateErrors(() => {
      checkSettings(settings);
      return resultAtBudget(runOf(body), settings, budget);
    }),
  shares: (settings, kept) =>
    translateErrors(() => {
      checkSettings(settings);
      const shared = shareFaces(openedFile(), askedOf(settings, kept, false));
      return { ...shared, key: sharesKey(settings, kept) };
    }),
  export: (settings, kept, request) =>
    translateErrors(async () => {
      const fileRequest = requestFile(openedFile(), askedOf(settings, kept, request.fields));
      const done = {
        ...(await exportAll(openedFile(), fileRequest, request)),
        inputValidation: await verdictOnInput(),
      };
      const buffers = [done, ...done.levels].map(({ bytes }) => bytes.buffer);
      return transfer({ ...done, key: exportKey(settings, kept, request) }, buffers);
    }),
  genericFiles: (settings, kept, request) =>
    translateErrors(async () => {
      const { fields } = request;
      const own = { ...settings, solver: 'none', engine: '', tune: 'global', massRule: 'auto' } as const;
      const fileRequest = requestFile(openedFile(), askedOf(own, kept, fields));
      const files = await exportForGeneric(openedFile(), fileRequest, request);
      const archive = zipSync(files, { level: 6, mtime: ZIP_TIME });
      return transfer({ archive, key: exportedFilesKey(settings, kept, request) }, [archive.buffer]);
    }),
  unpack: (files) =>
    translateErrors(() => {
      const all = unpacked(files);
      return transfer(
        all,
        all.map(({ bytes }) => bytes.buffer),
      );
    }),
  pack: (files) => {
    const bytes = zipSync(files, { level: 6, mtime: ZIP_TIME });
    return Promise.resolve(transfer(bytes, [bytes.buffer]));
  },
};

carrySettingErrors();
expose(api);
