/** Decides how files that are opened together are used: as a model, as several models for the queue, or as a settings file for the open model. */

import { describeConversion } from '../../engine/document/checks/other_formats';
import { isModelName } from '../../engine/document/format_names';
import type { SourceFile } from '../../engine/document/open';
import { closeQueue, failInQueue, fillQueue } from '../state/queue/queue';
import { openFiles } from '../state/runner';
import { client } from '../state/running';
import { results, status } from '../state/store';
import { modelGroups } from '../state/queue/model_groups';
import type { ModelGroup } from '../state/queue/model_groups';
import { applySettings, isSettingsName } from './settings_file';
import { say, sayCounted, sentence } from '../language/say';

const ARCHIVE = /\.zip$/i;

/** Never throws: a notice names files that cannot be used. */
export async function openAll(files: SourceFile[]): Promise<void> {
  if (files.length > 0 && files.every(isSettingsName)) return applySettings(files[0]);
  const all = await unpackedOf(files);
  const groups = modelGroups(all);
  // An archive inside another is no file that was meant to be opened.
  const leftOut = describeLeftOut(all === files ? all : all.filter(({ name }) => !ARCHIVE.test(name)));
  if (groups.length < 2) return openFiles(files, { leftOut });
  fillQueue(groups);
  await openFirst(groups, leftOut);
}

/** Which files beside models are meant to be opened and cannot be, and the cure; undefined where there are none. */
function describeLeftOut(files: readonly SourceFile[]): string | undefined {
  if (!files.some(({ name }) => isModelName(name))) return undefined;
  const [first, ...others] = files.flatMap(
    ({ name }) => describeConversion(name) ?? describeSettings(name) ?? [],
  );
  if (others.length === 0) return first;
  return sayCounted(
    others.length,
    '{first} {count} other was left out, too.',
    '{first} {count} others were left out, too.',
    { first: sentence(first) },
  );
}

const describeSettings = (name: string): string | null =>
  /\.settings\.json$/i.test(name)
    ? say('{name} was left out: drop it alone once the model that it was made for is open.', { name })
    : null;

/** Files as they are where no archive is among them, or where one cannot be unpacked: opening it says why. */
async function unpackedOf(files: SourceFile[]): Promise<SourceFile[]> {
  if (!files.some(({ name }) => ARCHIVE.test(name))) return files;
  try {
    return await client.aside<SourceFile[]>((worker) => worker.unpack(files));
  } catch {
    return files;
  }
}

/** Opens the first model that can be used; the queue says why those before it cannot, and a notice repeats the first reason. */
async function openFirst(groups: readonly ModelGroup[], leftOut: string | undefined): Promise<void> {
  const before = results.opened.value;
  let problem: string | undefined;
  for (const { files } of groups) {
    await openFiles(files, { leftOut: leftOut ?? problem });
    if (results.opened.value !== before) return;
    const { value: notice } = status.notice;
    if (notice?.kind !== 'error') continue;
    failInQueue(files, notice.text);
    problem ??= notice.text;
  }
  if (!results.file.value) closeQueue();
}
