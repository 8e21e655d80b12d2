/** The form in which the page exports: its formats, and the settings that each of them supports. */

import type { Settings } from '../../engine/settings/options';

export interface ExportFormat {
  /** the setting `format` */
  value: Settings['format'];
  /** after the name of the file, with the dot */
  ending: string;
  /** MIME type */
  type: string;
  text: string;
  /** whether it stores compressed vertices and several levels */
  isGltf: boolean;
  /** whether it names textures */
  hasTextures: boolean;
}

const GLB: ExportFormat = {
  value: 'auto',
  ending: '.glb',
  type: 'model/gltf-binary',
  text: 'GLB',
  isGltf: true,
  hasTextures: true,
};

/** Formats of several files are packed, because a page saves one file at a time. */
export const EXPORT_FORMATS: readonly ExportFormat[] = [
  GLB,
  {
    value: 'gltf.zip',
    ending: '.gltf.zip',
    type: 'application/zip',
    text: 'glTF and its files, zipped',
    isGltf: true,
    hasTextures: true,
  },
  {
    value: 'obj.zip',
    ending: '.obj.zip',
    type: 'application/zip',
    text: 'OBJ and materials, zipped',
    isGltf: false,
    hasTextures: true,
  },
  {
    value: 'ply',
    ending: '.ply',
    type: 'application/octet-stream',
    text: 'PLY',
    isGltf: false,
    hasTextures: false,
  },
];

/** The format that the page writes for these settings, which a link may have from the command line. */
export const exportFormatOf = ({ format }: Pick<Settings, 'format'>): ExportFormat =>
  EXPORT_FORMATS.find(({ value }) => value === format || value === `${format}.zip`) ?? GLB;

/** The settings with which the file is written, without those that its format does not support. */
export function exportSettings(settings: Settings): Settings {
  const { value: format, isGltf } = exportFormatOf(settings);
  if (isGltf) return { ...settings, format };
  return { ...settings, format, compress: 'like-input', lodStyle: 'files' };
}

/** The settings of files that the page draws itself: plain GLB whatever is exported, and without tuning, so that no picture waits for it. */
export const drawnSettings = (settings: Settings): Settings => ({
  ...settings,
  ...(settings.maxFrequencyError > 0 ? {} : UNTUNED),
  format: 'auto',
  compress: 'none',
  lodStyle: 'files',
});

/** The look of a mesh only depends on its solver if frequencies in it limit the faces. */
const UNTUNED = { solver: 'none', tune: 'global', engine: '', massRule: 'auto' } as const;
