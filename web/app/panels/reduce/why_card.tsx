/** The card that explains why a vertex of the optimized mesh has been kept. */

import { untracked, useSignalEffect } from '@preact/signals';
import { useId } from 'preact/hooks';
import { isBrushing, shownMesh, shownWhy, view, wantedFaces } from '../../state/store';
import type { Viewport } from '../../viewer/viewport';
import { comparedPanes } from './compare';
import { count, fixed } from '../../controls/numbers';
import { explain } from '../../../engine/report/explanation';
import './why_card.css';
import { Spoken } from '../../controls/spoken';
import { say, sentence } from '../../language/say';

/** The largest distance between the pointer and a hovered vertex. */
const HOVER_PIXELS = 14;
/** A press that moves less than this is a click. */
const CLICK_PIXELS = 4;
const CARD = { width: 264, height: 190, gap: 18 };

const isAsking = (): boolean =>
  view.step.value === 'reduce' && !isBrushing.value && comparedPanes().includes('optimized');

/** Hovering over a vertex opens its card; a click keeps the card open. */
export function connectHover(canvas: HTMLCanvasElement, getViewport: () => Viewport | null): void {
  const at = ({ clientX: x, clientY: y }: PointerEvent) =>
    isAsking() ? (getViewport()?.vertexAt('optimized', { x, y }, HOVER_PIXELS) ?? null) : null;
  let pressed: PointerEvent | null = null;
  canvas.addEventListener('pointermove', (event) => {
    if (event.buttons !== 0 || view.hover.value?.stays || !isAsking()) return;
    const vertex = at(event);
    if (vertex !== (view.hover.value?.vertex ?? null))
      view.hover.value = vertex === null ? null : { vertex, stays: false };
  });
  canvas.addEventListener('pointerleave', () => {
    if (!view.hover.value?.stays) view.hover.value = null;
  });
  canvas.addEventListener('pointerdown', (event) => (pressed = event));
  canvas.addEventListener('pointerup', (event) => {
    if (!pressed || !isAsking() || event.button !== 0) return;
    if (Math.hypot(event.clientX - pressed.clientX, event.clientY - pressed.clientY) > CLICK_PIXELS) return;
    const vertex = at(event);
    view.hover.value = vertex === null ? null : { vertex, stays: true };
  });
}

const shownVertices = (): number => (shownMesh.value?.mesh.positions.length ?? 0) / 3;

/** The vertex whose card is shown; null if the shown result has no such vertex. */
const hovered = (): number | null => {
  const vertex = view.hover.value?.vertex ?? null;
  return vertex !== null && isAsking() && vertex < shownVertices() ? vertex : null;
};

export function WhyCard({ getViewport }: { getViewport: () => Viewport | null }) {
  useSignalEffect(() => {
    const marked = hovered();
    getViewport()?.mark('optimized', marked);
  });
  // Another number of faces has other vertices.
  useSignalEffect(() => {
    if (wantedFaces.value > 0) untracked(() => (view.hover.value = null));
  });
  const vertex = hovered();
  const point = vertex === null ? null : (getViewport()?.screenPointOf('optimized', vertex) ?? null);
  return (
    <div class="why-area">
      <Spoken text={spokenReason(vertex)} />
      {vertex !== null && (
        <div class="why" style={point ? cardStyle(point) : undefined}>
          <Reasons vertex={vertex} />
        </div>
      )}
    </div>
  );
}

/** The text for screen readers once the pointer rests on a vertex; '' before its reasons are known. */
function spokenReason(vertex: number | null): string {
  const why = shownWhy.value;
  if (vertex === null || !why || vertex >= why.verdict.length) return '';
  const { sentence: verdict } = explain(why, vertex);
  return `${say('Vertex {number}', { number: count(vertex) })}. ${sentence(verdict)}`;
}

/** Places the card next to the vertex, on the right side if it fits there. */
function cardStyle({ x, y }: { x: number; y: number }) {
  const viewport = document.querySelector('.viewport')!;
  const isRight = x + CARD.gap + CARD.width < viewport.clientWidth;
  const left = isRight ? x + CARD.gap : Math.max(8, x - CARD.gap - CARD.width);
  const { offsetTop } = viewport.querySelector('canvas')!;
  const beside = offsetTop + y - CARD.height / 2;
  const top = Math.min(Math.max(8, beside), viewport.clientHeight - CARD.height - 8);
  return { left: `${left}px`, top: `${top}px` };
}

function Reasons({ vertex }: { vertex: number }) {
  const why = shownWhy.value;
  const { stays } = view.hover.value!;
  if (!why || vertex >= why.verdict.length)
    return <p class="muted">{say('Vertex {number} ...', { number: count(vertex) })}</p>;
  const { sentence: verdict, reasons, keep } = explain(why, vertex);
  return (
    <>
      <div class="why-head">
        <strong>{say('Vertex {number}', { number: count(vertex) })}</strong>
        {stays && (
          <button
            type="button"
            class="quiet"
            aria-label={say('Close the card of the vertex')}
            onClick={() => (view.hover.value = null)}
          >
            {say('Close')}
          </button>
        )}
      </div>
      <p>{sentence(verdict)}</p>
      <ul>
        {reasons.map(({ text, share }) => (
          <li key={text}>
            <span>{say(text)}</span>
            <span class="muted">{Math.round(100 * share)} %</span>
            <span class="share" style={{ width: `${100 * share}%` }} />
          </li>
        ))}
      </ul>
      {keep > 1 && (
        <p class="muted">
          {say('Painted or marked to be kept: all of this counts {times} times.', { times: fixed(keep, 0) })}
        </p>
      )}
    </>
  );
}

/** The same by keyboard: opens the card of any vertex by its number. */
export function AskVertex() {
  const id = useId();
  const last = shownVertices() - 1;
  if (last < 0) return null;
  const ask = (vertex: number) => {
    if (Number.isFinite(vertex))
      view.hover.value = { vertex: Math.min(last, Math.max(0, Math.round(vertex))), stays: true };
  };
  return (
    <div
      class="control"
      title={say('Of the optimized mesh, 0 to {last}; or hover over it in the view', { last: count(last) })}
    >
      <label for={id}>{say('Why is vertex ... kept')}</label>
      <input
        id={id}
        type="number"
        min={0}
        max={last}
        value={view.hover.value?.vertex ?? ''}
        onInput={(event) => ask(event.currentTarget.valueAsNumber)}
      />
    </div>
  );
}
