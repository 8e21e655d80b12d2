/** Compares the results of methods on a body at one number of faces, with the same measures. */

import type { PreparedBody } from '../../body/prepared_body';
import type { Core, TriangleMesh } from '../../core/core';
import { METHOD_NAMES } from '../../core/methods';
import type { Method } from '../../core/methods';
import { faceCount } from '../../core/mesh';
import { methodChange } from '../../settings/methods';
import type { Settings } from '../../settings/options';
import { BodyRun } from '../body_run';
import { bodyFidelity, measureResult } from '../measure';
import { STAGES } from '../stages';
import { meshoptimizerCall } from './meshoptimizer';
import { sizesOf } from './sizes';

/** The elastic modes whose frequencies are compared. */
const MODE_COUNT = 10;

/** Methods of Limber, and calls of meshoptimizer. */
export const COMPARED_METHODS = [
  ...METHOD_NAMES,
  'meshoptimizer simplify',
  'meshoptimizer update',
] as const satisfies readonly string[];

export type ComparedMethod = (typeof COMPARED_METHODS)[number];

/** Whether this is one of Limber's own methods, whose results can be shown, tested and exported. */
export const isOwnMethod = (name: ComparedMethod): name is Method =>
  (METHOD_NAMES as readonly string[]).includes(name);

export interface MethodResult {
  name: ComparedMethod;
  mesh: TriangleMesh;
  faces: number;
  /** Hausdorff distance and mean distance from the original, both ways, % of its diagonal */
  hausdorff: number;
  mean: number;
  /** mean over modes 1 to 10 of the shell, %; null: its modes cannot be found */
  frequencyErrorMean: number | null;
  /** subspace MAC, 0..1; null as above */
  macMin: number | null;
  /** degrees */
  minAngle: number;
  /** change of the whole surface's area and of the enclosed volume, %; null: the surface is open */
  areaChange: number;
  volumeChange: number | null;
  /** whether components, genus and boundary loops are the original's */
  isTopologyKept: boolean;
  /** from the welded mesh to the result, modes and fit included */
  seconds: number;
  /** why the frequencies are missing, in one sentence; otherwise empty */
  failure: string;
}

/** The settings of a method as the page would use them once it is chosen. */
export const settingsForMethod = (settings: Settings, method: Method): Settings =>
  settings.method === method ? settings : { ...settings, ...methodChange(method) };

/** The settings without the limits that can stop a method at another number of faces. */
export const withoutLimits = (settings: Settings): Settings => ({
  ...settings,
  ...{ maxDeviation: 0, maxFrequencyError: 0, minAngle: 0 },
});

/** Runs one method on the body of `run`, whose own values stay as they are. `faces`: the most that the result may have. */
export async function resultAtBudget(
  run: BodyRun,
  settings: Settings,
  { name, faces }: { name: ComparedMethod; faces: number },
): Promise<MethodResult> {
  const { core } = run.context;
  const prepared = run.get(STAGES.prepared, settings);
  const { mesh, seconds } = isOwnMethod(name)
    ? resultWithin(run, settingsForMethod(settings, name), faces)
    : await meshoptimizerResult(name, prepared.mesh, faces);
  return { name, mesh, seconds, ...measuredAlike(core, prepared, settings, mesh) };
}

interface TimedMesh {
  mesh: TriangleMesh;
  seconds: number;
}

/** The result that the page shows; where its limits stop it above the budget, the one without them. */
function resultWithin(run: BodyRun, settings: Settings, faces: number): TimedMesh {
  const limited = ownResult(run, settings, faces);
  return faceCount(limited.mesh) <= faces ? limited : ownResult(run, withoutLimits(settings), faces);
}

/** In a run of its own: another method's history would take the place of the one that the page shows. */
function ownResult({ context }: BodyRun, settings: Settings, faces: number): TimedMesh {
  const own = new BodyRun({ ...context, cache: undefined, onTry: undefined });
  const request = { ...settings, targetFaces: faces };
  try {
    own.get(STAGES.pinned, request);
    const start = performance.now();
    const { mesh } = own.get(STAGES.fitted, request).result;
    return { mesh, seconds: (performance.now() - start) / 1000 };
  } finally {
    own.dispose();
  }
}

async function meshoptimizerResult(
  name: Exclude<ComparedMethod, Method>,
  original: TriangleMesh,
  faces: number,
): Promise<TimedMesh> {
  const simplify = await meshoptimizerCall(name === 'meshoptimizer update' ? 'update' : 'simplify');
  const start = performance.now();
  const mesh = simplify(original, faces);
  return { mesh, seconds: (performance.now() - start) / 1000 };
}

/** With the measures of the report: see `measureResult` and `compareFidelity`. */
function measuredAlike(core: Core, prepared: PreparedBody, settings: Settings, mesh: TriangleMesh) {
  const { weld, quality, distance, certificate } = measureResult(core, prepared, { mesh });
  const { fidelity, failure } = bodyFidelity(core, prepared, weld.mesh, {
    ...settings,
    modeCount: MODE_COUNT,
  });
  const [before, after] = [sizesOf(prepared.mesh), sizesOf(mesh)];
  const isClosed = prepared.inspection.boundaryLoops === 0 && before.volume !== 0;
  return {
    faces: faceCount(mesh),
    hausdorff: distance.hausdorff,
    mean: distance.mean,
    frequencyErrorMean: fidelity?.frequencyErrorMean ?? null,
    macMin: fidelity?.macMin ?? null,
    minAngle: quality.minAngle,
    areaChange: 100 * (after.area / before.area - 1),
    volumeChange: isClosed ? 100 * (after.volume / before.volume - 1) : null,
    isTopologyKept: certificate.kept,
    failure,
  };
}
