/** The summary of a batch: the outcome of every asset, as JSON, CSV and HTML. */

import { VERSION } from '../../engine/core/version';
import { counted, grouped } from '../../engine/core/words';
import { isModelName } from '../../engine/document/format_names';
import { facesChange } from '../words';
import type { AssetRecord, AssetState } from './record';

export const SUMMARY_SCHEMA = 'limber-summary/1';

/** An asset, and whether this run has worked on it. */
export interface SummaryRow extends AssetRecord {
  isUnchanged: boolean;
}

export interface Summary {
  schema: string;
  version: string;
  totals: SummaryTotals;
  assets: SummaryRow[];
}

export interface SummaryTotals {
  assets: number;
  done: number;
  missed: number;
  failed: number;
  /** of those that are done or missed, the ones that this run has left as they were */
  unchanged: number;
  facesBefore: number;
  facesAfter: number;
  bytesBefore: number;
  bytesAfter: number;
  /** of this run, from its start to its end */
  seconds: number;
}

/** The model among what was written, below OUT, before which its companions stand and after which its levels; null: there is none. */
export const resultOf = ({ written }: Pick<AssetRecord, 'written'>): string | null =>
  written.find(({ name }) => isModelName(name) || /\.zip$/i.test(name))?.name ?? null;

/** Rows in the order of their names. */
export function summaryOf(rows: SummaryRow[], seconds: number): Summary {
  const number = (state: AssetState) => rows.filter((row) => row.state === state).length;
  const total = (key: 'facesBefore' | 'facesAfter' | 'bytesBefore' | 'bytesAfter') =>
    rows.reduce((sum, row) => sum + (row.state === 'failed' ? 0 : (row[key] ?? 0)), 0);
  const totals = {
    assets: rows.length,
    done: number('done'),
    missed: number('missed'),
    failed: number('failed'),
    unchanged: rows.filter(({ isUnchanged }) => isUnchanged).length,
    facesBefore: total('facesBefore'),
    facesAfter: total('facesAfter'),
    bytesBefore: total('bytesBefore'),
    bytesAfter: total('bytesAfter'),
    seconds,
  };
  const assets = [...rows].sort((a, b) => (a.asset < b.asset ? -1 : Number(a.asset > b.asset)));
  return { schema: SUMMARY_SCHEMA, version: VERSION, totals, assets };
}

/** One line on the whole. */
export function describeTotals(totals: SummaryTotals): string {
  const { assets, done, missed, failed, unchanged, facesBefore, facesAfter, seconds } = totals;
  const parts = [
    `${grouped(done + missed - unchanged)} optimized`,
    `${grouped(unchanged)} up to date`,
    ...(missed > 0 ? [`${grouped(missed)} missed a target`] : []),
    ...(failed > 0 ? [`${grouped(failed)} failed`] : []),
  ];
  const faces = facesBefore > 0 ? `; ${facesChange(facesBefore, facesAfter)}` : '';
  return `${counted(assets, 'asset')}: ${parts.join(', ')}${faces}; ${seconds.toFixed(1)} s`;
}
