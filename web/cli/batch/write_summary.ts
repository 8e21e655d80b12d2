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

export const SUMMARY_FILES = ['summary.json', 'summary.csv', 'summary.html'];

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
