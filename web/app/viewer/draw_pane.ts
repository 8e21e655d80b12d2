/** Draws one pane into its part of the canvas. */

import type * as THREE from 'three';
import type { Pane } from './pane';
import type { PaneRegion } from './pane_layout';

/** Draws a pane; an overlay is drawn on top of the existing picture. */
export function drawPane(
  renderer: THREE.WebGLRenderer,
  camera: THREE.Camera,
  pane: Pane,
  { picture, visible, isOverlay }: PaneRegion & { isOverlay: boolean },
): void {
  renderer.setViewport(...picture);
  renderer.setScissor(...visible);
  pane.dots.fit(picture[3]);
  // The body below must not hide an overlay.
  if (isOverlay) {
    renderer.clearDepth();
    pane.drawDepth(() => renderer.render(pane.scene, camera));
  }
  renderer.render(pane.scene, camera);
}
