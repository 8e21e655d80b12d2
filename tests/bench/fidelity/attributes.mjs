// Measures how far our methods shift texture coordinates, on meshes that have them, with the product's own pipeline.

import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { shared } from './meshes.mjs';
import { meanOf } from './targets.mjs';

const TEXTURED = [
  { name: 'spot', file: 'gltf/derived_spot.glb' },
  { name: 'fox', file: 'gltf/Fox.glb' },
];

/** A point with a larger error, in % of the diagonal, is on the wrong side of a seam. */
const ACROSS_A_SEAM = 5;

/**
 * One result: { mesh, method, ratio, median, mean, acrossSeams }. Errors are lengths on the surface in % of the diagonal;
 * `mean` is that of points on the right side of every seam, and acrossSeams is the share of the others in %.
 */
export async function attributeErrors({ engine, core }, { methods, ratios, missing }) {
  const found = [];
  for (const { name, file } of TEXTURED) {
    if (!existsSync(join(shared, file))) {
      missing.push(`mesh ${file} of ../shared/meshes`);
      continue;
    }
    const bytes = new Uint8Array(readFileSync(join(shared, file)));
    const { bodies, document } = await engine.openModel([{ name: file, bytes }]);
    const prepared = engine.prepareBody(core, bodies[0], engine.defaultSettings(), document);
    for (const ratio of ratios)
      for (const { name: method, settings } of methods) {
        const targetFaces = (ratio * prepared.mesh.triangles.length) / 3;
        const { result } = engine.optimizeBody(core, prepared, settings, { targetFaces, document });
        found.push({ mesh: name, method, ratio, ...errorOf({ engine, core }, document, prepared, result) });
      }
  }
  return found;
}

/**
 * Per vertex of the original: the difference between its texture coordinates and those of the result at the point that it
 * is bound to. At a seam the nearest of the vertex's coordinates counts, because the point is on one side of the seam.
 */
function errorOf({ engine, core }, document, prepared, result) {
  const { mesh, attributes } = prepared;
  const { wedges } = attributes.charts;
  // These are already lengths on the surface relative to the diagonal.
  const { values } = engine.costAttributesOf(document, prepared);
  const ofCorner = cornerValues(core.sourceOfCorners(mesh, attributes.charts, result), wedges, values);
  const binding = core.bindToResult(mesh, result);
  const errors = new Float64Array(mesh.positions.length / 3).fill(Infinity);
  mesh.triangles.forEach((vertex, corner) => {
    const [u, v] = mixed(ofCorner, 3 * binding.triangle[vertex], binding.barycentric, 3 * vertex);
    const [u0, v0] = values.subarray(2 * wedges[corner], 2 * wedges[corner] + 2);
    errors[vertex] = Math.min(errors[vertex], Math.hypot(u - u0, v - v0));
  });
  const percent = errors.map((error) => 100 * error).sort();
  const near = percent.filter((error) => error <= ACROSS_A_SEAM);
  return {
    median: percent[Math.floor(percent.length / 2)],
    mean: meanOf([...near]),
    acrossSeams: 100 * (1 - near.length / percent.length),
  };
}

/** Two numbers per corner of the result, interpolated from the wedges of its source triangle of the original. */
function cornerValues({ triangle, barycentric }, wedges, values) {
  const mixedValues = new Float32Array(2 * triangle.length);
  triangle.forEach((t, corner) => {
    for (let k = 0; k < 3; k++)
      for (let d = 0; d < 2; d++)
        mixedValues[2 * corner + d] += barycentric[3 * corner + k] * values[2 * wedges[3 * t + k] + d];
  });
  return mixedValues;
}

/** Interpolates two numbers of the corners first, first + 1 and first + 2 with the three weights from `place` on. */
function mixed(ofCorner, first, weights, place) {
  return [0, 1].map((d) =>
    [0, 1, 2].reduce((sum, k) => sum + weights[place + k] * ofCorner[2 * (first + k) + d], 0),
  );
}
