// What the evaluation uses of the engine, as one entry for its bundle; and the samples, from where they are made.

export { samples } from '../../../scripts/samples/samples';
export { costAttributesOf } from '../../../web/engine/attributes';
export { openModel } from '../../../web/engine/document/open';
export { loadCore } from '../../../web/engine/load_core';
export { optimizeBody } from '../../../web/engine/optimize';
export { OPTIONS, checkSettings, defaultSettings } from '../../../web/engine/options';
export { findPins } from '../../../web/engine/pins';
export { STEP_SECONDS, simulationOptions } from '../../../web/engine/simulation';
export { closestPoint, placeOf } from '../../../web/engine/twin_points';
export {
  findGuidance,
  findModes,
  materialOf,
  measureResult,
  prepareBody,
} from '../../../web/engine/pipeline';
