// The entry of the evaluation's bundle: the parts of the engine that it uses, and the generators of the samples.

import type { Document } from '@gltf-transform/core';
import type { PreparedBody } from '../../../web/engine/body/prepared_body';
import type { Core } from '../../../web/engine/core/core';
import { sourcesOfVertices } from '../../../web/engine/settings/pin_edits';
import type { Settings } from '../../../web/engine/settings/options';
import { BodyRun } from '../../../web/engine/stages/body_run';
import { STAGES } from '../../../web/engine/stages/stages';

export { samples } from '../../../scripts/samples/samples';
export { costAttributesOf } from '../../../web/engine/body/cost_attributes';
export { materialOf } from '../../../web/engine/body/material';
export { findPins } from '../../../web/engine/body/pins';
export { loadCore } from '../../../web/engine/core/load_core';
export { openModel } from '../../../web/engine/document/open';
export { STEP_SECONDS, simulationOptions } from '../../../web/engine/motion/simulation';
export { positionOf } from '../../../web/engine/motion/twin_points';
export { OPTIONS, checkSettings, defaultSettings } from '../../../web/engine/settings/options';
export { measureResult } from '../../../web/engine/stages/measure';
export { tuneMesh, tuneSettings } from '../../../web/engine/stages/tune';
export { prepareBody } from '../../../web/engine/stages/prepared';

export interface Asked {
  targetFaces: number;
  /** vertices of the prepared mesh */
  pinned?: Uint32Array;
  /** the file of the body; without it the body has no attributes */
  document?: Document;
}

/** The result for a body, and the seconds from its modes to its fit. */
export function optimizeBody(
  core: Core,
  { body, weld }: PreparedBody,
  settings: Settings,
  { targetFaces, pinned, document }: Asked,
) {
  const run = new BodyRun({ core, body, document: document ?? null });
  const sources = sourcesOfVertices(weld.vertexOfSource);
  const pins = pinned?.length ? `vertices:${[...pinned].map((v) => sources.get(v)).join(',')}` : '';
  const own = { ...settings, pins, targetFaces };
  run.get(STAGES.pinned, own);
  const started = performance.now();
  const { result } = run.get(STAGES.fitted, own);
  return { result, seconds: (performance.now() - started) / 1000 };
}

/** The strain rank per triangle that guides the collapses. */
export function strainRank(core: Core, { body }: PreparedBody, settings: Settings): Float32Array {
  return new BodyRun({ core, body, document: null }).get(STAGES.guidance, settings).rank;
}
