/** `-` as an operand: stdin where a model is read, stdout where one is written. */

import { basename } from 'node:path';
import { UsageError } from './failure';

export const STANDARD = '-';

/** A file of the command line as it is called in messages. */
export const shownName = (path: string): string => (path === STANDARD ? 'stdin' : basename(path));

/** The models of a command as they are called in messages: by their paths where their file names are equal. */
export function shownNames(paths: string[]): string[] {
  const names = paths.map(shownName);
  return new Set(names).size < names.length ? paths : names;
}

export const shownOutput = (path: string): string => (path === STANDARD ? 'stdout' : path);

/** All that is piped in. Throws UsageError where that is nothing. */
export async function readStandard(
  stream: AsyncIterable<Uint8Array> & { isTTY?: boolean },
): Promise<Uint8Array> {
  if (stream.isTTY) throw new UsageError('stdin is a terminal: pipe a model into it, or name a file.');
  const chunks: Uint8Array[] = [];
  for await (const chunk of stream) chunks.push(chunk);
  const bytes = new Uint8Array(Buffer.concat(chunks));
  if (bytes.length === 0) throw new UsageError('stdin is empty: pipe a model into it, or name a file.');
  return bytes;
}

/** Refuses uses of stdin and stdout that exclude each other. */
export function checkStandard(
  {
    inputs,
    models,
    reports,
    others,
    levels,
  }: { inputs: string[]; models: string[]; reports: string[]; others: string[]; levels: number },
  isTerminal = Boolean(process.stdout.isTTY),
): void {
  if (inputs.filter((path) => path === STANDARD).length > 1)
    throw new UsageError('stdin can be read only once: name a file for one of the models.');
  if (others.includes(STANDARD))
    throw new UsageError('stdout takes only models and reports: name a file for --bind and --settings.');
  if (!models.includes(STANDARD)) return;
  if (levels > 0)
    throw new UsageError('--lods names the levels after OUT, which is stdout: give OUT a file name.');
  if (reports.includes(STANDARD))
    throw new UsageError('stdout takes the model or the report, not both: name a file for one of them.');
  if (isTerminal) throw new UsageError('stdout is a terminal: pipe the model into a file, or name one.');
}
