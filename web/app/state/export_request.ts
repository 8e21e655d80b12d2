/** What is asked of the export, and keys for what comes of it. */

import { drawnLevelsKey, exportKey } from '../worker/protocol';
import type { ExportRequest } from '../worker/protocol';
import { exportFormatOf, exportSettings } from '../worker/export_form';
import { keptFaces, results, wants } from './store';

/** The name of a file without its folders and its ending. */
export const baseName = (name: string): string =>
  name
    .split('/')
    .pop()!
    .replace(/\.[^.]+$/, '');

export const exportRequest = (): ExportRequest => ({
  fields: wants.exportFields.value,
  binding: wants.exportBinding.value,
  output: `${baseName(results.file.value?.name ?? '')}-limber${exportFormatOf(wants.settings.value).ending}`,
});

export const exportedKey = (): string =>
  exportKey(exportSettings(wants.settings.value), keptFaces.value, exportRequest());

export const levelsKey = (): string => drawnLevelsKey(wants.settings.value, keptFaces.value);
