/** A written model with the files beside it: what they may be written over, and their writing. */

import { existsSync, mkdirSync, readFileSync, statSync } from 'node:fs';
import { basename, dirname, join } from 'node:path';
import { describeEmpty } from '../../engine/document/open';
import type { OpenModel, SourceFile } from '../../engine/document/open';
import { companionsOf } from '../../engine/document/write/export_files';
import type { Companion } from '../../engine/document/write/shared_images';
import { checkWritten } from '../../engine/stages/written_form';
import { counted } from '../../engine/core/words';
import type { Arguments } from '../arguments';
import { UsageError } from '../failure';
import { identityOf } from './identity';
import type { CheckedFiles } from '../inputs';
import { levelFiles } from '../levels';
import { isOwnCompanion } from './own_companions';
import { save } from '../session';
import type { Session } from '../session';
import { STANDARD } from '../standard';

/** The name by which the engine knows an output. */
export const fileName = (path: string): string => (path === STANDARD ? 'model' : basename(path));

/** What is known of a command before its work. */
type Asked = Pick<Session, 'args' | 'checked' | 'isHosted'>;

/** `companions`: paths of the files beside OUT and its levels. */
type ModelOutputs = ReturnType<typeof checkWritten> & { companions: string[] };

/**
 * The form of OUT, and what it leaves out; all before the work. `chosen`: numbers of the bodies that change. Throws UsageError or
 * another Error with one sentence where OUT, a level or a file beside one of them is not to be written.
 */
export function checkModelOutputs(asked: Asked, model: OpenModel, chosen: number[]): ModelOutputs {
  const { args, checked } = asked;
  const path = args.operands[1];
  const written = checkWritten(model, chosen, { name: fileName(path), settings: args.settings });
  const companions = (file: string) => companionsOf(model, fileName(file), written.form);
  if (path === STANDARD) return ofStandard(written, companions(path));
  const taken = new Set(
    checked.outputs.filter((one) => one.path !== STANDARD).map((one) => identityOf(one.path)),
  );
  const beside = [path, ...levelFiles(args)].flatMap((file) =>
    companions(file).map((companion) => checkCompanion(asked, file, companion, taken)),
  );
  return { ...written, companions: [...new Set(beside)].filter((file) => !isFileOf(checked, file)) };
}

/** Throws UsageError where files are made that stdout has no place for; those of the input are left out. */
function ofStandard({ form, lost }: Omit<ModelOutputs, 'companions'>, companions: Companion[]): ModelOutputs {
  const [first] = companions;
  if (companions.some(({ bytes }) => bytes === null))
    throw new UsageError(
      `stdout takes one file, but a .${form.format} comes with others: name a file, or give --format ${form.format}.zip.`,
    );
  const others = companions.length > 1 ? ` and ${counted(companions.length - 1, 'file')} more,` : '';
  const left = first ? [`${first.name}${others || ','} which it names`] : [];
  return { form, lost: [...lost, ...left], companions: [] };
}

/** Throws UsageError where a model without triangles, which is passed on, is to have more than OUT. */
export function checkPassedOn({ reports, settings, bind, settingsFile }: Arguments, model: OpenModel): void {
  if (reports.length + settings.lods.length > 0 || bind !== null || settingsFile !== null)
    throw new UsageError(
      `${model.name} ${describeEmpty(model)}, so there is nothing to report on: leave out --report, --lods, --bind and --settings.`,
    );
}

/** Its path. Throws UsageError where it is not to be written. */
function checkCompanion(
  { args, checked, isHosted }: Asked,
  model: string,
  companion: Companion,
  taken: Set<string>,
): string {
  const path = join(dirname(model), companion.name);
  if (!existsSync(dirname(path))) return path;
  if (statSync(path, { throwIfNoEntry: false })?.isDirectory())
    throw new UsageError(`${path}, which belongs to ${model}, is a folder: choose another name for OUT.`);
  const identity = identityOf(path);
  if (taken.has(identity))
    throw new UsageError(
      `${path}, which belongs to ${model}, is another output: choose another name for one of them.`,
    );
  // What does not change and is there already need not be written.
  if (companion.bytes && hasBytes(path, companion.bytes)) return path;
  const belongsToInput = isInput(checked, path);
  // Which other files may be replaced, a batch finds out when it takes its results.
  if (isHosted && !belongsToInput) return path;
  if (belongsToInput)
    throw new UsageError(
      `${path}, which belongs to ${model}, belongs to the input: choose another ${companion.bytes ? 'folder' : 'name'} for OUT.`,
    );
  if (existsSync(path) && !args.force && !isOwnCompanion(path, model))
    throw new UsageError(
      `${path}, which belongs to ${model}, exists: choose another ${companion.bytes ? 'folder' : 'name'} for OUT, or replace it with --force.`,
    );
  return path;
}

/** Whether the file is there, and is an input. */
const isFileOf = (checked: CheckedFiles, path: string): boolean => existsSync(path) && isInput(checked, path);

function isInput({ inputs }: CheckedFiles, path: string): boolean {
  const identity = identityOf(path);
  return inputs.some((input) => identityOf(input) === identity);
}

function hasBytes(path: string, bytes: Uint8Array): boolean {
  if (statSync(path, { throwIfNoEntry: false })?.size !== bytes.length) return false;
  return readFileSync(path).equals(bytes);
}

/**
 * Writes what belongs to the model first, so that the model that names it is whole as soon as it is there. A batch remembers all that
 * belongs to a result, so that what is there already is written as well, but for an input.
 */
export function saveFiles(session: Session, path: string, files: SourceFile[], write = save): void {
  const [main, ...others] = files;
  if (path === STANDARD) return write(session, path, main.bytes);
  for (const { name, bytes } of others) {
    const own = join(dirname(path), name);
    if (hasBytes(own, bytes) && (!session.isHosted || isInput(session.checked, own))) continue;
    mkdirSync(dirname(own), { recursive: true });
    write(session, own, bytes);
  }
  write(session, path, main.bytes);
}
