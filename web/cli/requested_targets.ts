/** The targets of limber optimize in the form of the engine. */

import { OPTIONS } from '../engine/settings/options';
import { NAMED_TARGETS } from '../engine/stages/missed_targets';
import type { RequestedTargets } from '../engine/stages/missed_targets';
import type { Arguments } from './arguments';

export const requestedTargets = ({ faces, ratio, asked, settings }: Arguments): RequestedTargets => ({
  ...{ faces, ratio, settings },
  named: new Set(NAMED_TARGETS.filter((name) => asked.has(OPTIONS[name].flag))),
});
