/** Draws the stage at a different size, and restores its own size. */

import type { WebGLRenderer } from 'three';
import type { OrbitCamera } from '../camera/orbit_camera';
import type { Pane } from '../pane';
import type { PaneLayout, PaneName } from '../pane_layout';

export interface StageShot {
  /** pixels */
  width: number;
  height: number;
  /** pixels per CSS pixel: how large dots and the axes are */
  scale: number;
  /** whether the axes of the scene are drawn */
  hasAxes: boolean;
  /** rotation of the camera about the vertical axis, in radians; absent: 0 */
  angle?: number;
  /** that pass before the picture, for animations; absent: 0 */
  seconds?: number;
}

interface Stage {
  renderer: WebGLRenderer;
  layout: PaneLayout;
  orbit: OrbitCamera;
  panes: Record<PaneName, Pane>;
}

/** Pixels; the renderer drops fractions of pixels, including those from rounding errors in a product. */
const ROUNDING = 0.01;

/**
 * Calls `draw(false)` at the size of the picture, and then `draw(true)` at that of the stage. If the picture is
 * narrower, the horizontal range of the view is preserved. Throws if the graphics card cannot draw a picture of that
 * size.
 */
export function drawAtSize(stage: Stage, shot: StageShot, draw: (isLast: boolean) => void): void {
  const { renderer, layout, orbit, panes } = stage;
  const ratio = renderer.getPixelRatio();
  const own = layout.canvasSize;
  const setRatio = (value: number): void => {
    renderer.setPixelRatio(value);
    for (const pane of Object.values(panes)) pane.setPixelRatio(value);
  };
  const { scale, width, height } = shot;
  try {
    layout.pictureSize = { width: (width + ROUNDING) / scale, height: (height + ROUNDING) / scale };
    orbit.camera.zoom = Math.min(1, width / height / (own.width / own.height));
    setRatio(scale);
    orbit.turned(shot.angle ?? 0, () => draw(false));
    const { drawingBufferWidth, drawingBufferHeight } = renderer.getContext();
    if (drawingBufferWidth < Math.floor(width) || drawingBufferHeight < Math.floor(height))
      throw new Error(
        `The graphics card draws at most ${drawingBufferWidth} x ${drawingBufferHeight} pixels: choose a smaller picture.`,
      );
  } finally {
    layout.pictureSize = null;
    orbit.camera.zoom = 1;
    setRatio(ratio);
    draw(true);
  }
}
