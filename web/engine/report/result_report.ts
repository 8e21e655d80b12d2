/** The keys of the report about results, fits and further levels. */

import type { FittedResult } from '../body/body_result';
import type { InspectedBody } from '../body/prepared_body';
import type { ModeSet, SurfaceDistance } from '../core/core';
import { sum } from '../core/mesh';
import { meshReport } from './mesh_report';
import type { MeshReport } from './mesh_report';
import { modesReport } from './modes_report';
import { stopReport } from './stop_report';
import type { StoppedBody, StopReport } from './stop_report';

/** What results were fitted to, or were to be. */
export interface FitReport {
  kind: 'surface' | 'modal';
  /** number of edges that a fit to the surface has flipped; absent where no body is fitted */
  flips?: number;
  /** frequency errors before and after a modal fit, in %: those of the part where they are largest; absent where no part is fitted */
  before?: number;
  after?: number;
  /** why bodies, or parts of them, are not fitted */
  unfitted?: string[];
}

/** The input of fitReport for a body. */
export type FitOfBody = Pick<FittedResult, 'kind' | 'flips' | 'errorBefore' | 'errorAfter' | 'unfitted'>;

/** A further level of detail. */
export interface LevelReport {
  /** the name of its file */
  file: string;
  /** the share of the faces of each body that was asked for */
  ratio: number;
  output: MeshReport;
  surface: SurfaceDistance;
  stop: StopReport;
}

/** The maximum of each distance over all bodies. */
export function worstSurface(distances: SurfaceDistance[]): SurfaceDistance {
  const largest = (key: keyof SurfaceDistance) => Math.max(...distances.map((distance) => distance[key]));
  return {
    hausdorff: largest('hausdorff'),
    mean: largest('mean'),
    vertexHausdorff: largest('vertexHausdorff'),
  };
}

/** The input of resultReport for a body. */
export interface ReportedBody {
  measured: InspectedBody & { distance: SurfaceDistance };
  /** the modes that guided its collapses; null where none did */
  modes: ModeSet | null;
  fitted: FitOfBody;
  stopped: StoppedBody;
}

/** The keys about the results of all bodies: output, vibration, fit, surface and stop. */
export function resultReport(bodies: ReportedBody[]) {
  const sets = bodies.flatMap(({ modes }) => modes ?? []);
  return {
    output: meshReport(bodies.map(({ measured }) => measured)),
    ...(sets.length > 0 ? modesReport(sets) : {}),
    ...fitReport(bodies.map(({ fitted }) => fitted)),
    surface: worstSurface(bodies.map(({ measured }) => measured.distance)),
    stop: stopReport(bodies.map(({ stopped }) => stopped)),
  };
}

/** The key `fit`; empty where no fit was requested. */
export function fitReport(fits: FitOfBody[]): { fit?: FitReport } {
  const unfitted = [...new Set(fits.map((fit) => fit.unfitted).filter((why) => why !== ''))];
  const worst = (errors: Float64Array[]) => errors.reduce((most, own) => Math.max(most, ...own), 0);
  const [before, after] = [fits.map((fit) => fit.errorBefore), fits.map((fit) => fit.errorAfter)];
  const kind = fits.some((fit) => fit.kind === 'surface') ? 'surface' : 'modal';
  const hasErrors = after.some((errors) => errors.length > 0);
  const hasFlips = fits.some((fit) => fit.kind === 'surface' && fit.unfitted === '');
  if (unfitted.length === 0 && kind === 'modal' && !hasErrors) return {};
  return {
    fit: {
      kind,
      ...(hasErrors ? { before: worst(before), after: worst(after) } : {}),
      ...(hasFlips ? { flips: sum(fits.map((fit) => fit.flips)) } : {}),
      ...(unfitted.length > 0 ? { unfitted } : {}),
    },
  };
}
