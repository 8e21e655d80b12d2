/** The pins: the ends of the body, vertices picked in the viewport, an attribute of the file, or a text. */

import { useId } from 'preact/hooks';
import { OPTIONS } from '../../../engine/settings/options';
import { hasPins, pinValue, withPins } from '../../../engine/settings/pin_edits';
import { pinEnds } from '../../state/ends';
import { setPins } from '../../state/pins';
import { isPicking, results, status, view, wants } from '../../state/store';
import { Section, Select } from '../../controls/controls';
import { RefusedText } from '../../controls/refused_text';
import { count } from '../../controls/numbers';
import { say } from '../../language/say';

/** The size of an end of the body, in % of its length. */
const END = '6';

export function PinsSection() {
  const ends = pinEnds.value;
  return (
    <Section title="Held in place">
      <div class="buttons">
        {ends && <EndButton kind="low" text={ends.low} />}
        {ends && <EndButton kind="high" text={ends.high} />}
        <button
          type="button"
          aria-pressed={isPicking.value}
          title={say('Click vertices or paint over the surface; Shift unpins, Escape ends')}
          onClick={() => (view.picking.value = !view.picking.value)}
        >
          {say('Pick')}
        </button>
      </div>
      {isPicking.value && (
        <p class="hint">
          {say(
            'Click a vertex or paint over the surface, or press Enter for the middle of the picture. Shift unpins, Esc ends.',
          )}
        </p>
      )}
      <AttributeSelect />
      <PinsStatus />
      <PinsText />
    </Section>
  );
}

function PinsStatus() {
  return (
    <div class="status-row">
      <p class="hint" role="status">
        {describePins()}
      </p>
      <button
        type="button"
        class="quiet"
        disabled={wants.settings.value.pins === ''}
        aria-label={say('Clear the pins')}
        onClick={() => setPins('')}
      >
        {say('Clear')}
      </button>
    </div>
  );
}

function EndButton({ kind, text }: { kind: 'low' | 'high'; text: string }) {
  const { pins } = wants.settings.value;
  const isPinned = hasPins(pins, kind);
  return (
    <button
      type="button"
      aria-pressed={isPinned}
      title={say('Pins {share} % of the longest side at this end; as text {text}', {
        share: END,
        text: `${kind}:${END}`,
      })}
      onClick={() => setPins(withPins(pins, kind, isPinned ? '' : END))}
    >
      {say(text)}
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
      title="Pins the vertices at which the first component of the attribute is above one half"
      options={[{ value: '', text: 'None' }, ...names.map((name) => ({ value: name, text: name }))]}
      value={pinValue(pins, 'attribute')}
      onChange={(name) => setPins(withPins(pins, 'attribute', name))}
    />
  );
}

function describePins(): string {
  const pinned = results.pins.value?.vertices.length ?? 0;
  const total = results.body.value?.inspection.vertices ?? 0;
  if (wants.settings.value.pins === '') return say('Nothing: the body floats freely.');
  return say('{pinned} of {all} vertices.', { pinned: count(pinned), all: count(total) });
}

function PinsText() {
  const id = useId();
  const refused = status.refusedPins.value;
  return (
    <>
      <details class="more as-text">
        <summary>{say('As text')}</summary>
        <p id={`${id}-help`} class="hint">
          {say(OPTIONS.pins.help)}
        </p>
        <input
          aria-label={say('Held in place, as text')}
          type="text"
          spellcheck={false}
          autocomplete="off"
          aria-invalid={refused !== null}
          aria-describedby={refused ? `${id}-refused` : `${id}-help`}
          value={refused ? refused.text : wants.settings.value.pins}
          onChange={(event) => setPins(event.currentTarget.value)}
        />
      </details>
      <RefusedText id={`${id}-refused`} refused={refused} />
    </>
  );
}
