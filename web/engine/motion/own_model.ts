/** What a body moves as where no solver of an engine is chosen and nothing else is asked for. */

import type { Inspection } from '../core/core';

/** `both`: some of its parts are solids, others shells. */
export type OwnModel = 'solid' | 'shell' | 'both';

/** The core divides a body into solids and shells, and counts them where it inspects the mesh. */
export function ownModelOf({ components, solidComponents }: Inspection): OwnModel {
  if (solidComponents === 0) return 'shell';
  return solidComponents === components ? 'solid' : 'both';
}
