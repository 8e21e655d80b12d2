/** What is asked of the export, and keys for what comes of it. */

import { drawnLevelsKey, exportedFilesKey, exportKey } from '../worker/protocol';
import type { ExportRequest } from '../worker/protocol';
import { exportFormatOf, exportSettings } from '../worker/export_form';
import { keptFaces, results, wants } from './store';

/** The name of a file without its folders and its ending. */
export const baseName = (name: string): string =>
  name
    .split('/')
    .pop()!
    .replace(/\.[^.]+$/, '');

/** "bar-figure.png" for bar.glb: as the export names its files. */
export const pictureName = (ending: string): string => `${openName()}-${ending}`;

const openName = (): string => baseName(results.file.value?.name ?? '');

export const exportRequest = (): ExportRequest => ({
  fields: wants.exportFields.value,
  binding: wants.exportBinding.value,
  output: `${openName()}-limber${exportFormatOf(wants.settings.value).ending}`,
});

export const exportedKey = (): string =>
  exportKey(exportSettings(wants.settings.value), keptFaces.value, exportRequest());

export const genericKey = (): string =>
  exportedFilesKey(exportSettings(wants.settings.value), keptFaces.value, exportRequest());

export const levelsKey = (): string => drawnLevelsKey(wants.settings.value, keptFaces.value);
