/** Drops the compression of --preset if the format of the result has none. */

import type { OpenModel } from '../../engine/document/model';
import { isCompressed, outputForm } from '../../engine/document/write/output_form';
import type { WrittenFormat } from '../../engine/core/output_choices';
import type { Settings } from '../../engine/settings/options';
import type { PresetName } from '../../engine/settings/presets';
import type { Arguments } from '../arguments';
import { fileName } from './model_outputs';

/** What gives way, as a clause; null where the format has the compression, or there is none. */
export const describeYielded = (
  format: WrittenFormat,
  { compress }: Pick<Settings, 'compress'>,
  preset: PresetName | null,
): string | null =>
  preset === null || !isCompressed(compress) || format === 'glb' || format === 'gltf'
    ? null
    : `${format.toUpperCase()} cannot be compressed: ${compress} of --preset ${preset} is left out`;

/** The arguments of limber optimize without a compression that gives way, and what is said of that. Throws where OUT has no format. */
export function withoutYielded(
  args: Arguments,
  model: Pick<OpenModel, 'format'>,
): { args: Arguments; notes: string[] } {
  const { asked, operands, preset, settings } = args;
  if (asked.has('compress')) return { args, notes: [] };
  const { format } = outputForm(fileName(operands[1]), settings.format, model.format);
  const note = describeYielded(format, settings, preset);
  if (note === null) return { args, notes: [] };
  return { args: { ...args, settings: { ...settings, compress: 'like-input' } }, notes: [note] };
}
