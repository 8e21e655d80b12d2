/** One slab with two models, which separates the error of the theory from that of the mesh. */

import type { Core } from '../../../web/engine/core/core';
import { plateFrequencies } from '../analytic/plate';
import { box, plate } from '../meshes';
import { POISSON, modesOf } from './case';
import type { CaseResult, Run } from './case';

const THICKNESSES = [0.01, 0.02, 0.05, 0.1, 0.2];
const CELLS = 32;

/** Frequency parameters omega a^2 sqrt(rho h / D) of the first five modes of a free slab of side 1. */
function slabRun(core: Core, kind: 'shell' | 'solid', thickness: number): Run {
  const layers = Math.max(1, Math.round(CELLS * thickness));
  const mesh =
    kind === 'shell' ? plate(CELLS, 'regular') : box([1, 1, thickness], [CELLS, CELLS, layers], 'regular');
  const { modes } = modesOf(core, mesh, { model: kind, thickness, modeCount: 5 });
  const rigidity = thickness ** 2 / (12 * (1 - POISSON ** 2));
  const computed = modes.map(({ omega }) => omega / Math.sqrt(rigidity));
  return { kind, size: `thickness ${thickness}`, faces: mesh.triangles.length / 3, computed };
}

export function slabCase(core: Core): CaseResult {
  return {
    id: 'slab',
    title: 'One slab, two models',
    setting: `The free square plate once more, as a shell on its middle surface and as a solid on its closed surface, ${CELLS} cells a side, for five thicknesses. Frequencies as omega a^2 sqrt(rho h / D), in which thin-plate theory does not depend on the thickness.`,
    reference: 'Thin-plate theory, as for the free plate.',
    reading:
      'The rows of the shell are nearly equal: the model is the theory, and the differences are due to its mesh. The solid follows the theory if the slab is thin and deviates from it as it gets thicker, because a thick slab also shears: at a tenth of its side by 4 to 9 %. There the theory is wrong, not the solid. So use the shell for sheets up to about a twentieth of their size; for anything thicker close the surface and use the solid.',
    quantities: plateFrequencies('free', POISSON, 5).map((analytic, k) => ({
      name: `mode ${k + 1}`,
      analytic,
    })),
    runs: (['shell', 'solid'] as const).flatMap((kind) =>
      THICKNESSES.map((thickness) => slabRun(core, kind, thickness)),
    ),
    isSecondOrder: false,
    digits: 3,
  };
}
