/** Calls of the core as data, so that those of many bodies can be made side by side. */

import type { Core, ManyFunctions, ManyName } from '../../core/core';
import { onceIn } from './equal_work';
import type { EqualWork } from './equal_work';

export interface CoreCall<Name extends ManyName = ManyName> {
  name: Name;
  values: Parameters<ManyFunctions[Name]>;
}

export const coreCall = <Name extends ManyName>(
  name: Name,
  ...values: Parameters<ManyFunctions[Name]>
): CoreCall<Name> => ({ name, values });

/** The result of a call, which is made unless `work` remembers it. */
export function resultOf<Name extends ManyName>(
  core: Core,
  work: EqualWork | undefined,
  { name, values }: CoreCall<Name>,
): ReturnType<ManyFunctions[Name]> {
  return onceIn(work, name, values, () => {
    const call = core[name] as (...values: unknown[]) => ReturnType<ManyFunctions[Name]>;
    return call(...values);
  });
}

/** The result of a call that `work` remembers; undefined: it has not been made, or has failed. */
export const knownResult = <Name extends ManyName>(
  work: EqualWork,
  { name, values }: CoreCall<Name>,
): ReturnType<ManyFunctions[Name]> | undefined =>
  work.known(name, values) as ReturnType<ManyFunctions[Name]> | undefined;

/**
 * Makes calls of one function side by side, so that `work` remembers their results. Calls that would throw an Error are left to
 * `resultOf`.
 */
export function callAll(core: Core, work: EqualWork, calls: CoreCall[]): void {
  if (calls.length === 0) return;
  const [{ name }] = calls;
  work.fill(
    name,
    calls.map(({ values }) => values),
    (missing) => core.callAll(name, missing as CoreCall['values'][]),
  );
}
