/** Which validator messages on a result its input had already. */

import type { Validation } from '../validate';

/** How many messages of `result` the input had too: per code, at most as many as there were. */
export function knownMessages(result: Validation, input: Validation): number {
  const left = new Map<string, number>();
  for (const message of input.messages) left.set(codeOf(message), (left.get(codeOf(message)) ?? 0) + 1);
  return result.messages.filter((message) => {
    const count = left.get(codeOf(message)) ?? 0;
    left.set(codeOf(message), count - 1);
    return count > 0;
  }).length;
}

const codeOf = (message: string): string => message.split(' at ', 1)[0];
