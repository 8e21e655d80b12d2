/** The names of the ends of the shown body, as oriented in its scene. */

import { computed } from '@preact/signals';
import { boundsOf, longestAxis } from '../../engine/core/mesh';
import { SCENE_ENDS, endNames, rotated, rotationOf } from '../../engine/motion/scene_rotation';
import type { EndNames } from '../../engine/motion/scene_rotation';
import { results, wants } from './store';

const shown = computed(() => {
  const { file, body } = results;
  const nodeMatrix = file.value?.bodies[wants.body.value]?.nodeMatrix;
  return nodeMatrix && body.value ? { nodeMatrix, positions: body.value.mesh.positions } : null;
});

/** The ends of the mesh's longest side, where it can be pinned; null without a body. */
export const pinEnds = computed<EndNames | null>(
  () => shown.value && endNames(shown.value.nodeMatrix, longestAxis(boundsOf(shown.value.positions))),
);

/** The ends of the longest side of the body in its scene, along which scenarios act, as subjects of sentences; null without a body. */
export const scenarioEnds = computed<EndNames | null>(() => {
  if (!shown.value) return null;
  const { nodeMatrix, positions } = shown.value;
  return SCENE_ENDS[longestAxis(boundsOf(rotated(positions, rotationOf(nodeMatrix))))];
});
