/** The mirror symmetry of a body: finding it, and the cuts of quads that stand in its way. */

import { inBody } from './attributes';
import type { Core, MirrorImages } from '../core/core';
import { counted } from '../core/words';
import type { Settings } from '../settings/options';
import type { PreparedBody } from '../stages/pipeline';

type RequestedSymmetry = Exclude<Settings['symmetry'], 'off'>;

/** One sentence on why there is no such symmetry. */
export function describeLack(
  { body }: PreparedBody,
  symmetry: Settings['symmetry'],
  images: MirrorImages,
): string {
  const across = symmetry === 'on' ? '' : ` across ${symmetry}`;
  const { asymmetricVertices, asymmetricTriangles } = images;
  const asymmetry =
    asymmetricVertices > 0
      ? `${counted(asymmetricVertices, 'vertex', 'vertices')} would have no image`
      : `its vertices have images, but ${counted(asymmetricTriangles, 'triangle')} would have none`;
  return `"${body.name}" has no mirror symmetry${across} to keep: ${asymmetry}${symmetry === 'on' ? ' at best' : ''}`;
}

/**
 * The body with its mirror images; with quads cut the other way on one side where that makes it symmetric, as files often have
 * quads of both sides cut one way. Vertices keep their numbers. A note tells of it.
 */
export function withMirror(core: Core, prepared: PreparedBody, symmetry: RequestedSymmetry): PreparedBody {
  const axis = ['x', 'y', 'z'].indexOf(symmetry);
  const images = core.findMirrorImages(prepared.mesh, prepared.attributes.charts, axis);
  return images.corners.length === 0
    ? { ...prepared, images }
    : recutBy(core, { ...prepared, images }, images.corners);
}

function recutBy(core: Core, prepared: PreparedBody, corners: Uint32Array): PreparedBody {
  const { body, weld, attributes } = prepared;
  const mesh = { ...prepared.mesh, triangles: corners.map((from) => prepared.mesh.triangles[from]) };
  const wedges = attributes.charts.wedges;
  const charts = {
    ...attributes.charts,
    wedges: wedges.length > 0 ? corners.map((from) => wedges[from]) : wedges,
  };
  const placeOf = inBody(body, weld);
  const indices = body.indices.slice();
  const recut = new Uint8Array(indices.length / 3);
  corners.forEach((from, corner) => {
    const place = placeOf(corner);
    indices[place] = body.indices[placeOf(from)];
    if (from !== corner) recut[Math.floor(place / 3)] = 1;
  });
  const quads = recut.reduce((sum, one) => sum + one, 0) / 2;
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
