/** The targets of limber optimize in the form of the engine. */

import { OPTIONS } from '../engine/settings/options';
import { NAMED_TARGETS } from '../engine/stages/missed_targets';
import type { AskedTargets } from '../engine/stages/missed_targets';
import type { Arguments } from './arguments';

export const askedOf = ({ faces, ratio, asked, settings }: Arguments): AskedTargets => ({
  ...{ faces, ratio, settings },
  named: new Set(NAMED_TARGETS.filter((name) => asked.has(OPTIONS[name].flag))),
});
