/** A setup of the Test step whose meshes stand as the scene does. */

import { turned } from '../../engine/motion/turned';
import type { TwinSetup } from './simulation_protocol';

export function standingSetup(setup: TwinSetup): TwinSetup {
  const { original, result, turn } = setup;
  const { mesh } = result;
  return {
    ...setup,
    original: { ...original, positions: turned(original.positions, turn) },
    result: { ...result, mesh: { ...mesh, positions: turned(mesh.positions, turn) } },
  };
}
