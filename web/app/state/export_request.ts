/** The request for an export, and keys for its results. */

import { computed } from '@preact/signals';
import { drawnLevelsKey, exportedFilesKey, exportKey } from '../worker/protocol';
import type { ExportRequest } from '../worker/protocol';
import { exportFormatOf, exportSettings } from '../worker/export_form';
import { shownResultFile } from './drawn_file';
import { suffixedName } from './queue/model_groups';
import { keptFaces, results, wants } from './store';

/** The name of a file without its folders and its ending. */
export const baseName = (name: string): string =>
  name
    .split('/')
    .pop()!
    .replace(/\.[^.]+$/, '');

/** "bar-figure.png" for bar.glb: follows the file names of the export. */
export const pictureName = (ending: string): string => `${openName()}-${ending}`;

const openName = (): string => baseName(results.file.value?.name ?? '');

export const exportRequest = (): ExportRequest => ({
  fields: wants.exportFields.value,
  binding: wants.exportBinding.value,
  output: `${suffixedName(openName())}${exportFormatOf(wants.settings.value).ending}`,
});

export const exportedKey = (): string =>
  exportKey(exportSettings(wants.settings.value), keptFaces.value, exportRequest());

export const genericKey = (): string =>
  exportedFilesKey(exportSettings(wants.settings.value), keptFaces.value, exportRequest());

export const levelsKey = (): string => drawnLevelsKey(wants.settings.value, keptFaces.value);

/** Bytes of the file that the export saves; null while unknown. */
export const sizeAfter = computed((): number | null => {
  const { value: exported } = results.exported;
  if (exported?.key === exportedKey()) return exported.bytes.length;
  return isWrittenAsDrawn() ? (shownResultFile.value?.bytes.length ?? null) : null;
});

/** Whether the export is what the page draws: a plain GLB of only the result. */
function isWrittenAsDrawn(): boolean {
  const { value: settings } = wants.settings;
  const { compress, lods, lodStyle, solver } = settings;
  const stored = compress === 'like-input' ? results.file.value!.stored : compress;
  const isAlone = lods.length === 0 || lodStyle === 'files';
  const isGlb = exportFormatOf(settings).value === 'auto';
  return isGlb && stored === 'none' && isAlone && solver === 'none' && !wants.exportFields.value;
}
