// What the evaluation uses of the engine, as one entry for its bundle; and the samples, from where they are made.

export { samples } from '../../../scripts/samples/samples';
export { costAttributesOf } from '../../../web/engine/body/attributes';
export { openModel } from '../../../web/engine/document/open';
export { loadCore } from '../../../web/engine/core/load_core';
export { optimizeBody } from '../../../web/engine/stages/optimize';
export { OPTIONS, checkSettings, defaultSettings } from '../../../web/engine/settings/options';
export { findPins } from '../../../web/engine/body/pins';
export { STEP_SECONDS, simulationOptions } from '../../../web/engine/motion/simulation';
export { closestPoint, positionOf } from '../../../web/engine/motion/twin_points';
export {
  findGuidance,
  findModes,
  materialOf,
  measureResult,
  prepareBody,
} from '../../../web/engine/stages/pipeline';
