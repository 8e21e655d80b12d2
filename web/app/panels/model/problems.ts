/** The problem of a mesh of the file, in one line. */

import type { OpenedBody } from '../../worker/protocol';
import { say, sentence } from '../../language/say';

/** '' if nothing limits its use. */
export function describeProblems({ health }: OpenedBody): string {
  if (health === null) return say('It cannot be used, and is left unchanged');
  const limits = health.filter(({ kind }) => kind === 'limit').map(({ text }) => sentence(text));
  return limits.join('; ');
}
