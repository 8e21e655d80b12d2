/** Writes the summary of a batch into OUT, and where --report says. */

import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import type { Arguments } from '../arguments';
import { writeWhole } from '../files';
import { STANDARD } from '../standard';
import { picturePath } from './results';
import type { Summary } from './summary';
import { summaryCsv } from './summary_csv';
import { summaryHtml } from './summary_html';

/** The first is written first and carries the mark of a summary, which a CSV has no room for. */
export const SUMMARY_FILES = ['summary.json', 'summary.csv', 'summary.html'];

/** Whether a batch has written the summary in `out`: its JSON says so for the files beside it. */
export function hasSummary(out: string): boolean {
  const path = join(out, SUMMARY_FILES[0]);
  return existsSync(path) && MARK.test(readFileSync(path, 'utf8'));
}

const MARK = /^\{\s*"schema": "limber-summary\/\d/;

export function writeSummary({ reports }: Arguments, out: string, summary: Summary): void {
  const json = `${JSON.stringify(summary, null, 2)}\n`;
  const pictureOf = (asset: string): Uint8Array | null => {
    const path = picturePath(out, asset);
    return existsSync(path) ? readFileSync(path) : null;
  };
  const contents = [json, summaryCsv(summary), summaryHtml(summary, pictureOf)];
  SUMMARY_FILES.forEach((name, i) => writeWhole(join(out, name), contents[i]));
  for (const path of reports)
    if (path === STANDARD) process.stdout.write(json);
    else writeWhole(path, json);
}
