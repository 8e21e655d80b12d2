/** A solid sphere. */

import type { Core, ModeSet, TriangleMesh } from '../../../web/engine/core/core';
import { breathing, spheroidal, torsional } from '../analytic/sphere';
import { sphere } from '../meshes';
import type { MeshKind } from '../meshes';
import { groupMeans, modesOf } from './case';
import type { CaseResult, Run } from './case';

const KINDS: MeshKind[] = ['regular', 'irregular', 'graded'];
/** At 0.3 breathing would coincide with a spheroidal frequency of l = 4, and the lattice would mix them. */
const POISSON = 0.25;
const SHEAR_SPEED = Math.sqrt(1 / (2 * (1 + POISSON)));
const MODES = 30;

/** The character of a mode: the share of radial motion in its energy, and how uniformly that is outwards. */
function radialMotion({ positions }: TriangleMesh, { shapes }: ModeSet, ordinal: number) {
  let [all, radial, outwards] = [0, 0, 0];
  for (let v = 0; v < positions.length; v += 3) {
    const shape = shapes.subarray(ordinal * positions.length + v, ordinal * positions.length + v + 3);
    const along = shape[0] * positions[v] + shape[1] * positions[v + 1] + shape[2] * positions[v + 2];
    all += shape[0] ** 2 + shape[1] ** 2 + shape[2] ** 2;
    radial += along ** 2;
    outwards += along;
  }
  return { radial: radial / all, even: outwards ** 2 / (radial * (positions.length / 3) || 1) };
}

/** omega R / c_T: torsional l = 2, 3; spheroidal l = 2, 1, 3; breathing. Members of a frequency are averaged. */
export function sphereRun(core: Core, cuts: number, kind: MeshKind): Run {
  const mesh = sphere(cuts, kind);
  const set = modesOf(core, mesh, { model: 'solid', poisson: POISSON, modeCount: MODES });
  const sorted: Record<'torsional' | 'spheroidal' | 'breathing', number[]> = {
    torsional: [],
    spheroidal: [],
    breathing: [],
  };
  for (const { omega, ordinal } of set.modes) {
    const { radial, even } = radialMotion(mesh, set, ordinal);
    const family = radial < 0.01 ? 'torsional' : radial > 0.8 && even > 0.8 ? 'breathing' : 'spheroidal';
    sorted[family].push(omega / SHEAR_SPEED);
  }
  const computed = [
    ...groupMeans(sorted.torsional, [5, 7]),
    ...groupMeans(sorted.spheroidal, [5, 3, 7]),
    sorted.breathing[0] ?? NaN,
  ];
  return { kind, size: `${cuts} cuts`, faces: mesh.triangles.length / 3, computed };
}

export function sphereCase(core: Core): CaseResult {
  return {
    id: 'sphere',
    title: 'Solid sphere',
    setting:
      "Model solid; radius 1, Poisson 0.25 (Lamb's own choice), free. Frequencies as omega R / c_T; each is the mean of its 2 l + 1 members. Regular is an octahedron with subdivided edges, irregular the same with moved vertices, graded a globe of longitudes and latitudes with needles at its poles.",
    reference: "Exact: Lamb's equations (1882), solved by the script.",
    reading:
      'The facets lie within the sphere, so a coarse mesh is too small and its frequencies are too high; that error decreases with the square of the cell size. The remaining error on the finest mesh is that of the lattice of about 2,000 cells.',
    quantities: [
      { name: 'torsional, l = 2', analytic: torsional(2, 1)[0] },
      { name: 'torsional, l = 3', analytic: torsional(3, 1)[0] },
      { name: 'spheroidal, l = 2', analytic: spheroidal(2, POISSON, 1)[0] },
      { name: 'spheroidal, l = 1', analytic: spheroidal(1, POISSON, 1)[0] },
      { name: 'spheroidal, l = 3', analytic: spheroidal(3, POISSON, 1)[0] },
      { name: 'breathing', analytic: breathing(POISSON, 1)[0] },
    ],
    runs: KINDS.flatMap((kind) => [4, 8, 16, 32].map((cuts) => sphereRun(core, cuts, kind))),
    isSecondOrder: false,
    digits: 4,
  };
}
