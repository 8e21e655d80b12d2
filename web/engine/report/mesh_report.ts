/** Counts and angles of the meshes of all bodies together. */

import type { InspectedBody } from '../body/prepared_body';
import type { Inspection } from '../core/core';
import { faceCount, sum } from '../core/mesh';

/** The counts of the inspection are those of the welded mesh without degenerate faces, duplicate faces included. */
export interface MeshReport extends Omit<Inspection, 'orientationClashes' | 'solidComponents'> {
  degenerateFaces: number;
  duplicateFaces: number;
  /** faces whose winding was reversed so that neighbours agree */
  flippedFaces: number;
  weldedVertices: number;
  /** degrees; absent where there is no usable face */
  minAngle?: number;
  meanMinAngle?: number;
}

/** Counts are sums over the bodies, `minAngle` the smallest and `meanMinAngle` the mean over all faces. */
export function meshReport(bodies: InspectedBody[]): MeshReport {
  const sumOf = (key: Exclude<keyof Inspection, 'genus'>) =>
    sum(bodies.map(({ weld }) => weld.inspection[key]));
  const counted = (key: 'degenerateFaces' | 'duplicateFaces' | 'flippedFaces' | 'weldedVertices') =>
    sum(bodies.map(({ weld }) => weld[key]));
  const genera = bodies.map(({ weld }) => weld.inspection.genus);
  return {
    vertices: sumOf('vertices'),
    faces: sumOf('faces'),
    components: sumOf('components'),
    boundaryLoops: sumOf('boundaryLoops'),
    genus: genera.includes(null) ? null : sum(genera as number[]),
    eulerCharacteristic: sumOf('eulerCharacteristic'),
    nonManifoldEdges: sumOf('nonManifoldEdges'),
    nonManifoldVertices: sumOf('nonManifoldVertices'),
    degenerateFaces: counted('degenerateFaces'),
    duplicateFaces: counted('duplicateFaces'),
    flippedFaces: counted('flippedFaces'),
    weldedVertices: counted('weldedVertices'),
    ...angles(bodies),
  };
}

function angles(bodies: InspectedBody[]): Pick<MeshReport, 'minAngle' | 'meanMinAngle'> {
  const usable = bodies.filter(({ quality }) => quality !== null);
  if (usable.length === 0) return {};
  const faces = usable.map(({ weld }) => faceCount(weld.mesh));
  const weighted = usable.map(({ quality }, i) => quality!.meanMinAngle * faces[i]);
  return {
    minAngle: Math.min(...usable.map(({ quality }) => quality!.minAngle)),
    meanMinAngle: sum(weighted) / sum(faces),
  };
}
