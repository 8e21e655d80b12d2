/** Checks what has been written by the Khronos glTF validator. */

import { sum } from '../engine/core/mesh';
import type { SourceFile } from '../engine/document/open';
import { addedErrors, validateFiles } from '../engine/document/validate';
import type { Session } from './session';
import { shownOutput } from './standard';
import { count } from './words';

/** Larger results are not checked: the validator takes some 20 ms for a megabyte, and several times the file in memory. */
const MOST_BYTES = 64 * 2 ** 20;
/** At most so many errors are told. */
const ERRORS_SHOWN = 3;

/** Warns of errors of the result that the input has not; of formats other than glTF there is nothing to check. */
export async function warnOfErrors(session: Session, files: SourceFile[]): Promise<void> {
  const [input, output] = session.args.operands;
  if (sizeOf(files) > MOST_BYTES) return;
  const result = await validateFiles(files);
  if (!result || result.errors === 0) return;
  const source = session.checked.files.get(input)!;
  const before = sizeOf(source) > MOST_BYTES ? null : await validateFiles(source);
  const added = addedErrors(result, before);
  if (added.length === 0) return;
  const shown = added.slice(0, ERRORS_SHOWN).map((message) => message.replace(/\.$/, ''));
  const more = added.length > ERRORS_SHOWN ? `; and ${count(added.length - ERRORS_SHOWN)} more` : '';
  session.warnings.push(
    `the glTF validator finds in ${shownOutput(output)} what ${input} has not: ${shown.join('; ')}${more}`,
  );
}

const sizeOf = (files: SourceFile[]): number => sum(files.map(({ bytes }) => bytes.length));
