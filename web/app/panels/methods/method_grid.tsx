/** The original and each method's result from one viewpoint; dragging or the arrow keys rotate all of them. */

import { useEffect, useRef } from 'preact/hooks';
import type { TriangleMesh } from '../../../engine/core/core';
import { faceCount } from '../../../engine/core/mesh';
import { METHOD_TITLES } from '../../../engine/stages/equal_budget/budget_table';
import { COMPARED_METHODS } from '../../../engine/stages/equal_budget/equal_budget';
import type { ComparedMethod, MethodResult } from '../../../engine/stages/equal_budget/equal_budget';
import { count, fixed } from '../../controls/numbers';
import { viewportColours } from '../../state/scheme';
import { results as found, wants } from '../../state/store';
import { METHOD_PICTURE, MethodPictures } from '../../viewer/picture/method_pictures';
import { standingRotation } from '../../viewer/stand';
import { say } from '../../language/say';

/** Radians per pixel and per press of a key. */
const PER_PIXEL = 0.01;
const PER_PRESS = Math.PI / 24;
/** A pointer that has moved farther than this, in pixels, has rotated the view and does not click. */
const CLICK_PIXELS = 4;
const WIRE_STRENGTH = 0.45;

interface GridProps {
  original: TriangleMesh;
  results: readonly MethodResult[];
  onChoose(name: ComparedMethod): void;
}

export function MethodGrid({ original, results, onChoose }: GridProps) {
  const list = useRef<HTMLUListElement>(null);
  const pictures = usePictures();
  const rotate = (azimuth: number, polar: number) => pictures.current?.rotate(azimuth, polar);
  const drag = useDrag(rotate);
  useEffect(() => {
    const meshes = [original, ...results.map(({ mesh }) => mesh)];
    const canvases = [...list.current!.querySelectorAll('canvas')];
    meshes.forEach((mesh, i) => void pictures.current?.show(mesh, canvases[i]));
  }, [original, results]);
  return (
    <ul
      class="method-grid"
      ref={list}
      aria-label={say('Pictures of the methods')}
      onKeyDown={(event) => rotateByKey(event, rotate)}
      {...drag.handlers}
    >
      <li class="method-card">
        <Canvas />
        <span class="method-name">{say('Original')}</span>
        <span class="muted">{say('{faces} faces', { faces: count(faceCount(original)) })}</span>
      </li>
      {COMPARED_METHODS.map((name, i) => (
        <li key={name}>
          <button
            type="button"
            class="method-card"
            disabled={!results[i]}
            aria-pressed={wants.settings.value.method === name}
            onClick={({ detail }) => {
              // A key press also clicks, however far the pointer has moved before.
              if (detail === 0 || !drag.hasMoved()) onChoose(name);
            }}
          >
            <Canvas />
            <span class="method-name">{say(METHOD_TITLES[name])}</span>
            <span class="muted">{results[i] ? describe(results[i]) : say('waiting ...')}</span>
          </button>
        </li>
      ))}
    </ul>
  );
}

function Canvas() {
  const { width, height } = METHOD_PICTURE;
  return <canvas width={2 * width} height={2 * height} aria-hidden="true" />;
}

const describe = ({ faces, frequencyErrorMean }: MethodResult): string =>
  frequencyErrorMean === null
    ? say('{faces} faces', { faces: count(faces) })
    : say('{faces} faces, frequencies off by {error} %', {
        faces: count(faces),
        error: fixed(frequencyErrorMean, 1),
      });

/** One renderer for as long as the grid is shown; null without WebGL2, when the numbers are still useful. */
function usePictures() {
  const pictures = useRef<MethodPictures | null>(null);
  useEffect(() => {
    const { nodeMatrix } = found.file.value!.bodies[wants.body.value];
    try {
      pictures.current = new MethodPictures(standingRotation(nodeMatrix));
    } catch {
      return;
    }
    return () => pictures.current?.dispose();
  }, []);
  const { clay, wire } = viewportColours.value;
  useEffect(() => pictures.current?.look({ clay, wire, wireStrength: WIRE_STRENGTH }), [clay, wire]);
  return pictures;
}

type Rotate = (azimuth: number, polar: number) => void;

function rotateByKey(event: KeyboardEvent, rotate: Rotate): void {
  const rotations: Record<string, [number, number]> = {
    ArrowLeft: [-PER_PRESS, 0],
    ArrowRight: [PER_PRESS, 0],
    ArrowUp: [0, PER_PRESS],
    ArrowDown: [0, -PER_PRESS],
  };
  const rotation = rotations[event.key];
  if (!rotation) return;
  // Elsewhere the arrows step through the collapses.
  event.preventDefault();
  event.stopPropagation();
  rotate(...rotation);
}

/** Rotates the view while a pointer button is down. */
function useDrag(rotate: Rotate) {
  const last = useRef<{ x: number; y: number } | null>(null);
  const way = useRef(0);
  return {
    hasMoved: () => way.current > CLICK_PIXELS,
    handlers: {
      onPointerDown: ({ clientX: x, clientY: y }: PointerEvent) => {
        last.current = { x, y };
        way.current = 0;
      },
      onPointerMove: ({ clientX: x, clientY: y, buttons }: PointerEvent) => {
        const { current: from } = last;
        if (!from || buttons === 0) return;
        way.current += Math.abs(x - from.x) + Math.abs(y - from.y);
        rotate(-PER_PIXEL * (x - from.x), PER_PIXEL * (y - from.y));
        last.current = { x, y };
      },
      onPointerUp: () => (last.current = null),
    },
  };
}
