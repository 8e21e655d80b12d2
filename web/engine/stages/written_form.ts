/** Checks, before any work, whether a file can be written as requested. */

import { refusedExtensions } from '../document/extensions/refused';
import type { RefusedExtension } from '../document/extensions/refused';
import type { OpenModel } from '../document/open';
import { lostIn } from '../document/write/lost';
import { checkForm, outputForm } from '../document/write/output_form';
import type { OutputForm } from '../document/write/output_form';
import { matchesPattern } from '../settings/name_pattern';
import { SettingError } from '../settings/options';
import type { Settings } from '../settings/options';

type FormSettings = Pick<Settings, 'format' | 'compress' | 'lodStyle' | 'lods' | 'dropExtensions'>;

/**
 * The form of a file with this name, and what it leaves out, in words for the user. `chosen`: indices of the bodies that change. Throws
 * SettingError, or an Error with one sentence, where the format cannot have what is asked for, or where an extension of the file would
 * be lost that is not named to be left out.
 */
export function checkWritten(
  model: OpenModel,
  chosen: readonly number[],
  { name, settings }: { name: string; settings: FormSettings },
): { form: OutputForm; lost: string[] } {
  const form = outputForm(name, settings.format, model.format);
  checkForm(form, { compression: settings.compress, style: settings.lodStyle, levels: settings.lods.length });
  if (form.format !== 'glb' && form.format !== 'gltf')
    return { form, lost: [...lostIn(form.format, model), ...model.unread] };
  if (settings.lodStyle !== 'files' && settings.lods.length > 0 && model.hasLevels)
    throw new SettingError('lodStyle', [
      `would put levels into ${model.name}, which already has levels of detail: give files, or leave out `,
      { setting: 'lods' },
      '.',
    ]);
  const { dropExtensions } = settings;
  const refused = refusedExtensions(model, chosen);
  const isDropped = (extension: RefusedExtension) =>
    dropExtensions !== '' && matchesPattern(dropExtensions, extension.name);
  const first = refused.find((extension) => !isDropped(extension));
  if (first) throw refusalOf(model, first);
  const dropped = [...new Set(refused.map((extension) => `extension ${extension.name}`))];
  return { form, lost: [...dropped, ...model.unread] };
}

function refusalOf(
  { name }: OpenModel,
  { name: extension, where, why, body }: RefusedExtension,
): SettingError {
  const other =
    body === null
      ? ['.']
      : [`, or keep the body unchanged with `, { setting: 'exclude' as const }, ` "${body}".`];
  return new SettingError('dropExtensions', [
    `does not list ${extension}, which ${name} has on ${where}, ${why}: add it to leave it out`,
    ...other,
  ]);
}
