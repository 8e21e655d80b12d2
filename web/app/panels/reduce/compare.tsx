/** How original and optimized are compared: the choice of the view, and the divider of the slider view. */

import { isBrushing, results, shownMesh, view } from '../../state/store';
import type { Layout } from '../../state/store';
import type { PaneName } from '../../viewer/pane_layout';
import './compare.css';
import { say } from '../../language/say';

const LAYOUTS: { value: Layout; text: string; picture: string }[] = [
  { value: 'both', text: 'Side by side', picture: 'M2 3h5v10H2zM9 3h5v10H9z' },
  { value: 'slider', text: 'Slider', picture: 'M2 3h12v10H2zM8 1v14M4 8h2M10 8h2' },
  { value: 'original', text: 'Original alone', picture: 'M2 3h12v10H2zM5 6h6M5 10h6' },
  { value: 'optimized', text: 'Optimized alone', picture: 'M2 3h12v10H2zM5 10l3-4 3 4z' },
];

export const LAYOUT_NAMES = LAYOUTS.map(({ value }) => value);

const isCompared = (): boolean => view.step.value === 'reduce' && shownMesh.value !== null;
export const isSplit = (): boolean => isCompared() && view.layout.value === 'slider';

/** The panes that the viewport shows on the Reduce step. */
export function comparedPanes(): PaneName[] {
  const { value: layout } = view.layout;
  // The brush paints on the original.
  const isAlone = layout === 'original' || (layout === 'optimized' && !isBrushing.value);
  return isAlone ? [layout as PaneName] : ['original', 'optimized'];
}

/** The class of the pane labels, which leave the middle free for the choice of the view. */
export function labelsBesideChoice(): 'alone' | 'compared' | '' {
  if (!isCompared()) return '';
  return comparedPanes().length === 1 ? 'alone' : 'compared';
}

/** Switches between the two meshes at the same position. */
export function blink(): void {
  view.layout.value = view.layout.value === 'original' ? 'optimized' : 'original';
}

export function Compare() {
  if (!results.body.value || !isCompared()) return null;
  return (
    <>
      {isSplit() && <Divider />}
      <div class="compare">
        <div class="choice" role="group" aria-label={say('Compare')}>
          {LAYOUTS.map(({ value, text, picture }) => (
            <button
              key={value}
              type="button"
              aria-pressed={view.layout.value === value}
              aria-label={say(text)}
              title={`${say(text)} (V)`}
              onClick={() => (view.layout.value = value)}
            >
              <svg width="16" height="16" viewBox="0 0 16 16" aria-hidden="true">
                <path d={picture} fill="none" stroke="currentColor" stroke-width="1.3" />
              </svg>
            </button>
          ))}
        </div>
        <button
          type="button"
          class="blink"
          title={say('From one mesh to the other in the same place (B)')}
          onClick={blink}
        >
          {say('Blink')}
        </button>
      </div>
    </>
  );
}

/** A native slider over the whole viewport; only its thumb receives pointer events. */
function Divider() {
  const share = view.split.value;
  return (
    <>
      <span class="divider-line" style={{ left: `${100 * share}%` }} />
      <input
        type="range"
        class="divider"
        aria-label={say('Divider between original and optimized')}
        min={0}
        max={1}
        step={0.01}
        value={share}
        aria-valuetext={say('{share} % original', { share: Math.round(100 * share) })}
        onInput={(event) => (view.split.value = event.currentTarget.valueAsNumber)}
      />
    </>
  );
}
