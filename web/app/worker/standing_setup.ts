/** A setup of the Test step whose meshes are oriented as in the scene. */

import { rotated } from '../../engine/motion/scene_rotation';
import type { TwinSetup } from './simulation_protocol';

export function standingSetup(setup: TwinSetup): TwinSetup {
  const { original, result, rotation } = setup;
  const { mesh } = result;
  return {
    ...setup,
    original: { ...original, positions: rotated(original.positions, rotation) },
    result: { ...result, mesh: { ...mesh, positions: rotated(mesh.positions, rotation) } },
  };
}
