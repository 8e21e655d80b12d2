/** What becomes of files that are opened together: a model, several models for the queue, or a settings file for the open model. */

import type { SourceFile } from '../../engine/document/open';
import { closeQueue, fillQueue } from '../state/queue/queue';
import { openFiles } from '../state/runner';
import { client } from '../state/running';
import { results } from '../state/store';
import { modelGroups } from '../state/queue/model_groups';
import type { ModelGroup } from '../state/queue/model_groups';
import { applySettings, isSettingsName } from './settings_file';

const ARCHIVE = /\.zip$/i;

/** Never throws: what cannot be used is told in a notice. */
export async function openAll(files: SourceFile[]): Promise<void> {
  if (files.length > 0 && files.every(isSettingsName)) return applySettings(files[0]);
  const groups = modelGroups(await unpackedOf(files));
  if (groups.length < 2) return openFiles(files);
  fillQueue(groups);
  await openFirst(groups);
}

/** Files as they are where no archive is among them, or where one cannot be unpacked: opening it says why. */
async function unpackedOf(files: SourceFile[]): Promise<SourceFile[]> {
  if (!files.some(({ name }) => ARCHIVE.test(name))) return files;
  try {
    return await client.aside<SourceFile[]>((worker) => worker.unpack(files));
  } catch {
    return files;
  }
}

/** Opens the first model that can be used. */
async function openFirst(groups: readonly ModelGroup[]): Promise<void> {
  const before = results.opened.value;
  for (const { files } of groups) {
    await openFiles(files);
    if (results.opened.value !== before) return;
  }
  if (!results.file.value) closeQueue();
}
