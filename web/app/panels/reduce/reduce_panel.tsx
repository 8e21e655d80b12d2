/** Step 3: the choice of the next edge, and the limits of the collapses. */

import { METHODS } from '../../../engine/core/methods';
import { methodChange, methodOf, OPTIONS, readsSetting } from '../../../engine/settings/options';
import type { Settings } from '../../../engine/settings/options';
import { changeSettings, wants } from '../../state/store';
import { MethodsButton } from '../methods/methods_button';
import { BrushSection, NamedLocks } from './brush_section';
import { FrequencyHint } from './frequency_hint';
import { Choice, Section, Select, SettingRange, Toggle } from '../../controls/controls';
import { SettingControls } from '../../controls/setting_controls';
import { ACROSS_SEAMS, StopReason } from './stop_reason';
import { AskVertex } from './why_card';
import { say } from '../../language/say';

const METHOD_CHOICES = METHODS.map(({ name, label, title }) => ({ value: name, text: label, title }));

export const FIX_BORDERS = 'Fix open borders';

export const FIT_CHOICES: readonly { value: Settings['fit']; text: string }[] = [
  { value: 'surface', text: 'To the surface' },
  { value: 'modal', text: 'To the modes of the shell' },
  { value: 'off', text: 'None' },
];

export function ReducePanel() {
  const settings = wants.settings.value;
  return (
    <>
      <Section title="Method">
        <Choice
          label="Method"
          options={METHOD_CHOICES}
          value={settings.method}
          onChange={(value) => changeSettings(methodChange(value))}
        />
        <SettingControls section="method" />
        <MethodsButton />
      </Section>
      <Section title="Stop before">
        <SettingControls section="limits" />
        {!methodOf(settings).needsGuidance && <SettingRange name="minAngle" />}
        <StopReason />
        <FrequencyHint />
      </Section>
      <BrushSection />
      <details class="more">
        <summary>{say('More')}</summary>
        <MoreSettings />
      </details>
    </>
  );
}

function MoreSettings() {
  const settings = wants.settings.value;
  const { fit, symmetry, borders, seams } = settings;
  return (
    <>
      {methodOf(settings).needsGuidance && <SettingRange name="minAngle" />}
      <SettingControls section="reduction" />
      {readsSetting(settings, 'fit') && (
        <Select
          label={OPTIONS.fit.label}
          title={OPTIONS.fit.help}
          options={FIT_CHOICES}
          value={fit}
          onChange={(value) => changeSettings({ fit: value as Settings['fit'] })}
        />
      )}
      <Toggle
        label="Keep the mirror symmetry"
        checked={symmetry !== 'off'}
        onChange={(on) => changeSettings({ symmetry: on ? 'on' : 'off' })}
      />
      <Toggle
        label={FIX_BORDERS}
        checked={borders === 'fixed'}
        onChange={(on) => changeSettings({ borders: on ? 'fixed' : 'free' })}
      />
      {readsSetting(settings, 'seams') && (
        <Toggle
          label={ACROSS_SEAMS}
          checked={seams === 'cross'}
          onChange={(on) => changeSettings({ seams: on ? 'cross' : 'keep' })}
        />
      )}
      <NamedLocks />
      <AskVertex />
    </>
  );
}
