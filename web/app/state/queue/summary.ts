/** The results of the models of a queue: in words, and as a table for the archive. */

import { cell } from '../../../engine/report/tables/csv_cell';
import type { SourceFile } from '../../../engine/document/open';
import { listed, say } from '../../language/say';
import { describeLeft } from '../remaining';

/** A finished model. */
export interface Finished {
  /** name of its file in the archive */
  output: string;
  faces: { before: number; after: number };
  /** largest distance from the original, % of the diagonal */
  deviation: number;
  /** why it does not have fewer faces: a value of the report's `stop`; null if it has as few as requested */
  stop: string | null;
  /** of its file */
  bytes: number;
  /** all of its files that are saved */
  files: SourceFile[];
}

interface Counted {
  state: 'waiting' | 'running' | 'done' | 'failed';
  files: readonly SourceFile[];
}

const bytesOf = ({ files }: Counted): number => files.reduce((sum, { bytes }) => sum + bytes.length, 0);

/** "3 of 12, 40 s left": the time is estimated from the processed bytes. */
export function describeProgress(items: readonly Counted[], seconds: number): string {
  const finished = items.filter(({ state }) => state === 'done' || state === 'failed');
  const number = Math.min(items.length, finished.length + 1);
  const done = finished.reduce((sum, item) => sum + bytesOf(item), 0);
  const all = items.reduce((sum, item) => sum + bytesOf(item), 0);
  const left = done > 0 ? (seconds * (all - done)) / done : 0;
  return `${say('{number} of {all}', { number, all: items.length })}${describeLeft(left)}`;
}

/** "11 done and 1 failed" */
export function describeOutcome(items: readonly Counted[]): string {
  const count = (wanted: Counted['state']) => items.filter(({ state }) => state === wanted).length;
  const [done, failed, waiting] = [count('done'), count('failed'), count('waiting')];
  const parts = [
    done > 0 ? say('{number} done', { number: done }) : '',
    failed > 0 ? say('{number} failed', { number: failed }) : '',
    waiting > 0 ? say('{number} not started', { number: waiting }) : '',
  ];
  return listed(parts.filter((part) => part !== ''));
}

interface Row extends Counted {
  name: string;
  sentence: string | null;
  finished: Finished | null;
}

/** A line for each model, as CSV (RFC 4180). */
export function summaryCsv(items: readonly Row[]): string {
  const lines = items.map(({ name, state, sentence, finished }) => [
    name,
    state,
    finished?.output ?? '',
    finished?.faces.before ?? '',
    finished?.faces.after ?? '',
    finished ? Number(finished.deviation.toPrecision(4)) : '',
    finished?.bytes ?? '',
    finished?.stop ?? '',
    sentence ?? '',
  ]);
  const head = [
    'model',
    'state',
    'output',
    'faces',
    'faces of the result',
    'deviation %',
    'bytes',
    'stopped by',
    'problem',
  ];
  return `${[head, ...lines].map((line) => line.map(cell).join(',')).join('\r\n')}\r\n`;
}
