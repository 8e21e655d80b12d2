/** Checks what has been written by the Khronos glTF validator. */

import type { SourceFile } from '../engine/document/open';
import { describeAddedErrors } from '../engine/document/validate';
import type { Session } from './session';
import { shownOutput } from './standard';

/** Warns of errors of the result that the input has not; of formats other than glTF there is nothing to check. */
export async function warnOfErrors(session: Session, files: SourceFile[]): Promise<void> {
  const [input, output] = session.args.operands;
  const errors = await describeAddedErrors(files, session.checked.files.get(input)!);
  if (errors === null) return;
  session.warnings.push(
    `the glTF validator finds in ${shownOutput(output)} what ${input} has not: ${errors}`,
  );
}
