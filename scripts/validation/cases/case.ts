/** The data of a validation case, and its calls of the core. */

import type { Core, ModeSet, ModesOptions, TriangleMesh } from '../../../web/engine/core/core';
import type { MeshKind } from '../meshes';

/** One frequency that is compared. */
export interface Quantity {
  name: string;
  analytic: number;
}

/** One mesh of one case. */
export interface Run {
  kind: MeshKind | 'shell' | 'solid';
  /** e.g. "16 x 16" */
  size: string;
  faces: number;
  /** one value per quantity */
  computed: number[];
}

export interface CaseResult {
  id: string;
  title: string;
  /** what is computed, and with which model */
  setting: string;
  /** the reference and its source */
  reference: string;
  /** why differences remain, and which results can be trusted */
  reading: string;
  quantities: Quantity[];
  runs: Run[];
  /** whether the error should fall with the square of the cell size; the plot then has a reference line */
  isSecondOrder: boolean;
  /** unit of the frequencies in the table */
  digits: number;
}

export const POISSON = 0.3;

/** Modes with E = rho = 1 and lengths in metres; omega is thus in units of sqrt(E / rho) / m. */
export function modesOf(core: Core, mesh: TriangleMesh, options: Partial<ModesOptions>): ModeSet {
  return core.findModes(mesh, {
    model: 'shell',
    direction: -1,
    pinned: new Uint32Array(0),
    exact: true,
    modeCount: 12,
    thickness: 0.01,
    young: 1,
    poisson: POISSON,
    density: 1,
    unit: 1,
    ...options,
  });
}

/** The vertices for which `holds` is true. */
export function verticesWhere(
  { positions }: TriangleMesh,
  holds: (x: number, y: number, z: number) => boolean,
): Uint32Array {
  const found: number[] = [];
  for (let v = 0; 3 * v < positions.length; v++)
    if (holds(positions[3 * v], positions[3 * v + 1], positions[3 * v + 2])) found.push(v);
  return Uint32Array.from(found);
}

/** Means of consecutive groups, whose members share a multiple frequency. */
export function groupMeans(values: number[], sizes: number[]): number[] {
  let first = 0;
  return sizes.map((size) => {
    const group = values.slice(first, (first += size));
    return group.reduce((sum, value) => sum + value, 0) / size;
  });
}

export const errorPercent = (computed: number, analytic: number) => 100 * (computed / analytic - 1);

/** Largest |error| in % over the quantities. */
export const worstError = (run: Run, quantities: Quantity[]) =>
  Math.max(...quantities.map(({ analytic }, k) => Math.abs(errorPercent(run.computed[k], analytic))));

/** The run with the most faces for each kind of mesh. */
export function finest(runs: Run[]): Run[] {
  const last = new Map<Run['kind'], Run>();
  for (const run of runs) if (run.faces >= (last.get(run.kind)?.faces ?? 0)) last.set(run.kind, run);
  return [...last.values()];
}

/** The smallest and largest of the worst errors on the finest mesh of every kind, e.g. "0.3 to 0.9 %". */
export function finestErrors(runs: Run[], quantities: Quantity[]): string {
  const errors = finest(runs).map((run) => worstError(run, quantities));
  const [low, high] = [Math.min(...errors), Math.max(...errors)].map((value) => value.toPrecision(2));
  return low === high ? `${low} %` : `${low} to ${high} %`;
}

/** The face count above which each kind of mesh is within `percent`, e.g. "regular from 512 faces". */
export function facesWithin(percent: number, runs: Run[], quantities: Quantity[]): string {
  return finest(runs)
    .map(({ kind }) => {
      const own = runs.filter((run) => run.kind === kind);
      const lastOutside = own.findLastIndex((run) => !(worstError(run, quantities) <= percent));
      const first = own[lastOutside + 1];
      return first ? `${kind} from ${first.faces} faces` : `${kind} on none of these`;
    })
    .join(', ');
}
