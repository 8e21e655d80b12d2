/** Presets for the purpose of the result: their changes are listed before they are applied. */

import { useState } from 'preact/hooks';
import { PRESET_NAMES, presetChanges, PRESETS, settingsOfPreset } from '../../../engine/settings/presets';
import type { PresetName } from '../../../engine/settings/presets';
import { changeSettings, wants } from '../../state/store';
import { Section, Select } from '../../controls/controls';
import { labelOf, valueWords } from './setting_values';
import { say } from '../../language/say';

const CHOICES = [
  { value: '', text: 'choose' },
  ...PRESET_NAMES.map((name) => ({ value: name as string, text: PRESETS[name].label })),
];

export function PresetSection() {
  const [preset, setPreset] = useState<PresetName | null>(null);
  return (
    <Section title="Made for">
      <Select
        label="Preset"
        options={CHOICES}
        value={preset ?? ''}
        onChange={(value) => setPreset(PRESET_NAMES.find((name) => name === value) ?? null)}
      />
      {preset && <Changes preset={preset} />}
    </Section>
  );
}

function Changes({ preset }: { preset: PresetName }) {
  const changes = presetChanges(preset, wants.settings.value);
  return (
    <>
      <p class="hint">{say(PRESETS[preset].why)}</p>
      {changes.length === 0 && <p class="verdict good">{say('All of these are set.')}</p>}
      {changes.length > 0 && (
        <>
          <ul class="changes">
            {changes.map(({ name, from, to }) => (
              <li key={name}>
                {labelOf(name)}: <span class="muted">{valueWords(name, from)} →</span>{' '}
                <strong>{valueWords(name, to)}</strong>
              </li>
            ))}
          </ul>
          <button type="button" onClick={() => changeSettings(settingsOfPreset(preset))}>
            {say('Use these settings')}
          </button>
        </>
      )}
    </>
  );
}
