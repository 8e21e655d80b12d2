/** Calls of the core as data, so that those of many bodies can be made in parallel. */

import type { Core, ParallelFunctions, ParallelName } from '../../core/core';
import { onceIn } from './value_cache';
import type { ValueCache } from './value_cache';

export interface CoreCall<Name extends ParallelName = ParallelName> {
  name: Name;
  values: Parameters<ParallelFunctions[Name]>;
}

export const coreCall = <Name extends ParallelName>(
  name: Name,
  ...values: Parameters<ParallelFunctions[Name]>
): CoreCall<Name> => ({ name, values });

/** The result of a call, which is made unless `cache` remembers it. */
export function resultOf<Name extends ParallelName>(
  core: Core,
  cache: ValueCache | undefined,
  { name, values }: CoreCall<Name>,
): ReturnType<ParallelFunctions[Name]> {
  return onceIn(cache, name, values, () => {
    const call = core[name] as (...values: unknown[]) => ReturnType<ParallelFunctions[Name]>;
    return call(...values);
  });
}

/** The result of a call that `cache` remembers; undefined: it has not been made, or has failed. */
export const knownResult = <Name extends ParallelName>(
  cache: ValueCache,
  { name, values }: CoreCall<Name>,
): ReturnType<ParallelFunctions[Name]> | undefined =>
  cache.known(name, values) as ReturnType<ParallelFunctions[Name]> | undefined;

/**
 * Makes calls of one function in parallel, so that `cache` has their results. Calls that would throw an Error are left to
 * `resultOf`.
 */
export function callAll(core: Core, cache: ValueCache, calls: CoreCall[]): void {
  if (calls.length === 0) return;
  const [{ name }] = calls;
  cache.fill(
    name,
    calls.map(({ values }) => values),
    (missing) => core.callAll(name, missing as CoreCall['values'][]),
  );
}
