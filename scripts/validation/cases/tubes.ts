/** A thin tube and a thin band modelled as shells, and a ring as a solid. */

import type { Core } from '../../../web/engine/core/core';
import { SQUARE_TORSION } from '../analytic/bar';
import { rayleighTube, ringInPlane, ringOutOfPlane, tubeFrequencies } from '../analytic/tube';
import { squareRing, tube } from '../meshes';
import type { MeshKind } from '../meshes';
import { POISSON, errorPercent, groupMeans, modesOf } from './case';
import type { CaseResult, Run } from './case';

const KINDS: MeshKind[] = ['regular', 'irregular', 'graded'];
const TUBE = { radius: 1, length: 4, thickness: 0.01, poisson: POISSON };
const BAND = { radius: 1, length: 0.1, thickness: 0.01, poisson: POISSON };
const RING: [radius: number, side: number] = [1, 0.1];

export function tubeRun(core: Core, around: number, kind: MeshKind): Run {
  const along = Math.round((around * TUBE.length) / (2 * Math.PI));
  const mesh = tube(around, along, kind, [TUBE.radius, TUBE.length]);
  const { modes } = modesOf(core, mesh, { thickness: TUBE.thickness, modeCount: 8 });
  const computed = groupMeans(
    modes.map(({ omega }) => omega),
    [2, 2, 2, 2],
  );
  return { kind, size: `${around} around, ${along} along`, faces: mesh.triangles.length / 3, computed };
}

function tubeCase(core: Core): CaseResult {
  const [two, three] = [2, 3].map((n) => tubeFrequencies(TUBE, n, 2));
  const rayleigh = rayleighTube(TUBE, 2);
  return {
    id: 'tube',
    title: 'Thin tube with open ends',
    setting:
      'Model shell; radius 1, length 4, thickness 0.01, Poisson 0.3, free. omega with E = rho = 1; each value is the mean of a pair. n is the number of waves around the tube.',
    reference: `Ritz's method on the thin-shell theory of Sanders and Koiter, run by the script. Rayleigh's formula (1894), in which all cross-sections bend in the same way and the ends have no conditions, gives ${rayleigh.toFixed(6)} for the first: ${errorPercent(rayleigh, two[0]).toFixed(2)} % more.`,
    reading:
      'The facets of the mesh are flat, so bending and stretching of a curved shell are coupled only at the edges between them: that error, too, decreases with the square of the cell size. Below about 0.2 % the theories themselves differ.',
    quantities: [
      { name: 'n = 2, all alike', analytic: two[0] },
      { name: 'n = 2, ends opposed', analytic: two[1] },
      { name: 'n = 3, all alike', analytic: three[0] },
      { name: 'n = 3, ends opposed', analytic: three[1] },
    ],
    runs: KINDS.flatMap((kind) => [24, 48, 96, 144].map((around) => tubeRun(core, around, kind))),
    isSecondOrder: true,
    digits: 6,
  };
}

export function bandRun(core: Core, across: number, kind: MeshKind): Run {
  const around = Math.round((2 * Math.PI * across) / BAND.length);
  const mesh = tube(around, across, kind, [BAND.radius, BAND.length]);
  const { modes } = modesOf(core, mesh, { thickness: BAND.thickness, modeCount: 6 });
  const computed = groupMeans(
    modes.map(({ omega }) => omega),
    [2, 2, 2],
  );
  return { kind, size: `${around} around, ${across} across`, faces: mesh.triangles.length / 3, computed };
}

function bandCase(core: Core): CaseResult {
  const [two, three] = [2, 3].map((n) => tubeFrequencies(BAND, n, 2));
  const thin = ringInPlane(1, BAND.thickness ** 2 / 12, 1, 2);
  return {
    id: 'ring-shell',
    title: 'Thin ring as a shell',
    setting:
      'Model shell; a band of radius 1, width 0.1, thickness 0.01, Poisson 0.3, free. omega with E = rho = 1, means of pairs.',
    reference: `The same thin-shell theory as for the tube. The thin-ring formula omega^2 = (EI / rho A R^4) n^2 (n^2 - 1)^2 / (n^2 + 1) (Hoppe 1871; Love 1944, 293) gives ${thin.toFixed(6)} for the first, ${Math.abs(errorPercent(thin, two[0])).toFixed(2)} % less, because it lets the band curl freely across its width.`,
    reading:
      'The whole difference is due to the mesh. The error of the mode out of the plane, in which the band twists, decreases only in proportion to the cell size, but is within 1 % from the start; the others converge with second order.',
    quantities: [
      { name: 'n = 2, in its plane', analytic: two[0] },
      { name: 'n = 2, out of its plane', analytic: two[1] },
      { name: 'n = 3, in its plane', analytic: three[0] },
    ],
    runs: KINDS.flatMap((kind) => [1, 2, 4, 8].map((across) => bandRun(core, across, kind))),
    isSecondOrder: true,
    digits: 6,
  };
}

export function ringRun(core: Core, perSide: number, kind: MeshKind): Run {
  const around = 32 * perSide;
  const mesh = squareRing(around, perSide, kind, RING);
  const { modes } = modesOf(core, mesh, { model: 'solid', modeCount: 8 });
  const pairs = groupMeans(
    modes.map(({ omega }) => omega),
    [2, 2, 2, 2],
  );
  return {
    kind,
    size: `${around} around, ${perSide} a side`,
    faces: mesh.triangles.length / 3,
    computed: pairs,
  };
}

function ringCase(core: Core): CaseResult {
  const [radius, side] = RING;
  const twist = (SQUARE_TORSION * 12) / (2 * (1 + POISSON));
  const bending = side ** 2 / 12;
  return {
    id: 'ring-solid',
    title: 'Ring as a solid',
    setting:
      'Model solid; radius 1, square cross-section of side 0.1, Poisson 0.3, free. omega with E = rho = 1, means of pairs.',
    reference:
      'Thin-ring formulas: in its plane as above; out of its plane (EI / rho A R^4) n^2 (n^2 - 1)^2 / (n^2 + EI / GJ) (Michell 1889; Love 1944, 293), J = 0.1406 side^4.',
    reading:
      "Three errors add up: the ring is a polygon (this error decreases with the square of the cell size), the lattice of the solid model has about 2,000 cells on any mesh, so three of them across the ring's side (this error remains), and the formulas neglect shear and rotary inertia, which would lower them by roughly 0.7 % for n = 2 and 1.5 % for n = 3. So the lattice itself is about 3 % too stiff here: three cells is the smallest width of a limb at which the result can be trusted to a few percent.",
    quantities: [2, 3].flatMap((n) => [
      { name: `n = ${n}, out of its plane`, analytic: ringOutOfPlane(radius, bending, twist, n) },
      { name: `n = ${n}, in its plane`, analytic: ringInPlane(radius, bending, 1, n) },
    ]),
    runs: KINDS.flatMap((kind) => [1, 2, 4].map((perSide) => ringRun(core, perSide, kind))),
    isSecondOrder: false,
    digits: 5,
  };
}

export const tubeCases = (core: Core): CaseResult[] => [tubeCase(core), bandCase(core), ringCase(core)];
