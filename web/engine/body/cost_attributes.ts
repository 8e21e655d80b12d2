/** The attributes that enter the cost of a collapse: texture coordinates, colours, and displacements by animations. */

import type { Document } from '@gltf-transform/core';
import type { TriangleMesh } from '../core/core';
import { length3 } from '../core/exact_math';
import { sum } from '../core/mesh';
import { entriesOf } from './attributes';
import type { Entries } from './attributes';
import { textureWeights } from './texture_contrast';
import { posesOf } from './poses';
import type { Poses } from './poses';
import type { PreparedBody } from './prepared_body';

/** Attributes as lengths divided by the diagonal, so that their errors can be added to geometric ones. */
export interface CostAttributes {
  /** values[dimension * wedge + d] */
  values: Float32Array;
  dimension: number;
  /** how many of the last pose fields count only across the surface; each has three dimensions */
  displacementFields: number;
  /** per triangle: the factor on the cost of errors in texture coordinates; empty: 1 */
  textureWeights: Float32Array;
}

/** The most values per wedge that the core accepts. */
export const MAX_COST_DIMENSIONS = 8;
/** The length, over the diagonal, that a step from black to white counts as. */
const COLOUR_LENGTH = 0.05;

/**
 * UV coordinates, colours and poses of every wedge; null where there are none. UVs count by their length on the surface as far as
 * their textures show it, poses by how far the animations move the vertices.
 */
export function costAttributesOf(
  document: Document,
  { body, weld, attributes, diagonal }: Pick<PreparedBody, 'body' | 'weld' | 'attributes' | 'diagonal'>,
): CostAttributes | null {
  const {
    charts: { wedges },
    wedgeCount,
  } = attributes;
  if (wedges.length === 0) return null;
  const entries = entriesOf(document, body, weld);
  const texture = gather(entries, wedges, wedgeCount, 'TEXCOORD_0');
  const colour = gather(entries, wedges, wedgeCount, 'COLOR_0');
  const shown = [
    ...(texture ? [{ ...texture, scale: textureScale(weld.mesh, wedges, texture.values) / diagonal }] : []),
    ...(colour ? [{ ...colour, scale: COLOUR_LENGTH }] : []),
  ];
  const room = MAX_COST_DIMENSIONS - sum(shown.map(({ size }) => size));
  const poses = room < 3 ? null : posesOf(document, body, weld, Math.floor(room / 3));
  const parts = poses ? [...shown, { ...perWedge(poses, weld.mesh, wedges), scale: 1 / diagonal }] : shown;
  if (parts.length === 0) return null;
  const dimension = sum(parts.map(({ size }) => size));
  const values = new Float32Array(dimension * wedgeCount);
  let first = 0;
  for (const part of parts) {
    for (let wedge = 0; wedge < wedgeCount; ++wedge)
      for (let d = 0; d < part.size; ++d)
        values[dimension * wedge + first + d] = part.scale * part.values[part.size * wedge + d];
    first += part.size;
  }
  const looked =
    texture?.size === 2
      ? textureWeights(
          entries,
          { document, mesh: weld.mesh, wedges, uv: texture.values },
          COLOUR_LENGTH * diagonal,
        )
      : null;
  return {
    values,
    dimension,
    displacementFields: poses?.animated ?? 0,
    textureWeights: looked ?? new Float32Array(),
  };
}

/** Values of vertices as those of their wedges. */
function perWedge({ values, size }: Poses, { triangles }: TriangleMesh, wedges: Uint32Array) {
  const spread = new Float32Array(size * (wedges.reduce((most, wedge) => Math.max(most, wedge), 0) + 1));
  wedges.forEach((wedge, corner) => {
    for (let d = 0; d < size; ++d) spread[size * wedge + d] = values[size * triangles[corner] + d];
  });
  return { values: spread, size };
}

/** An attribute's values per wedge, 0 where a primitive lacks it; null where all primitives lack it. */
function gather(
  { primitives, first, ofCorner, spanOfTriangle }: Entries,
  wedges: Uint32Array,
  wedgeCount: number,
  semantic: string,
) {
  const accessors = primitives.map((primitive) => primitive.getAttribute(semantic));
  const size = Math.max(0, ...accessors.map((accessor) => accessor?.getElementSize() ?? 0));
  if (size === 0) return null;
  const values = new Float32Array(size * wedgeCount);
  const element: number[] = [];
  wedges.forEach((wedge, corner) => {
    const span = spanOfTriangle[Math.floor(corner / 3)];
    accessors[span]?.getElement(ofCorner[corner] - first[span], element).forEach((value, d) => {
      if (d < size) values[size * wedge + d] = value;
    });
  });
  return { values, size };
}

/** The length on the surface of one unit of UV, as a mean over the area; 0 where the UVs enclose no area. */
function textureScale({ positions, triangles }: TriangleMesh, wedges: Uint32Array, uv: Float32Array): number {
  let [surface, texture] = [0, 0];
  for (let t = 0; t < triangles.length; t += 3) {
    const edge = (k: number, axis: number) =>
      positions[3 * triangles[t + k] + axis] - positions[3 * triangles[t] + axis];
    const part = (u: number, v: number) => edge(1, u) * edge(2, v) - edge(1, v) * edge(2, u);
    surface += length3(part(1, 2), part(2, 0), part(0, 1));
    const across = (k: number, axis: number) => uv[2 * wedges[t + k] + axis] - uv[2 * wedges[t] + axis];
    texture += Math.abs(across(1, 0) * across(2, 1) - across(1, 1) * across(2, 0));
  }
  return texture > 0 ? Math.sqrt(surface / texture) : 0;
}
