/** The choices of settings that say how files are written. */

/** How vertices are stored; `like-input`: as in the file that was opened. */
export const COMPRESSIONS = ['like-input', 'none', 'quantized', 'meshopt', 'draco'] as const;
export type Compression = (typeof COMPRESSIONS)[number];

/** Where further levels of detail go: into files of their own, or into the file of the first. */
export const LEVEL_STYLES = ['files', 'msft', 'nodes'] as const;
export type LevelStyle = (typeof LEVEL_STYLES)[number];

export const WRITTEN_FORMATS = ['glb', 'gltf', 'obj', 'ply'] as const;
export type WrittenFormat = (typeof WRITTEN_FORMATS)[number];

/** The format of a result; `auto`: by the name of its file. */
export const FORMAT_CHOICES = [
  'auto',
  ...WRITTEN_FORMATS,
  'glb.zip',
  'gltf.zip',
  'obj.zip',
  'ply.zip',
] as const;
export type FormatChoice = (typeof FORMAT_CHOICES)[number];
