/** One hint for each step on a first visit; a dismissed hint does not come back. */

import { signal } from '@preact/signals';
import { results, view } from '../../state/store';
import type { Step } from '../../state/store';
import './first_hint.css';
import { say } from '../../language/say';

const HINTS: Record<Step, string> = {
  model:
    'Drag to turn the model. The lists show what is in the file and what was repaired. Motion comes next.',
  motion:
    'These are the ways in which the model bends most easily. Click the one that looks like the motion you expect.',
  reduce:
    'Drag the big slider “Kept faces”: faces are removed first where motion does not show. Compare with V, blink with B.',
  test: 'Both meshes move under the same forces. Drag one to pull at it. Export is at the upper right.',
};
/** For touch screens, which have no keys. */
const TOUCH_HINTS: Partial<Record<Step, string>> = {
  reduce:
    'Drag the big slider “Kept faces”: faces are removed first where motion does not show. Blink shows the original and the result in turn.',
};
const STEPS = Object.keys(HINTS) as Step[];
const STORE = 'limber-hints';

/** The steps whose hints have been dismissed. */
const dismissed = signal<ReadonlySet<string>>(read());

/** A browser may refuse access to its storage; then every visit counts as the first one. */
function read(): Set<string> {
  try {
    return new Set((localStorage.getItem(STORE) ?? '').split(' '));
  } catch {
    return new Set();
  }
}

function dismiss(...steps: Step[]): void {
  dismissed.value = new Set([...dismissed.value, ...steps]);
  try {
    localStorage.setItem(STORE, [...dismissed.value].join(' ').trim());
  } catch {
    // see `read`
  }
}

/** The panel gets the focus of the button that disappears. */
function leave(event: Event, ...steps: Step[]): void {
  (event.currentTarget as HTMLElement).closest('aside')?.focus({ preventScroll: true });
  dismiss(...steps);
}

const hintOf = (step: Step): string =>
  (matchMedia('(pointer: coarse)').matches && TOUCH_HINTS[step]) || HINTS[step];

export function FirstHint() {
  const step = view.step.value;
  if (!results.file.value || dismissed.value.has(step)) return null;
  return (
    <section class="first-hint" aria-label={say('Hint')}>
      <p>
        <strong>{say('{number} of {all}.', { number: STEPS.indexOf(step) + 1, all: STEPS.length })}</strong>{' '}
        {say(hintOf(step))}
      </p>
      <div class="buttons">
        <button type="button" onClick={(event) => leave(event, step)}>
          {say('Got it')}
        </button>
        <button type="button" class="quiet" onClick={(event) => leave(event, ...STEPS)}>
          {say('No hints')}
        </button>
      </div>
    </section>
  );
}
