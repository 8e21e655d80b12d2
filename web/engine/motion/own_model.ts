/** What a body moves as where no solver of an engine is chosen and nothing else is asked for. */

import { innerEdgesOf } from '../body/hard_edges';
import { JoinedClasses } from '../body/joined_classes';
import type { Classes } from '../body/joined_classes';
import type { Inspection, TriangleMesh } from '../core/core';
import { vertexCount } from '../core/mesh';

/** `both`: some of its parts are solids, others shells. */
export type OwnModel = 'solid' | 'shell' | 'both';

/**
 * Closed parts move as solids and open ones as shells, as `solidHosts` in wasm/mesh/nesting.h divides them. A closed part without volume,
 * which moves as a shell there, counts as a solid.
 */
export function ownModelOf(mesh: TriangleMesh, inspection: Inspection): OwnModel {
  const { boundaryLoops, nonManifoldEdges, orientationClashes, components } = inspection;
  if (boundaryLoops + nonManifoldEdges + orientationClashes === 0) return 'solid';
  if (components === 1) return 'shell';
  const areClosed = new Set(Array.from(openHalvesByPart(mesh), (open) => open === 0));
  if (areClosed.size > 1) return 'both';
  return areClosed.has(true) ? 'solid' : 'shell';
}

/** Per part: its half-edges without exactly one other that runs against them. */
function openHalvesByPart(mesh: TriangleMesh): Int32Array {
  const { triangles } = mesh;
  const { wedges: partOfCorner, count } = partsOf(mesh);
  const open = new Int32Array(count);
  for (const part of partOfCorner) open[part] += 1;
  const { first, second } = innerEdgesOf(mesh);
  first.forEach((half, e) => {
    if (triangles[half] !== triangles[second[e]]) open[partOfCorner[half]] -= 2;
  });
  return open;
}

/** Per corner of the triangles: the number of its connected part. */
function partsOf(mesh: TriangleMesh): Classes {
  const { triangles } = mesh;
  const parts = new JoinedClasses(vertexCount(mesh));
  triangles.forEach((v, corner) => parts.join(v, triangles[corner - (corner % 3)]));
  return parts.classesOf(triangles);
}
