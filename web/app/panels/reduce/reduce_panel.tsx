/** Step 3: how the next edge is chosen, and what limits the collapses. */

import { METHODS } from '../../../engine/core/methods';
import { methodChange, methodOf, OPTIONS, readsSetting } from '../../../engine/settings/options';
import { changeSettings, wants } from '../../state/store';
import { BrushSection, NamedLocks } from './brush_section';
import { Choice, Section, SettingRange, Toggle } from '../../controls/controls';
import { SettingControls } from '../../controls/setting_controls';
import { ACROSS_SEAMS, StopReason } from './stop_reason';
import { AskVertex } from './why_card';

const METHOD_CHOICES = METHODS.map(({ name, label, title }) => ({ value: name, text: label, title }));

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
      </Section>
      <Section title="Stop before">
        <SettingControls section="limits" />
        {!methodOf(settings).needsGuidance && <SettingRange name="minAngle" />}
        <StopReason />
      </Section>
      <BrushSection />
      <details class="more">
        <summary>More</summary>
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
        <Toggle
          label={OPTIONS.fit.label}
          checked={fit === 'on'}
          onChange={(on) => changeSettings({ fit: on ? 'on' : 'off' })}
        />
      )}
      <Toggle
        label="Keep the mirror symmetry"
        checked={symmetry !== 'off'}
        onChange={(on) => changeSettings({ symmetry: on ? 'on' : 'off' })}
      />
      <Toggle
        label="Fix open borders"
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
