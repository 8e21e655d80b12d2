/** Bars of square cross-section, modelled as solids. */

import type { Core, Mode, ModeName } from '../../../web/engine/core/core';
import { stretch, timoshenkoBending, twist } from '../analytic/bar';
import { box } from '../meshes';
import type { MeshKind } from '../meshes';
import { POISSON, modesOf, verticesWhere } from './case';
import type { CaseResult, Run } from './case';

const KINDS: MeshKind[] = ['regular', 'irregular', 'graded'];
const FREE = { side: 1, length: 3, poisson: POISSON };
const CLAMPED = { side: 1, length: 6, poisson: POISSON };

/** Bending pairs 1 and 2, twist 1 and stretch 1, distinguished by the names from the core. */
export function barRun(core: Core, isClamped: boolean, cells: number, kind: MeshKind): Run {
  const { length } = isClamped ? CLAMPED : FREE;
  const mesh = box([1, 1, length], [cells, cells, cells * length], kind);
  const pinned = verticesWhere(mesh, (_x, _y, z) => isClamped && z === 0);
  const { modes } = modesOf(core, mesh, { model: 'solid', modeCount: 10, pinned });
  const bends = named(modes, 'bend');
  const computed = [
    (bends[0] + bends[1]) / 2,
    (bends[2] + bends[3]) / 2,
    named(modes, 'twist')[0],
    named(modes, 'stretch')[0],
  ];
  return {
    kind,
    size: `${cells} x ${cells} x ${cells * length}`,
    faces: mesh.triangles.length / 3,
    computed,
  };
}

const named = (modes: Mode[], name: ModeName) =>
  modes.filter((mode) => mode.name === name).map(({ omega }) => omega);

function barCase(
  core: Core,
  isClamped: boolean,
): Pick<CaseResult, 'quantities' | 'runs' | 'isSecondOrder' | 'digits'> {
  const bar = isClamped ? CLAMPED : FREE;
  const bending = timoshenkoBending(bar, isClamped, 2);
  const first = isClamped ? 0.5 : 1;
  return {
    quantities: [
      { name: 'bend 1', analytic: bending[0] },
      { name: 'bend 2', analytic: bending[1] },
      { name: 'twist 1', analytic: twist(bar, first) },
      { name: 'stretch 1', analytic: stretch(bar, first) },
    ],
    runs: KINDS.flatMap((kind) => [2, 4, 8, 16].map((cells) => barRun(core, isClamped, cells, kind))),
    isSecondOrder: false,
    digits: 4,
  };
}

const THEORIES =
  "Bending: Timoshenko's beam (shear factor of Cowper 1966), its frequency equation solved by the script; twist: Saint-Venant, J = 0.1406 side^4 (Timoshenko and Goodier 1970); stretch: the thin bar.";

export function barCases(core: Core): CaseResult[] {
  return [
    {
      id: 'bar-held',
      title: 'Cantilever beam',
      setting:
        'Model solid; 1 x 1 x 6, Poisson 0.3, every vertex of the end z = 0 pinned. omega with E = rho = 1; bending is the mean of a pair.',
      reference: THEORIES,
      reading:
        'The flat sides are the same in every mesh, and the lattice has about 2,000 cells on any mesh: the remaining errors on fine meshes are those of the lattice and of the theories. A face whose corners are all pinned is fixed over its whole area, so the clamp does not depend on the number of vertices at the end. The pinned end cannot warp or contract, which no beam theory takes into account; so the real frequencies of bending are a little higher than theirs.',
      ...barCase(core, true),
    },
    {
      id: 'bar-free',
      title: 'Free bar: bend, twist, stretch',
      setting:
        'Model solid; 1 x 1 x 3, Poisson 0.3, free. omega with E = rho = 1; bending is the mean of a pair.',
      reference: THEORIES,
      reading:
        "All meshes give the same values, because they bound the same body and the lattice is the same. A bar three times as long as wide is short for beam theory: its sides move in and out as it stretches (Poisson's effect), which lowers the real frequency of stretching by about 1 %, and the second bending mode is at the limit of Timoshenko's theory.",
      ...barCase(core, false),
    },
  ];
}
