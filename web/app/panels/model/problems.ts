/** What is wrong with a mesh of the file, in one line. */

import type { OpenedBody } from '../../worker/protocol';

/** '' where nothing limits what can be done with it. */
export function describeProblems({ health }: OpenedBody): string {
  if (health === null) return 'It cannot be used, and stays as it is';
  const limits = health.filter(({ kind }) => kind === 'limit').map(({ text }) => text);
  return limits.join('; ');
}
