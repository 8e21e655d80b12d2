/** Measures a result beside its original: quality, distance and topology. */

import type { Certificate, Measured } from '../body/body_result';
import type { PreparedBody } from '../body/prepared_body';
import type { Core, Inspection, MeshAt, SurfaceDistance, TriangleMesh } from '../core/core';

/** Measures the result as a reader of the exported file finds it. */
export function measureResult(core: Core, prepared: PreparedBody, { mesh }: Pick<MeshAt, 'mesh'>): Measured {
  const weld = core.weld(mesh.positions, mesh.triangles, { tolerance: 0 });
  const { inspection } = weld;
  return {
    weld,
    inspection,
    quality: core.measureQuality(mesh),
    distance: measureDistance(core, prepared, mesh),
    certificate: compareTopology(prepared.inspection, inspection),
  };
}

/** What has been measured, so that guard, fit and report measure the same mesh once. */
const measured = new WeakMap<TriangleMesh, { prepared: PreparedBody; distance: SurfaceDistance }>();

/** Between the prepared mesh and `other`, in % of the prepared mesh's diagonal. Neither may have changed since the last call. */
export function measureDistance(core: Core, prepared: PreparedBody, other: TriangleMesh): SurfaceDistance {
  const known = measured.get(other);
  if (known?.prepared === prepared) return known.distance;
  const distance = distanceInPercent(core, prepared, other);
  measured.set(other, { prepared, distance });
  return distance;
}

function distanceInPercent(core: Core, prepared: PreparedBody, other: TriangleMesh): SurfaceDistance {
  const distance = core.measureSurfaceDistance(prepared.mesh, other);
  const percent = 100 / prepared.diagonal;
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
