/** The card that says why a vertex of the optimized mesh is still there. */

import { untracked, useSignalEffect } from '@preact/signals';
import { useId } from 'preact/hooks';
import { isBrushing, shownMesh, shownWhy, view, wantedFaces } from '../../state/store';
import type { Stage } from '../../viewer/stage';
import { comparedPanes } from './compare';
import { count, fixed } from '../controls';
import { explain } from '../../../engine/report/explanation';

/** How near the pointer has to come to a vertex. */
const REACH_PIXELS = 14;
/** A click moves less than this. */
const CLICK_PIXELS = 4;
const CARD = { width: 264, height: 190, gap: 18 };

const isAsking = (): boolean =>
  view.step.value === 'reduce' && !isBrushing.value && comparedPanes().includes('optimized');

/** Hovering asks about a vertex, a click keeps the answer. */
export function connectProbe(canvas: HTMLCanvasElement, getStage: () => Stage | null): void {
  const at = ({ clientX: x, clientY: y }: PointerEvent) =>
    isAsking() ? (getStage()?.vertexAt('optimized', { x, y }, REACH_PIXELS) ?? null) : null;
  let pressed: PointerEvent | null = null;
  canvas.addEventListener('pointermove', (event) => {
    if (event.buttons !== 0 || view.probe.value?.isHeld || !isAsking()) return;
    const vertex = at(event);
    if (vertex !== (view.probe.value?.vertex ?? null))
      view.probe.value = vertex === null ? null : { vertex, isHeld: false };
  });
  canvas.addEventListener('pointerleave', () => {
    if (!view.probe.value?.isHeld) view.probe.value = null;
  });
  canvas.addEventListener('pointerdown', (event) => (pressed = event));
  canvas.addEventListener('pointerup', (event) => {
    if (!pressed || !isAsking() || event.button !== 0) return;
    if (Math.hypot(event.clientX - pressed.clientX, event.clientY - pressed.clientY) > CLICK_PIXELS) return;
    const vertex = at(event);
    view.probe.value = vertex === null ? null : { vertex, isHeld: true };
  });
}

const shownVertices = (): number => (shownMesh.value?.mesh.positions.length ?? 0) / 3;

/** Whether there is a vertex to tell of: another result has others. */
const probed = (): number | null => {
  const vertex = view.probe.value?.vertex ?? null;
  return vertex !== null && isAsking() && vertex < shownVertices() ? vertex : null;
};

export function WhyCard({ getStage }: { getStage: () => Stage | null }) {
  useSignalEffect(() => {
    const marked = probed();
    getStage()?.mark('optimized', marked);
  });
  // Another number of faces has other vertices.
  useSignalEffect(() => {
    if (wantedFaces.value > 0) untracked(() => (view.probe.value = null));
  });
  const vertex = probed();
  const place = vertex === null ? null : (getStage()?.placeOf('optimized', vertex) ?? null);
  return (
    <div class="why-place" aria-live="polite">
      {vertex !== null && (
        <div class="why" style={place ? styleAt(place) : undefined}>
          <Reasons vertex={vertex} />
        </div>
      )}
    </div>
  );
}

/** Beside the vertex, on the side where there is room. */
function styleAt({ x, y }: { x: number; y: number }) {
  const stage = document.querySelector('.stage')!;
  const isRight = x + CARD.gap + CARD.width < stage.clientWidth;
  const left = isRight ? x + CARD.gap : Math.max(8, x - CARD.gap - CARD.width);
  const top = Math.min(Math.max(8, y - CARD.height / 2), stage.clientHeight - CARD.height - 8);
  return { left: `${left}px`, top: `${top}px` };
}

function Reasons({ vertex }: { vertex: number }) {
  const why = shownWhy.value;
  const { isHeld } = view.probe.value!;
  if (!why || vertex >= why.verdict.length) return <p class="muted">Vertex {count(vertex)} ...</p>;
  const { sentence, reasons, keep } = explain(why, vertex);
  return (
    <>
      <div class="why-head">
        <strong>Vertex {count(vertex)}</strong>
        {isHeld && (
          <button
            type="button"
            class="quiet"
            aria-label="Close the card of the vertex"
            onClick={() => (view.probe.value = null)}
          >
            Close
          </button>
        )}
      </div>
      <p>{sentence}</p>
      <ul>
        {reasons.map(({ text, share }) => (
          <li key={text}>
            <span>{text}</span>
            <span class="muted">{Math.round(100 * share)} %</span>
            <span class="share" style={{ width: `${100 * share}%` }} />
          </li>
        ))}
      </ul>
      {keep > 1 && <p class="muted">Painted or named to be kept: all of it counts {fixed(keep, 0)} times.</p>}
    </>
  );
}

/** The same for the keyboard: any vertex by its number. */
export function AskVertex() {
  const id = useId();
  const last = shownVertices() - 1;
  if (last < 0) return null;
  const ask = (vertex: number) => {
    if (Number.isFinite(vertex))
      view.probe.value = { vertex: Math.min(last, Math.max(0, Math.round(vertex))), isHeld: true };
  };
  return (
    <div class="control" title={`Of the optimized mesh, 0 to ${count(last)}; or hover it on the stage`}>
      <label for={id}>Why is vertex ... kept</label>
      <input
        id={id}
        type="number"
        min={0}
        max={last}
        value={view.probe.value?.vertex ?? ''}
        onInput={(event) => ask(event.currentTarget.valueAsNumber)}
      />
    </div>
  );
}
