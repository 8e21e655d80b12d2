/** Checks written files with the Khronos glTF validator. */

import type { SourceFile } from '../engine/document/open';
import { describeAddedErrors } from '../engine/document/validate';
import type { Session } from './session';
import { shownOutput } from './standard';

/** Warns of errors in the result that the input does not have; formats other than glTF are not checked. */
export async function warnOfErrors(session: Session, files: SourceFile[]): Promise<void> {
  const [input, output] = session.args.operands;
  const errors = await describeAddedErrors(files, session.checked.files.get(input)!);
  if (errors === null) return;
  session.warnings.push(
    `the glTF validator finds errors in ${shownOutput(output)} that ${input} does not have: ${errors}`,
  );
}
