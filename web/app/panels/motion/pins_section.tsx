/** What is held in place: the ends, vertices picked on the viewport, an attribute of the file, or a text. */

import { useId } from 'preact/hooks';
import { OPTIONS } from '../../../engine/settings/options';
import { hasPins, pinValue, withPins } from '../../../engine/settings/pin_edits';
import { setPins } from '../../state/pins';
import { isPicking, results, status, view, wants } from '../../state/store';
import { Section, Select } from '../../controls/controls';
import { count } from '../../controls/numbers';

/** Of the length of the body, in %: what "an end" is. */
const END = '6';

export function PinsSection() {
  const { pins } = wants.settings.value;
  return (
    <Section title="Held in place">
      <div class="buttons">
        <EndButton kind="low" text="Low end" />
        <EndButton kind="high" text="High end" />
        <button
          type="button"
          aria-pressed={isPicking.value}
          title="Click vertices or paint over the surface; Shift lets go, Escape leaves"
          onClick={() => (view.picking.value = !view.picking.value)}
        >
          Pick
        </button>
      </div>
      {isPicking.value && (
        <p class="hint">Click a vertex or paint over the surface. Shift lets go, Esc leaves.</p>
      )}
      <AttributeSelect />
      <div class="held">
        <p class="hint" role="status">
          {describePins()}
        </p>
        <button
          type="button"
          class="quiet"
          disabled={pins === ''}
          aria-label="Clear what is held"
          onClick={() => setPins('')}
        >
          Clear
        </button>
      </div>
      <PinsText />
    </Section>
  );
}

function EndButton({ kind, text }: { kind: 'low' | 'high'; text: string }) {
  const { pins } = wants.settings.value;
  const isHeld = hasPins(pins, kind);
  return (
    <button
      type="button"
      aria-pressed={isHeld}
      title={`Hold the ${kind === 'low' ? 'lowest' : 'highest'} ${END} % along the longest side`}
      onClick={() => setPins(withPins(pins, kind, isHeld ? '' : END))}
    >
      {text}
    </button>
  );
}

function AttributeSelect() {
  const names = results.body.value?.pinAttributes ?? [];
  const { pins } = wants.settings.value;
  if (names.length === 0) return null;
  return (
    <Select
      label="Attribute"
      title="Holds the vertices where the first component of the attribute is above one half"
      options={[{ value: '', text: 'None' }, ...names.map((name) => ({ value: name, text: name }))]}
      value={pinValue(pins, 'attribute')}
      onChange={(name) => setPins(withPins(pins, 'attribute', name))}
    />
  );
}

function describePins(): string {
  const held = results.pins.value?.vertices.length ?? 0;
  const total = results.body.value?.inspection.vertices ?? 0;
  if (wants.settings.value.pins === '') return 'Nothing: the body floats freely.';
  return `${count(held)} of ${count(total)} vertices.`;
}

function PinsText() {
  const id = useId();
  const refused = status.refusedPins.value;
  return (
    <>
      <details class="more as-text">
        <summary>As text</summary>
        <p id={`${id}-help`} class="hint">
          {OPTIONS.pins.help}
        </p>
        <input
          aria-label="Held in place, as text"
          type="text"
          spellcheck={false}
          autocomplete="off"
          aria-invalid={refused !== null}
          aria-describedby={refused ? `${id}-refused` : `${id}-help`}
          value={refused ? refused.text : wants.settings.value.pins}
          onChange={(event) => setPins(event.currentTarget.value)}
        />
      </details>
      {refused && (
        <p id={`${id}-refused`} class="hint bad" role="alert">
          {refused.why}
        </p>
      )}
    </>
  );
}
