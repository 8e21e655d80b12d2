/** Optimizes several models, one after the other with the same settings, in a worker of their own: the page stays responsive for the shown model. */

import { signal } from '@preact/signals';
import { fileDefaults } from '../../../engine/settings/options';
import type { Settings } from '../../../engine/settings/options';
import type { SourceFile } from '../../../engine/document/open';
import { freeName } from './model_groups';
import type { ModelGroup } from './model_groups';
import { Client } from '../client';
import { exportFormatOf, exportSettings } from '../../worker/export_form';
import { slider, wants } from '../store';
import { CANCELLED } from '../../worker/protocol';
import type { ExportResult, ExportRequest, KeptFaces } from '../../worker/protocol';
import type { Finished } from './summary';

export interface QueueItem extends ModelGroup {
  state: 'waiting' | 'running' | 'done' | 'failed';
  /** why it has failed, in one sentence */
  sentence: string | null;
  finished: Finished | null;
}

export interface Queue {
  items: readonly QueueItem[];
  isRunning: boolean;
  /** seconds that the run has taken so far */
  seconds: number;
}

/** null unless several models were opened. */
export const queue = signal<Queue | null>(null);

/** ms between two checks of the clock. */
const TICK_MILLISECONDS = 500;

/** The request for every model. */
interface Asked {
  settings: Settings;
  kept: KeptFaces;
  extras: Pick<ExportRequest, 'fields' | 'binding'>;
}

let client: Client | null = null;

/** Queues models; ends an earlier queue. */
export function fillQueue(groups: readonly ModelGroup[]): void {
  cancelQueue();
  const items = groups.map((group): QueueItem => ({
    ...group,
    state: 'waiting',
    sentence: null,
    finished: null,
  }));
  queue.value = { items, isRunning: false, seconds: 0 };
}

/** Whether these files belong to a model of the queue. */
export const isLinedUp = (files: SourceFile[]): boolean =>
  queue.value?.items.some((item) => item.files === files) ?? false;

/** Marks the model of these files as one that cannot be used, and why. */
export function failInQueue(files: SourceFile[], sentence: string): void {
  const i = queue.value?.items.findIndex((item) => item.files === files) ?? -1;
  if (i >= 0) updateItem(i, { state: 'failed', sentence });
}

export function closeQueue(): void {
  cancelQueue();
  queue.value = null;
}

/** Finished results are kept. */
export function cancelQueue(): void {
  const own = client;
  client = null;
  own?.end();
  if (!queue.value) return;
  const items = queue.value.items.map((item): QueueItem =>
    item.state === 'running' ? { ...item, state: 'waiting' } : item,
  );
  queue.value = { ...queue.value, items, isRunning: false };
}

/** The current settings, without those that refer to parts of one file. */
function askedNow(): Asked {
  const { wanted, faces } = slider.value;
  const ratio = faces > 0 ? Math.min(1, wanted / faces) : undefined;
  return {
    settings: exportSettings({ ...wants.settings.value, ...fileDefaults() }),
    kept: { faces: null, ratio, own: [] },
    extras: { fields: wants.exportFields.value, binding: wants.exportBinding.value },
  };
}

/** Processes every model again. A model that cannot be used does not affect the others. */
export async function runQueue(): Promise<void> {
  if (!queue.value || queue.value.isRunning) return;
  const asked = askedNow();
  const items = queue.value.items.map((item): QueueItem => ({
    ...item,
    state: 'waiting',
    sentence: null,
    finished: null,
  }));
  queue.value = { items, isRunning: true, seconds: 0 };
  const own = (client = new Client(new URL('.', document.baseURI).href, () => {}));
  const begin = performance.now();
  const tick = () => own === client && update({ seconds: (performance.now() - begin) / 1000 });
  const timer = setInterval(tick, TICK_MILLISECONDS);
  const taken = new Set<string>();
  for (let i = 0; i < items.length && own === client; ++i) await runItem(own, i, asked, taken);
  clearInterval(timer);
  if (own !== client) return;
  tick();
  update({ isRunning: false });
  client = null;
  own.end();
}

const update = (change: Partial<Queue>): void => {
  if (queue.value) queue.value = { ...queue.value, ...change };
};

function updateItem(i: number, change: Partial<QueueItem>): void {
  update({ items: queue.value!.items.map((item, n) => (n === i ? { ...item, ...change } : item)) });
}

async function runItem(own: Client, i: number, asked: Asked, taken: Set<string>): Promise<void> {
  const { name, files } = queue.value!.items[i];
  updateItem(i, { state: 'running' });
  try {
    const output = freeName(name, exportFormatOf(asked.settings).ending, taken);
    await own.open(files);
    const exported = await exportNow(own, asked, { ...asked.extras, output: output.split('/').pop()! });
    if (own === client) updateItem(i, { state: 'done', finished: finishedOf(output, exported) });
  } catch (error) {
    const text = error instanceof Error ? error.message : String(error);
    if (own !== client || text === CANCELLED) return;
    updateItem(i, { state: 'failed', sentence: text });
  }
}

const exportNow = (own: Client, { settings, kept }: Asked, request: ExportRequest): Promise<ExportResult> =>
  own.call<ExportResult>((worker) => worker.export(settings, kept, request));

/** `output`: with its folders, which its companion files share. */
function finishedOf(output: string, exported: ExportResult): Finished {
  const { files, levels, binding, settings, report, faces } = exported;
  const folder = output.slice(0, output.lastIndexOf('/') + 1);
  const stem = output.replace(/(\.(glb|gltf|obj|ply))?(\.zip)?$/, '');
  const text = (name: string, content: string | null): SourceFile[] =>
    content === null ? [] : [{ name, bytes: new TextEncoder().encode(content) }];
  const models = [...files, ...levels.flatMap((level) => level.files)];
  return {
    output,
    faces: { before: report.input!.faces, after: faces },
    deviation: report.surface?.hausdorff ?? 0,
    stop: !report.stop || report.stop.reason === 'target' ? null : report.stop.reason,
    bytes: exported.bytes.length,
    files: [
      ...models.map(({ name, bytes }) => ({ name: folder + name, bytes })),
      ...text(`${stem}.bind.json`, binding),
      ...text(`${stem}.settings.json`, settings),
    ],
  };
}
