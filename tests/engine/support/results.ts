/** Bodies as results of themselves. */

import { ownSources } from '../../../web/engine/body/attributes';
import type { ExportedBody } from '../../../web/engine/document/export';
import type { Body } from '../../../web/engine/document/open';

/** The body as a result that has all of its faces. */
export function asResult(body: Body): ExportedBody {
  const { positions, indices } = body;
  const mesh = { positions, triangles: indices };
  const inputOfTriangle = Uint32Array.from({ length: indices.length / 3 }, (_, t) => t);
  return { body, mesh, inputOfTriangle, sources: ownSources(mesh), hardCosine: null };
}
