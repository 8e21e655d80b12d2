/** The choice of a named material. */

import { MATERIALS, MATERIAL_NAMES, materialNameOf } from '../../../engine/settings/materials';
import type { MaterialName } from '../../../engine/settings/materials';
import { resolveModel } from '../../../engine/settings/options';
import { changeSettings, wants } from '../../state/store';
import { Select } from '../../controls/controls';
import { say } from '../../language/say';

const capital = (word: string): string => word[0].toUpperCase() + word.slice(1);

/** No preset has this name. */
const CUSTOM = 'custom';

export function MaterialSelect() {
  const settings = wants.settings.value;
  const name = materialNameOf(settings) ?? CUSTOM;
  const names = name === CUSTOM ? [...MATERIAL_NAMES, CUSTOM] : MATERIAL_NAMES;
  return (
    <>
      <Select
        label="Material"
        options={names.map((value) => ({ value, text: capital(value) }))}
        value={name}
        onChange={(chosen) => {
          if (chosen !== CUSTOM) changeSettings({ ...MATERIALS[chosen as MaterialName] });
        }}
      />
      {resolveModel(settings) === 'laplacian' && (
        <p class="hint">{say('The Laplacian ignores the material.')}</p>
      )}
    </>
  );
}
