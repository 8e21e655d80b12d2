/** The mirror symmetry of a body: finding it, and recutting the quads that would prevent it. */

import { cornerInBody } from './attributes';
import type { Core, MirrorImages } from '../core/core';
import { sum } from '../core/mesh';
import { counted } from '../core/words';
import type { Settings } from '../settings/options';
import type { PreparedBody } from './prepared_body';

type RequestedSymmetry = Exclude<Settings['symmetry'], 'off'>;

/** One sentence on why the body does not have the symmetry. */
export function explainMissingSymmetry(
  { body }: PreparedBody,
  symmetry: Settings['symmetry'],
  images: MirrorImages,
): string {
  const across = symmetry === 'on' ? '' : ` across ${symmetry}`;
  const { asymmetricVertices, asymmetricTriangles } = images;
  const missing =
    asymmetricVertices > 0
      ? `${counted(asymmetricVertices, 'vertex', 'vertices')} would have no image`
      : `its vertices have images, but ${counted(asymmetricTriangles, 'triangle')} would have none`;
  return `"${body.name}" has no mirror symmetry${across} to keep: ${missing}${symmetry === 'on' ? ' at best' : ''}`;
}

/**
 * The body with its mirror images. Files often have the quads of both sides cut the same way; where that alone prevents the
 * symmetry, quads of one side are cut the other way, and a note says so. Vertices keep their numbers.
 */
export function withMirror(core: Core, prepared: PreparedBody, symmetry: RequestedSymmetry): PreparedBody {
  const axis = ['x', 'y', 'z'].indexOf(symmetry);
  const images = core.findMirrorImages(prepared.mesh, prepared.attributes.charts, axis);
  return images.corners.length === 0
    ? { ...prepared, images }
    : recutBy(core, { ...prepared, images }, images.corners);
}

/** `corners[c]`: the corner of the prepared mesh that takes the position of corner c. */
function recutBy(core: Core, prepared: PreparedBody, corners: Uint32Array): PreparedBody {
  const { body, weld, attributes } = prepared;
  const mesh = { ...prepared.mesh, triangles: corners.map((from) => prepared.mesh.triangles[from]) };
  const wedges = attributes.charts.wedges;
  const charts = {
    ...attributes.charts,
    wedges: wedges.length > 0 ? corners.map((from) => wedges[from]) : wedges,
  };
  const ofBody = cornerInBody(body, weld);
  const indices = body.indices.slice();
  const recut = new Uint8Array(indices.length / 3);
  corners.forEach((from, corner) => {
    const target = ofBody(corner);
    indices[target] = body.indices[ofBody(from)];
    if (from !== corner) recut[Math.floor(target / 3)] = 1;
  });
  const quads = sum([...recut]) / 2;
  const notes = [
    ...body.notes,
    `${counted(quads, 'quad')} cut the other way, so that both sides are mirror images`,
  ];
  return {
    ...prepared,
    body: { ...body, indices, recut, notes },
    weld: { ...weld, mesh },
    mesh,
    quality: core.measureQuality(mesh),
    attributes: { ...attributes, charts },
  };
}
