/** The elastic model that a body is simulated with by default, without the solver of an engine. */

import type { Inspection } from '../core/core';

/** `both`: some of its parts are solids, others shells. */
export type DefaultModel = 'solid' | 'shell' | 'both';

/** The model of a body: closed components with a volume are solids, all others shells. */
export function defaultModelOf({ components, solidComponents }: Inspection): DefaultModel {
  if (solidComponents === 0) return 'shell';
  return solidComponents === components ? 'solid' : 'both';
}
