/** The gallery of modes: animated pictures, frequencies, and where along the body each mode strains it. */

import { useEffect, useRef } from 'preact/hooks';
import type { Mode } from '../../../engine/core/core';
import { leadingMode } from '../../../engine/core/mode_set';
import { areModesStale, results, shownOverview, status, view, wants } from '../../state/store';
import { STRIP } from '../../worker/protocol';
import type { ModesResult, StrainOverview } from '../../worker/protocol';
import { colourAt } from '../../viewer/colours';
import { standingRotation } from '../../viewer/stand';
import { THUMBNAIL, Thumbnails } from '../../viewer/picture/thumbnails';
import type { ShownMode } from '../../viewer/picture/thumbnails';
import { chooseMode, guidingModes } from './mode_choice';
import { ModeNotes } from './mode_notes';
import './gallery.css';
import { say, sayCounted } from '../../language/say';

const AXES = ['across, thin', 'across, wide', 'along'];

export function Gallery() {
  const modes = results.modes.value;
  const overview = shownOverview.value;
  const body = results.body.value;
  const list = useRef<HTMLUListElement>(null);
  const thumbnails = useRef<Thumbnails | null>(null);
  useEffect(() => {
    if (!modes || !overview || !body || !list.current) return;
    thumbnails.current ??= makeThumbnails();
    const canvases = [...list.current.querySelectorAll('canvas')];
    const nodeMatrix = results.file.value!.bodies[wants.body.value].nodeMatrix;
    const shown = { mesh: body.mesh, modes: ordinalModes(modes, overview), canvases };
    thumbnails.current?.show(shown, standingRotation(nodeMatrix));
  }, [modes, overview, body]);
  useEffect(() => {
    thumbnails.current?.move(view.playing.value);
  }, [view.playing.value, overview]);
  useEffect(() => () => thumbnails.current?.dispose(), []);
  if (!modes) {
    const isStopped = status.paused.value.includes('Finding modes');
    return <p class="empty">{isStopped ? say('Stopped.') : say('Finding modes ...')}</p>;
  }
  if (modes.modesPerComponent === 0)
    return <p class="empty">{say('No part can move: unpin some vertices.')}</p>;
  return (
    <>
      <ul class={areModesStale.value ? 'gallery stale' : 'gallery'} ref={list} aria-label={say('Modes')}>
        {Array.from({ length: modes.modesPerComponent }, (_, ordinal) => (
          <ModeCard key={ordinal} ordinal={ordinal} modes={modes} />
        ))}
      </ul>
      <ModeNotes modes={modes} />
    </>
  );
}

function makeThumbnails(): Thumbnails | null {
  try {
    return new Thumbnails();
  } catch {
    return null; // without WebGL2 names and numbers are still useful
  }
}

function ordinalModes(modes: ModesResult, { ranks }: StrainOverview): ShownMode[] {
  const count = modes.modesPerComponent;
  const [size, faces] = [modes.shapes.length / count, ranks.length / count];
  return Array.from({ length: count }, (_, k) => ({
    shape: modes.shapes.subarray(k * size, (k + 1) * size),
    strain: ranks.subarray(k * faces, (k + 1) * faces),
  }));
}

function ModeCard({ ordinal, modes }: { ordinal: number; modes: ModesResult }) {
  const mode = leadingMode(modes, ordinal);
  const isChosen = guidingModes().includes(ordinal + 1);
  const words = describeMode(modes, ordinal);
  const strips = shownOverview.value?.strips;
  return (
    <li class="mode-card">
      <button
        type="button"
        class="mode"
        aria-pressed={isChosen}
        onClick={(event) => chooseMode(ordinal + 1, event.shiftKey || event.metaKey || event.ctrlKey)}
      >
        <canvas width={2 * THUMBNAIL.width} height={2 * THUMBNAIL.height} aria-hidden="true" />
        <span
          class="strip"
          aria-hidden="true"
          style={strips && { background: stripGradient(strips, ordinal) }}
        />
        <span class="caption">
          <span>
            <span class="spoken">{say('Mode')} </span>
            {ordinal + 1} {say(mode?.name ?? '')}
          </span>
          {mode && <Frequency modes={modes} mode={mode} />}
        </span>
        {words && <span class="caption muted">{words}</span>}
      </button>
      <GuidesToggle number={ordinal + 1} isChosen={isChosen} />
    </li>
  );
}

/** The direction of the mode, and on how many parts it appears. */
function describeMode(modes: ModesResult, ordinal: number): string {
  const axis = leadingMode(modes, ordinal)?.axis ?? -1;
  const parts = modes.modes.filter((one) => one.ordinal === ordinal).length;
  return [
    axis >= 0 ? say(AXES[axis]) : '',
    parts > 1 ? sayCounted(parts, '{count} part', '{count} parts') : '',
  ]
    .filter(Boolean)
    .join(', ');
}

function GuidesToggle({ number, isChosen }: { number: number; isChosen: boolean }) {
  return (
    <input
      type="checkbox"
      class="guides"
      aria-label={say('Mode {number} guides', { number })}
      title={say('Blends this mode with the others that are ticked')}
      checked={isChosen}
      onChange={(event) => {
        chooseMode(number, true);
        // The last chosen mode stays chosen.
        event.currentTarget.checked = guidingModes().includes(number);
      }}
    />
  );
}

function Frequency({ modes, mode }: { modes: ModesResult; mode: Mode }) {
  const isNominal = modes.components[mode.component].model === 'laplacian';
  return (
    <span
      class="muted"
      title={
        isNominal
          ? say('A Laplacian has no physical frequencies; only their ratios are meaningful')
          : undefined
      }
    >
      {(mode.omega / (2 * Math.PI)).toPrecision(3)} {isNominal ? say('nom.') : 'Hz'}
    </span>
  );
}

function stripGradient(strips: Float32Array, ordinal: number): string {
  const stops = Array.from({ length: STRIP }, (_, i) => colourAt('viridis', strips[ordinal * STRIP + i]));
  return `linear-gradient(to right, ${stops.join(', ')})`;
}
