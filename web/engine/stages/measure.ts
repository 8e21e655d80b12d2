/** Measures a result beside its original: quality, distance, topology and vibration. */

import type { Certificate, Measured } from '../body/body_result';
import { trianglesOfLayers } from '../body/layers';
import { materialOf } from '../body/material';
import type { MaterialSettings } from '../body/material';
import type { PreparedBody } from '../body/prepared_body';
import type { Core, Inspection, MeshAt, SurfaceDistance, TriangleMesh } from '../core/core';
import type { BodyFidelity } from '../report/fidelity_report';
import type { Settings } from '../settings/options';

/** Measures the result with all of its layers, as it is in the exported file. */
export function measureResult(core: Core, prepared: PreparedBody, result: MeasuredResult): Measured {
  const { positions, triangles } = result.mesh;
  const { layers } = prepared;
  const { inputOfTriangle } = result;
  const isLayered = layers.most > 1 && inputOfTriangle !== undefined;
  const written = isLayered ? trianglesOfLayers(layers, triangles, inputOfTriangle) : triangles;
  const weld = core.weld(positions, written, { tolerance: 0 });
  const { inspection } = weld;
  const single = isLayered ? core.inspect(weld.mesh) : inspection;
  return {
    weld,
    inspection,
    quality: core.measureQuality(result.mesh),
    distance: measureDistance(core, prepared, result.mesh),
    certificate: compareTopology(prepared.inspection, single),
  };
}

/** A result; without `inputOfTriangle` no triangle has further layers. */
type MeasuredResult = Pick<MeshAt, 'mesh'> & Partial<Pick<MeshAt, 'inputOfTriangle'>>;

/** Cached measurements, so that guard, fit and report measure the same mesh once. */
interface Known {
  mesh: TriangleMesh;
  samples: number;
  hausdorff: number;
  /** null: only the largest distance is known */
  distance: SurfaceDistance | null;
}

const measured = new WeakMap<TriangleMesh, Known>();

function knownOf({ mesh, samples }: PreparedBody, other: TriangleMesh): Known | undefined {
  const known = measured.get(other);
  return known?.mesh === mesh && known.samples === samples ? known : undefined;
}

/** The distance between the prepared mesh and `other`, in % of the prepared mesh's diagonal. Cached by identity: neither may have changed since the last call. */
export function measureDistance(core: Core, prepared: PreparedBody, other: TriangleMesh): SurfaceDistance {
  const known = knownOf(prepared, other)?.distance;
  if (known) return known;
  const { mesh, samples } = prepared;
  return remember(prepared, other, core.measureSurfaceDistance(mesh, other, samples));
}

/** Makes the calls of the core for `measureDistance` of many results in parallel. */
export function measureDistances(
  core: Core,
  results: { prepared: PreparedBody; mesh: TriangleMesh }[],
): void {
  const unknown = results.filter(({ prepared, mesh }) => !knownOf(prepared, mesh)?.distance);
  const lists = unknown.map(({ prepared, mesh }): Parameters<Core['measureSurfaceDistance']> => [
    prepared.mesh,
    mesh,
    prepared.samples,
  ]);
  core.callAll('measureSurfaceDistance', lists).forEach((distance, i) => {
    const { prepared, mesh } = unknown[i];
    if (!(distance instanceof Error)) remember(prepared, mesh, distance);
  });
}

/** `distance`: in units of the mesh. */
function remember(
  { mesh, samples, diagonal }: PreparedBody,
  other: TriangleMesh,
  distance: SurfaceDistance,
): SurfaceDistance {
  const inPercent = distanceInPercent(distance, diagonal);
  measured.set(other, { mesh, samples, hausdorff: inPercent.hausdorff, distance: inPercent });
  return inPercent;
}

/** The largest distance of `measureDistance` alone, in a fraction of its time. */
export function measureDeviation(core: Core, prepared: PreparedBody, other: TriangleMesh): number {
  const known = knownOf(prepared, other);
  if (known) return known.hausdorff;
  const { mesh, samples, diagonal } = prepared;
  const hausdorff = (100 / diagonal) * core.measureHausdorff(mesh, other, samples);
  measured.set(other, { mesh, samples, hausdorff, distance: null });
  return hausdorff;
}

/** Whether `measureDeviation` is at most `limit`, in %, in a fraction of its time. */
export function isWithinDeviation(
  core: Core,
  prepared: PreparedBody,
  other: TriangleMesh,
  limit: number,
): boolean {
  const known = knownOf(prepared, other);
  if (known) return known.hausdorff <= limit;
  return core.isWithinHausdorff(...withinArguments(prepared, other, limit));
}

/** What the core is asked by `isWithinDeviation`. */
export const withinArguments = (
  { mesh, samples, diagonal }: PreparedBody,
  other: TriangleMesh,
  limit: number,
): Parameters<Core['isWithinHausdorff']> => [mesh, other, (limit / 100) * diagonal, samples];

function distanceInPercent(distance: SurfaceDistance, diagonal: number): SurfaceDistance {
  const percent = 100 / diagonal;
  return {
    hausdorff: percent * distance.hausdorff,
    mean: percent * distance.mean,
    vertexHausdorff: percent * distance.vertexHausdorff,
  };
}

export function compareTopology(before: Inspection, after: Inspection): Certificate {
  const components = before.components === after.components;
  const boundaryLoops = before.boundaryLoops === after.boundaryLoops;
  const genus = before.genus === after.genus && before.eulerCharacteristic === after.eulerCharacteristic;
  return { components, boundaryLoops, genus, kept: components && boundaryLoops && genus };
}

type FidelitySettings = MaterialSettings & Pick<Settings, 'modeCount'>;

/** How similarly two bodies vibrate. Throws only if the call was cancelled or the core has failed. */
export function bodyFidelity(
  core: Core,
  prepared: PreparedBody,
  other: TriangleMesh,
  settings: FidelitySettings,
): BodyFidelity {
  const options = { modeCount: settings.modeCount, ...materialOf(prepared, settings) };
  try {
    return { fidelity: core.compareFidelity(prepared.mesh, other, options), failure: '' };
  } catch (error) {
    if (!(error instanceof Error) || error.name === 'Cancelled' || error instanceof WebAssembly.RuntimeError)
      throw error;
    return { fidelity: null, failure: error.message };
  }
}
