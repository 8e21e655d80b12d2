/** The viewport in the page, with its overlays: labels, legend, cards and alerts. */

import { effect, useSignalEffect } from '@preact/signals';
import { useEffect, useRef, useState } from 'preact/hooks';
import { isBrushing, isPicking, results, view } from '../../state/store';
import { Viewport } from '../../viewer/viewport';
import { connectPicking, showPins } from '../motion/picking';
import { showPaint } from '../reduce/brushing';
import { PicturesButton } from '../pictures/pictures_button';
import { Compare } from '../reduce/compare';
import { connectHover, WhyCard } from '../reduce/why_card';
import { connectDragging } from '../simulate/simulate_drag';
import { showCollisionScene, showTwin } from '../simulate/simulate_view';
import { TwinAlert } from '../simulate/twin_alert';
import { Legend } from './legend';
import { PaneLabels } from './pane_labels';
import {
  showArrangement,
  showFields,
  showFiles,
  showLook,
  showOptimized,
  showOriginal,
  showShapes,
  showSwing,
} from './show_bodies';
import { connectViewportKeys } from './viewport_keys';
import './viewport.css';
import { say } from '../../language/say';

export const viewportHandle: { current: Viewport | null } = { current: null };

const getViewport = (): Viewport | null => viewportHandle.current;

/** Each effect depends on the signals that it reads; the order is that of the first drawing. */
const SHOWS = [
  showOriginal,
  showOptimized,
  showArrangement,
  showFields,
  showShapes,
  showLook,
  showFiles,
  showSwing,
  showPins,
  showPaint,
  showCollisionScene,
  showTwin,
] as const;

/** Throws if WebGL2 is missing. */
function openViewport(canvas: HTMLCanvasElement): void {
  const viewport = (viewportHandle.current = new Viewport(canvas));
  const picking = connectPicking(canvas, viewport);
  connectViewportKeys(canvas, viewport, picking);
  connectDragging(canvas, viewport);
  connectHover(canvas, getViewport);
  effect(() => {
    if (isBrushing.value || isPicking.value) picking.prepare();
  });
  for (const show of SHOWS) show(viewport);
  warmUpLater(viewport);
}

/** ms: the longest wait for idle time */
const LATEST_WARM_UP = 400;

/** Runs once the start screen has been painted and the page is idle: without a file to open there is time. */
function warmUpLater(viewport: Viewport): void {
  const begin = (): void => {
    // If the preparation fails, it happens at the first drawing.
    if (!results.file.value) void viewport.warmUp().catch(() => undefined);
  };
  if (!('requestIdleCallback' in globalThis)) return;
  new PerformanceObserver((entries, observer) => {
    if (entries.getEntriesByName('first-contentful-paint').length === 0) return;
    observer.disconnect();
    requestIdleCallback(begin, { timeout: LATEST_WARM_UP });
  }).observe({ type: 'paint', buffered: true });
}

export function ViewportView() {
  const canvas = useRef<HTMLCanvasElement>(null);
  const [hasFailed, setFailed] = useState(false);
  useEffect(() => {
    try {
      openViewport(canvas.current!);
    } catch {
      setFailed(true);
    }
  }, []);
  for (const show of SHOWS) useSignalEffect(() => show(viewportHandle.current));
  return (
    <div class={isPicking.value || isBrushing.value ? 'viewport picking' : 'viewport'}>
      <canvas
        ref={canvas}
        aria-label={describeViewport()}
        role="application"
        tabIndex={results.file.value ? 0 : -1}
        aria-hidden={results.file.value === null}
      />
      {isPicking.value && <span class="middle-mark" aria-hidden="true" />}
      {hasFailed && (
        <p class="empty">
          {say('This browser has no WebGL2, so there is no picture; files, numbers and export work.')}
        </p>
      )}
      {results.body.value && <PaneLabels />}
      <Compare />
      <WhyCard getViewport={getViewport} />
      <TwinAlert />
      <Legend />
      {results.body.value && !hasFailed && <PicturesButton />}
    </div>
  );
}

function describeViewport(): string {
  if (isBrushing.value)
    return say('The mesh at rest. Drag over either mesh to paint the original; Shift erases.');
  if (isPicking.value)
    return say('The mesh at rest. Click a vertex or drag over the surface to pin it; Shift unpins.');
  if (view.step.value === 'test')
    return say(
      'Both meshes in motion. Drag a body to pull at it, drag beside it to turn the view, scroll to zoom.',
    );
  return say('The mesh. Drag to turn the view, scroll to zoom, right-drag to move it.');
}
