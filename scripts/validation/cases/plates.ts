/** Thin square plates, modelled as shells. */

import type { Core } from '../../../web/engine/core/core';
import { plateFrequencies, supportedPlateFrequencies } from '../analytic/plate';
import { plate } from '../meshes';
import type { MeshKind } from '../meshes';
import { POISSON, modesOf, verticesWhere } from './case';
import type { CaseResult, Run } from './case';

const KINDS: MeshKind[] = ['regular', 'union jack', 'irregular', 'graded'];
const CELLS = [8, 16, 32, 64];
const THICKNESS = 0.01;
const RIGIDITY = THICKNESS ** 3 / (12 * (1 - POISSON ** 2));

type Support = 'free' | 'supported' | 'clamped' | 'cantilever';

/** Frequency parameters omega a^2 sqrt(rho h / D) of the first six modes. */
export function plateRun(core: Core, support: Support, cells: number, kind: MeshKind): Run {
  const frames = { free: 'none', supported: 'none', clamped: 'all', cantilever: 'left' } as const;
  const mesh = plate(cells, kind, frames[support]);
  const isOutside = (t: number) => t <= 0 || t >= 1;
  const pinned = verticesWhere(mesh, (x, y) => {
    if (support === 'free') return false;
    return support === 'cantilever' ? x <= 0 : isOutside(x) || isOutside(y);
  });
  const { modes } = modesOf(core, mesh, { thickness: THICKNESS, modeCount: 6, pinned });
  const computed = modes.map(({ omega }) => omega * Math.sqrt(THICKNESS / RIGIDITY));
  return { kind, size: `${cells} x ${cells}`, faces: mesh.triangles.length / 3, computed };
}

const TEXTS: Record<Support, Pick<CaseResult, 'title' | 'setting' | 'reference' | 'reading'>> = {
  free: {
    title: 'Free square plate',
    setting:
      'Model shell; side 1, thickness 0.01, Poisson 0.3, no pins. Frequencies as omega a^2 sqrt(rho h / D).',
    reference:
      "Thin-plate theory has no closed form here; the values are Ritz's method with 12 x 12 Legendre polynomials, run by the script. They agree with the published values, 13.468 19.596 24.270 34.801 34.801 61.093 (Leissa 1969 and 1973 gives upper bounds of these).",
    reading:
      'Model and reference use the same theory, so the whole difference is due to the mesh: it decreases with the square of the cell size on every kind of mesh, and the computed values are always too low.',
  },
  supported: {
    title: 'Square plate on hinges',
    setting:
      'As above, with every vertex of the border pinned. A line of pinned vertices fixes the position but not the slope: a hinge.',
    reference: 'Exact: pi^2 (m^2 + n^2) (Navier 1823).',
    reading:
      'Again the whole difference is due to the mesh. Pinning only the border gives hinges; see the next case for clamps.',
  },
  clamped: {
    title: 'Clamped square plate',
    setting:
      'As above, with one more row of cells around the plate, all of its vertices pinned. Faces whose vertices are all pinned also fix the slope at their edges.',
    reference:
      "Ritz's method with 12 x 12 Legendre polynomials whose value and slope vanish at the border; published: 35.985 73.39 73.39 108.22 131.58 132.20 (Leissa 1973).",
    reading:
      'The whole difference is due to the mesh. The frame has hardly any influence: the width of its cells does not matter, since it cannot move.',
  },
  cantilever: {
    title: 'Square plate clamped along one side',
    setting: 'As above, with one more row of cells beyond the side x = 0, pinned together with that side.',
    reference:
      "Ritz's method with 12 x 12 Legendre polynomials (published: 3.471 8.507 21.29 27.20 30.96 54.19; the corners at the clamped side make it converge slowly, so the last digit of the reference is uncertain).",
    reading:
      'The whole difference is due to the mesh, as for the free plate, except for the uncertain last digit of the reference.',
  },
};

export function plateCases(core: Core): CaseResult[] {
  return (['free', 'supported', 'clamped', 'cantilever'] as const).map((support) => {
    const values =
      support === 'supported' ? supportedPlateFrequencies(6) : plateFrequencies(support, POISSON, 6);
    return {
      id: `plate-${support}`,
      ...TEXTS[support],
      quantities: values.map((analytic, k) => ({ name: `mode ${k + 1}`, analytic })),
      runs: KINDS.flatMap((kind) => CELLS.map((cells) => plateRun(core, support, cells, kind))),
      isSecondOrder: true,
      digits: 3,
    };
  });
}
