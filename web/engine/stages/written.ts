/** Stage: the result of the body as the exporter takes it. */

import { ownSources, sourcesInBody } from '../body/attributes';
import { withLayers } from '../body/layers';
import type { Layered, Layers } from '../body/layers';
import type { PreparedBody } from '../body/prepared_body';
import type { Core, CornerSources, Curvature, MeshAt, StrainGuidance, TriangleMesh } from '../core/core';
import { vertexCount } from '../core/mesh';
import type { ExportedBody } from '../document/export';
import { exportedSettings } from '../report/settings_file';
import { fittedStage } from './fitted';
import { curvatureStage, guidingStrain } from './guidance';
import { calibrationStage } from './measured';
import { preparedStage } from './prepared';
import { declareStage, where } from './stage';
import { tunedStage } from './tuned';

/** Fields of the original that are written with a result; without guidance the strain is written as 0. */
export interface WrittenFields {
  guidance: StrainGuidance | null;
  curvature: Curvature;
}

const fieldsStage = declareStage({
  name: 'fields',
  reads: [],
  needs: { guidance: guidingStrain, curvature: curvatureStage },
  run: (_context, fields): WrittenFields => fields,
});

export const writtenFields = where(fieldsStage, ['fields'], ({ fields }) => fields);

const writtenCalibration = where(calibrationStage, ['calibrate'], ({ calibrate }) => calibrate);

export const writtenStage = declareStage({
  name: 'written',
  reads: [],
  needs: {
    prepared: preparedStage,
    fitted: fittedStage,
    fields: writtenFields,
    calibration: writtenCalibration,
    tuned: tunedStage,
  },
  run: ({ core }, { prepared, fitted, fields, calibration, tuned }): ExportedBody => ({
    ...exportedBody(core, prepared, fitted.result, fields),
    ...(calibration === null ? {} : { calibration }),
    ...(tuned === null ? {} : { settings: exportedSettings(tuned) }),
  }),
});

/** Fields go from triangles to vertices as means over the faces of the original; null: none are written. */
export function exportedBody(
  core: Core,
  prepared: PreparedBody,
  result: MeshAt,
  fields: WrittenFields | null,
): ExportedBody {
  const { body, attributes, layers } = prepared;
  const { hardCosine, charts, isBare } = attributes;
  const ofResult =
    isBare && layers.isPlain
      ? { ...meshInBody(prepared, result), sources: null }
      : inBody(prepared, result, core.sourceOfCorners(prepared.mesh, charts, result), layers);
  const exported = { body, ...ofResult, hardCosine };
  if (!fields) return exported;
  const strain = meanOverTriangles(prepared.mesh, fields.guidance?.rank);
  const atVertices = (field: Float32Array) =>
    Float32Array.from(result.inputOfVertex, (vertex) => field[vertex]);
  return {
    ...exported,
    fields: { strain: atVertices(strain), curvature: atVertices(fields.curvature.vertex) },
  };
}

/** The result in terms of the body: all layers of it, wound as they are in the file. */
function inBody(prepared: PreparedBody, result: MeshAt, sources: CornerSources, layers: Layers): Layered {
  const { body, weld } = prepared;
  if (!layers.isPlain) return withLayers(layers, body, result, sources);
  return { ...meshInBody(prepared, result), sources: sourcesInBody(body, weld, sources) };
}

/** A result that has one layer, in terms of the body. */
function meshInBody({ weld }: PreparedBody, { mesh, inputOfTriangle }: MeshAt) {
  return { mesh, inputOfTriangle: inputOfTriangle.map((triangle) => weld.sourceOfTriangle[triangle]) };
}

/** The welded body without any change. */
export function exportedMesh({ body, mesh, weld, attributes }: PreparedBody): ExportedBody {
  const sources = sourcesInBody(body, weld, ownSources(mesh));
  return { body, mesh, inputOfTriangle: weld.sourceOfTriangle, sources, hardCosine: attributes.hardCosine };
}

/** Per vertex the mean of the field over the triangles around it; 0 without a field. */
function meanOverTriangles(mesh: TriangleMesh, field?: Float32Array): Float32Array {
  const sums = new Float64Array(vertexCount(mesh));
  const counts = new Uint32Array(sums.length);
  if (field)
    mesh.triangles.forEach((vertex, corner) => {
      sums[vertex] += field[Math.floor(corner / 3)];
      counts[vertex] += 1;
    });
  return Float32Array.from(sums, (total, vertex) => (counts[vertex] > 0 ? total / counts[vertex] : 0));
}
