/** The gallery of modes: moving pictures, frequency, and where along the body each one strains it. */

import { useEffect, useRef } from 'preact/hooks';
import { results, status, view } from '../state/store';
import { STRIP } from '../worker/protocol';
import type { ModesResult } from '../worker/protocol';
import { colourAt } from '../viewer/colours';
import { THUMBNAIL, Thumbnails } from '../viewer/thumbnails';
import { chooseMode, guidingModes, isNominal } from './motion_panel';
import { count } from './controls';

const AXES = ['across, thin', 'across, wide', 'along'];

export function Gallery() {
  const modes = results.modes.value;
  const body = results.body.value;
  const list = useRef<HTMLUListElement>(null);
  const thumbnails = useRef<Thumbnails | null>(null);
  useEffect(() => {
    if (!modes || !body || !list.current) return;
    thumbnails.current ??= makeThumbnails();
    const canvases = [...list.current.querySelectorAll('canvas')];
    thumbnails.current?.show(body.mesh, layerShapes(modes), canvases);
  }, [modes, body]);
  useEffect(() => {
    if (thumbnails.current) thumbnails.current.moving = view.playing.value;
  }, [view.playing.value, modes]);
  useEffect(() => () => thumbnails.current?.dispose(), []);
  if (!modes) return <p class="empty">{status.paused.value ? 'Stopped.' : 'Finding modes ...'}</p>;
  return (
    <ul class="gallery" ref={list} aria-label="Modes">
      {Array.from({ length: modes.layerCount }, (_, layer) => (
        <ModeCard key={layer} layer={layer} modes={modes} />
      ))}
    </ul>
  );
}

function makeThumbnails(): Thumbnails | null {
  try {
    return new Thumbnails();
  } catch {
    return null; // without WebGL2 the names and numbers still serve
  }
}

function layerShapes(modes: ModesResult): Float32Array[] {
  const size = modes.shapes.length / modes.layerCount;
  return Array.from({ length: modes.layerCount }, (_, k) => modes.shapes.subarray(k * size, (k + 1) * size));
}

function ModeCard({ layer, modes }: { layer: number; modes: ModesResult }) {
  const own = modes.modes.filter((mode) => mode.layer === layer);
  const isChosen = guidingModes().includes(layer + 1);
  const frequency = own.length > 0 ? own[0].omega / (2 * Math.PI) : 0;
  const nominal = isNominal();
  const axis = own[0]?.axis ?? -1;
  const words = [axis >= 0 ? AXES[axis] : '', own.length > 1 ? `${count(own.length)} parts` : '']
    .filter(Boolean)
    .join(', ');
  return (
    <li>
      <button
        type="button"
        class="mode"
        aria-pressed={isChosen}
        onClick={(event) => chooseMode(layer + 1, event.shiftKey || event.metaKey || event.ctrlKey)}
      >
        <canvas width={2 * THUMBNAIL.width} height={2 * THUMBNAIL.height} aria-hidden="true" />
        <span class="strip" aria-hidden="true" style={{ background: stripGradient(modes.strips, layer) }} />
        <span class="caption">
          <span>
            {layer + 1} {own[0]?.name ?? ''}
          </span>
          <span
            class="muted"
            title={
              nominal ? 'A Laplacian has no physical frequency; this one is in proportion only' : undefined
            }
          >
            {frequency.toPrecision(3)} {nominal ? 'nom.' : 'Hz'}
          </span>
        </span>
        {words && <span class="caption muted">{words}</span>}
      </button>
    </li>
  );
}

function stripGradient(strips: Float32Array, layer: number): string {
  const stops = Array.from({ length: STRIP }, (_, i) => colourAt('viridis', strips[layer * STRIP + i]));
  return `linear-gradient(to right, ${stops.join(', ')})`;
}
