/** Stage: a body welded, inspected and, where a symmetry is asked for, recut. */

import type { Document } from '@gltf-transform/core';
import { attributesOf, NO_ATTRIBUTES } from '../body/attributes';
import { findLayers } from '../body/layers';
import type { InspectedBody, PreparedBody } from '../body/prepared_body';
import { withMirror } from '../body/symmetry';
import type { Core, TriangleMesh } from '../core/core';
import { diagonalOf, faceCount } from '../core/mesh';
import type { Body } from '../document/model';
import type { Settings } from '../settings/options';
import { onceIn } from './many_bodies/value_cache';
import { declareStage } from './stage';

export const preparedStage = declareStage({
  name: 'prepared',
  reads: ['weld', 'symmetry'],
  needs: {},
  run: ({ core, body, document, guidedBodies = 1, cache }, _inputs, settings): PreparedBody => {
    const inspected = onceIn(cache, 'inspected', [body.positions, body.indices, settings.weld], () =>
      inspectBody(core, body, settings),
    );
    const prepared = prepareInspected(
      core,
      { ...inspected, body, document: document ?? undefined },
      settings,
    );
    return guidedBodies === 1
      ? prepared
      : { ...prepared, samples: samplesAmong(guidedBodies, prepared.mesh) };
  },
});

/** The fewest samples of a single body. */
const MIN_SAMPLES = 10_000;
const SAMPLES_OF_FACE = 10;
const MAX_SAMPLES = 500_000;

/** The number of samples of a body: at least by its faces; the bodies of a file share the minimum of a single one. */
const samplesAmong = (bodies: number, mesh: TriangleMesh): number =>
  Math.min(MAX_SAMPLES, Math.max(SAMPLES_OF_FACE * faceCount(mesh), Math.ceil(MIN_SAMPLES / bodies)));

/** Welds and measures a body, usable or not. */
export function inspectBody(
  core: Core,
  body: Body,
  { weld: tolerance }: Pick<Settings, 'weld'>,
): InspectedBody {
  const weld = core.weld(body.positions, body.indices, { tolerance });
  const quality = weld.mesh.triangles.length > 0 ? core.measureQuality(weld.mesh) : null;
  return { weld, inspection: core.inspect(weld.mesh), quality };
}

/**
 * Welds and inspects a body, and recuts quads where the symmetry that is asked for needs it. Throws an Error with one
 * sentence where the body has no usable face. `document`: where the body comes from; without it the body has no attributes.
 */
export function prepareBody(
  core: Core,
  body: Body,
  settings: Pick<Settings, 'weld' | 'symmetry'>,
  document?: Document,
): PreparedBody {
  return prepareInspected(core, { ...inspectBody(core, body, settings), body, document }, settings);
}

interface InspectedSource extends InspectedBody {
  body: Body;
  document?: Document;
}

function prepareInspected(
  core: Core,
  { weld, inspection, quality, body, document }: InspectedSource,
  settings: Pick<Settings, 'weld' | 'symmetry'>,
): PreparedBody {
  const { mesh } = weld;
  if (quality === null)
    throw new Error(
      `Body "${body.name}" has no usable face, ${weld.degenerateFaces} with a repeated vertex: repair it and export it again.`,
    );
  const diagonal = diagonalOf(mesh.positions);
  const layers = findLayers(body, weld);
  const attributes = document ? attributesOf(document, body, weld, layers) : NO_ATTRIBUTES;
  const prepared = {
    body,
    weld,
    mesh,
    diagonal,
    inspection,
    quality,
    attributes,
    layers,
    samples: 0,
  };
  return settings.symmetry === 'off' ? prepared : withMirror(core, prepared, settings.symmetry);
}
