/** The levels at the sizes on the screen at which they change: a slider moves the model away. */

import { useEffect, useRef, useState } from 'preact/hooks';
import { levelsKey } from '../../state/export_request';
import { complain } from '../../state/running';
import { results } from '../../state/store';
import type { DrawnLevels } from '../../worker/protocol';
import { Range, Toggle } from '../../controls/controls';
import { count } from '../../controls/numbers';
import { levelAtHeight, switchHeights } from './level_chain';
import { LevelView } from './level_view';
import { say } from '../../language/say';

/** Heights on the screen, pixels: from a full common screen down to the smallest visible size. */
const TALLEST = 1080;
const SMALLEST = 8;
const STEPS = 200;
/** The first step at which the whole model is within the picture. */
const FIRST_STEP = 72;

/** Equal steps of the slider are equal factors of the height. */
const heightOf = (step: number): number => Math.round(TALLEST * (SMALLEST / TALLEST) ** (step / STEPS));

export function LevelPreview() {
  const { value: drawn } = results.drawnLevels;
  if (drawn?.key !== levelsKey()) return <p class="hint">{say('Writing the levels ...')}</p>;
  return <Preview drawn={drawn} key={drawn.key} />;
}

function Preview({ drawn: { levels } }: { drawn: DrawnLevels }) {
  const [step, setStep] = useState(FIRST_STEP);
  const [isLarge, setLarge] = useState(false);
  const height = heightOf(step);
  const heights = switchHeights(levels.slice(1).map(({ deviation }) => deviation));
  const number = levelAtHeight(heights, height);
  const canvas = useLevelView(levels, number, isLarge ? null : height);
  const faces = count(levels[number].faces);
  return (
    <>
      <figure class="level-preview">
        <canvas
          ref={canvas}
          role="img"
          aria-label={say('LOD{number}, {faces} faces, {height} pixels high', { number, faces, height })}
        />
        <figcaption>
          <strong>LOD{number}</strong> {say('{faces} faces', { faces })}
        </figcaption>
      </figure>
      <Range
        label="Distance"
        title="Moves the model away; the level changes where its error is one pixel"
        min={0}
        max={STEPS}
        step={1}
        value={step}
        shown={say('{pixels} px across', { pixels: count(height) })}
        onInput={setStep}
      />
      <Toggle
        label="Draw it large"
        title="Enlarges the level of this distance to the whole picture"
        checked={isLarge}
        onChange={setLarge}
      />
      <ol class="levels" aria-label={say('Where levels change')} start={0}>
        {levels.map((level, i) => (
          <li key={i} class={i === number ? 'is-shown' : undefined}>
            <button type="button" onClick={() => setStep(stepFor(heights, i))}>
              <strong>LOD{i}</strong> {say('{faces} faces', { faces: count(level.faces) })}
            </button>
            <span class="muted">{describeSwitch(heights, i)}</span>
          </li>
        ))}
      </ol>
    </>
  );
}

/** The first step at which a level is shown; for a level that is never shown, that of the next one. */
function stepFor(heights: readonly number[], level: number): number {
  if (level === 0) return 0;
  for (let step = 0; step <= STEPS; ++step) if (levelAtHeight(heights, heightOf(step)) >= level) return step;
  return STEPS;
}

function describeSwitch(heights: readonly number[], level: number): string {
  if (level === 0) return say('nearest');
  if (heights[level] !== undefined && heights[level] >= heights[level - 1])
    return say('never: the next level has the same error');
  return say('below {pixels} px', { pixels: count(Math.round(heights[level - 1])) });
}

/** Draws the requested level as soon as the levels are loaded. */
function useLevelView(levels: DrawnLevels['levels'], number: number, height: number | null) {
  const canvas = useRef<HTMLCanvasElement>(null);
  const view = useRef<LevelView | null>(null);
  const latest = useRef({ number, height });
  latest.current = { number, height };
  useEffect(() => {
    let isGone = false;
    try {
      view.current = new LevelView(canvas.current!);
    } catch {
      return; // names and numbers are still useful
    }
    const own = view.current;
    own
      .load(levels.map(({ bytes }) => bytes))
      .then(() => !isGone && own.draw(latest.current.number, latest.current.height))
      .catch((error: unknown) => complain(error));
    return () => {
      isGone = true;
      own.dispose();
    };
  }, [levels]);
  useEffect(() => view.current?.draw(number, height), [number, height]);
  return canvas;
}
