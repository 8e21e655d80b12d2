/** The sliders and switches of a section of the page, from the table of settings. */

import { OPTIONS, SETTING_NAMES, readsSetting } from '../../engine/settings/options';
import type { PageSection, SettingName, Settings } from '../../engine/settings/options';
import { changeSettings, wants } from '../state/store';
import { SettingRange, Toggle } from './controls';
import { useSettingWords } from './setting_words';
import type { NumberSetting } from './controls';

type SwitchSetting = { [Name in SettingName]: Settings[Name] extends boolean ? Name : never }[SettingName];

const isNumber = (name: SettingName): name is NumberSetting =>
  OPTIONS[name].kind === 'number' || OPTIONS[name].kind === 'integer';
const isSwitch = (name: SettingName): name is SwitchSetting => OPTIONS[name].kind === 'switch';

/** Sliders first, then switches, each in the order of the table; settings that the method does not read are omitted. */
export function SettingControls({ section }: { section: PageSection }) {
  const settings = wants.settings.value;
  const shown = SETTING_NAMES.filter(
    (name) => OPTIONS[name].page === section && readsSetting(settings, name),
  );
  return (
    <>
      {shown.filter(isNumber).map((name) => (
        <SettingRange key={name} name={name} />
      ))}
      {shown.filter(isSwitch).map((name) => (
        <SettingSwitch key={name} name={name} />
      ))}
    </>
  );
}

function SettingSwitch({ name }: { name: SwitchSetting }) {
  const words = useSettingWords(name);
  return (
    <div class="toggle-row">
      <Toggle
        label={OPTIONS[name].label}
        title={OPTIONS[name].help}
        checked={wants.settings.value[name]}
        onChange={(isOn) => changeSettings({ [name]: isOn })}
      />
      {words.button}
      {words.sentences}
    </div>
  );
}
