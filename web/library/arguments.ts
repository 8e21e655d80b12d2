/** Checks the arguments of callers besides models before anything is sent to the worker, which checks the values of options. */

import { excerpt, quotedValue } from '../engine/core/words';
import { LimberError } from './options';

/** Throws LimberError where these are no options. */
export function checkOptions(options: unknown): void {
  if (!isObject(options))
    throw new LimberError(
      `The options are ${quotedValue(options)}: give an object such as { solver: "jolt" }, or leave them out.`,
    );
  // Most of these could not even be sent to the worker, which refuses all others that are no options.
  const misplaced = Object.keys(RUN).find((name) => Object.hasOwn(options, name));
  if (misplaced)
    throw new LimberError(
      `The options have "${misplaced}", which is of the run: give { ${misplaced} } as an argument of its own after them.`,
    );
}

/** Per key of RunOptions whether a value is one of it, and what to give in its place. */
const RUN: Record<string, { isAllowed: (value: unknown) => boolean; words: string }> = {
  signal: { isAllowed: isSignal, words: 'the signal of an AbortController' },
  onProgress: { isAllowed: (value) => typeof value === 'function', words: 'a function' },
  assets: {
    isAllowed: (value) => typeof value === 'string' || value instanceof URL,
    words: 'the address of a folder',
  },
};

/** Throws LimberError where these are no options of a run. */
export function checkRun(run: unknown): void {
  const known = Object.keys(RUN).join(', ');
  if (!isObject(run))
    throw new LimberError(`run is ${quotedValue(run)}: give an object with ${known}, or leave it out.`);
  for (const [name, value] of Object.entries(run)) {
    if (!Object.hasOwn(RUN, name))
      throw new LimberError(`run has "${excerpt(name)}", which is not known: it takes ${known}.`);
    const { isAllowed, words } = RUN[name];
    if (value !== undefined && !isAllowed(value))
      throw new LimberError(`run.${name} is ${quotedValue(value)}: give ${words}.`);
  }
}

const isObject = (value: unknown): value is object =>
  typeof value === 'object' && value !== null && !Array.isArray(value);

/** Signals may come from another realm, or from a library. */
function isSignal(value: unknown): boolean {
  const { aborted, addEventListener } = (value ?? {}) as Partial<AbortSignal>;
  return typeof aborted === 'boolean' && typeof addEventListener === 'function';
}
