/** The format in which a result is written, by the name of its file. */

import type { Format } from '../model';
import { WRITTEN_FORMATS } from '../../core/output_choices';
import type { Compression, FormatChoice, LevelStyle, WrittenFormat } from '../../core/output_choices';

export interface OutputForm {
  format: WrittenFormat;
  isZipped: boolean;
}

/** Options of the written files besides their format. */
export interface OutputManner {
  compression: Compression;
  style: LevelStyle;
  /** whether another file refers to vertices or triangles of the result by index */
  keepsOrder: boolean;
}

const ENDING = /(?:\.(glb|gltf|obj|ply))?(\.zip)?$/i;

const INSIDE = /\.(glb|gltf|obj|ply)\.zip$/i;

/** The form of a file with this name: null where its ending is none that can be written. `input`: what NAME.zip holds. */
export function formOfName(name: string, input: Format): OutputForm | null {
  const found = ENDING.exec(name)!;
  const isZipped = found[2] !== undefined;
  const inside = WRITTEN_FORMATS.find((format) => format === found[1]?.toLowerCase());
  if (inside) return { format: inside, isZipped };
  if (!isZipped) return null;
  return { format: WRITTEN_FORMATS.find((format) => format === input) ?? 'glb', isZipped };
}

/**
 * The form that is asked for: by `choice`, or where it is `auto` by the name; a name that says nothing is that of a GLB. Throws an
 * Error with one sentence where the two contradict each other.
 */
export function outputForm(name: string, choice: FormatChoice, input: Format): OutputForm {
  const named = formOfName(name, input);
  if (choice === 'auto') return named ?? { format: 'glb', isZipped: false };
  const chosen = formOfName(`.${choice}`, input)!;
  const isSame = !named || (named.format === chosen.format && named.isZipped === chosen.isZipped);
  // NAME.zip alone leaves open what it holds.
  const isFree = chosen.isZipped && /\.zip$/i.test(name) && !INSIDE.test(name);
  if (!isSame && !isFree)
    throw new Error(
      `${name} does not end in .${choice}, the format that is asked for: change the name or the format.`,
    );
  return chosen;
}

/** Whether an OBJ is written as one again, see `outputForm`. */
export const staysObj = (name: string, choice: FormatChoice): boolean =>
  formOfName(choice === 'auto' ? name : `.${choice}`, 'obj')?.format === 'obj';

/** The name of the model's file inside an archive, or of the file itself. */
export const mainName = (name: string, { format, isZipped }: OutputForm): string =>
  isZipped ? `${name.replace(/(\.(glb|gltf|obj|ply))?\.zip$/i, '')}.${format}` : name;

/** The name with `suffix` before its ending or endings. */
const withSuffix = (name: string, suffix: string): string =>
  name.replace(/(\.(glb|gltf|obj|ply))?(\.zip)?$/i, `${suffix}$&`);

/** What further levels of detail are called beside a file: by files of their own, NAME_lod1 and so on, or by that file. */
export const levelNames = (
  name: string,
  { lods, lodStyle }: { lods: readonly number[]; lodStyle: LevelStyle },
): string[] => lods.map((_, i) => (lodStyle === 'files' ? withSuffix(name, `_lod${i + 1}`) : name));

/** What sentences call further levels: by their files, or by their places in the one file. */
export const levelLabels = (
  name: string,
  settings: { lods: readonly number[]; lodStyle: LevelStyle },
): string[] =>
  levelNames(name, settings).map((file, i) =>
    settings.lodStyle === 'files' ? file : `${file}, level ${i + 1}`,
  );

/**
 * The name of the result of a model that came under the name `input`: the base name of that, `model` where it has none, with the
 * ending of the format. `auto` is a GLB.
 */
export function resultName(input: string, choice: FormatChoice): string {
  const file = input.split(/[\\/]/).pop()!;
  const stem = file.replace(/(\.(glb|gltf|obj|stl|ply|off))?(\.zip)?$/i, '') || 'model';
  return `${stem}.${choice === 'auto' ? 'glb' : choice}`;
}

/** Whether a compression is one that only GLB and glTF can have. */
export const isCompressed = (compression: Compression): boolean =>
  compression !== 'like-input' && compression !== 'none';

/** Throws an Error with one sentence where the format cannot have what is asked for. `levels`: further levels of detail. */
export function checkForm(
  { format }: OutputForm,
  { compression, style, levels }: Pick<OutputManner, 'compression' | 'style'> & { levels: number },
): void {
  if (format === 'glb' || format === 'gltf') return;
  const name = format.toUpperCase();
  if (isCompressed(compression))
    throw new Error(`${name} cannot be compressed by ${compression}: write .glb or .gltf, or leave it out.`);
  if (style !== 'files' && levels > 0)
    throw new Error(
      `${name} has no levels of detail inside: write .glb or .gltf, or one file for each level.`,
    );
}
