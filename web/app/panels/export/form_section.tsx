/** The format of the file, how it stores vertices, and what it contains in addition to the meshes. */

import type { Compression } from '../../../engine/core/output_choices';
import { OPTIONS } from '../../../engine/settings/options';
import { EXPORT_FORMATS, exportFormatOf } from '../../worker/export_form';
import { changeSettings, wants } from '../../state/store';
import { Select, Toggle } from '../../controls/controls';
import { say } from '../../language/say';

const FORMATS = EXPORT_FORMATS.map(({ value, text }) => ({ value, text }));

export const COMPRESSION_NAMES: Record<Compression, string> = {
  'like-input': 'as in the file',
  none: 'none',
  quantized: 'quantized',
  meshopt: 'meshopt',
  draco: 'Draco',
};

/** What each kind of compression requires of the programs that open the file. */
const COMPRESSION_WORDS: Record<Compression, string> = {
  'like-input': 'Vertices are stored as they came.',
  none: 'Every program reads it.',
  quantized: 'About half the size; most engines draw it without decoding (KHR_mesh_quantization).',
  meshopt: 'Small and quick to open in three.js, Babylon.js and PlayCanvas (EXT_meshopt_compression).',
  draco: 'The smallest, slower to open; most web viewers read it (KHR_draco_mesh_compression).',
};

export function FormSection() {
  const { compress } = wants.settings.value;
  const format = exportFormatOf(wants.settings.value);
  return (
    <>
      <Select
        label={OPTIONS.format.label}
        options={FORMATS}
        value={format.value}
        onChange={(value) =>
          changeSettings({ format: EXPORT_FORMATS.find((one) => one.value === value)!.value })
        }
      />
      {format.isGltf && (
        <>
          <Select
            label={OPTIONS.compress.label}
            title={OPTIONS.compress.help}
            options={OPTIONS.compress.choices.map((value) => ({
              value,
              text: COMPRESSION_NAMES[value as Compression],
            }))}
            value={compress}
            onChange={(value) => changeSettings({ compress: value as Compression })}
          />
          <p class="hint">{say(COMPRESSION_WORDS[compress])}</p>
        </>
      )}
      <Toggle
        label="Strain and curvature as attributes"
        checked={wants.exportFields.value}
        onChange={(checked) => (wants.exportFields.value = checked)}
      />
      <Toggle
        label="Binding of the original's vertices"
        checked={wants.exportBinding.value}
        onChange={(checked) => (wants.exportBinding.value = checked)}
      />
    </>
  );
}
