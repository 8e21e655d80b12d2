/** Further levels of detail: their ratios, where they are written, and a preview. */

import { useId, useState } from 'preact/hooks';
import { describeFinerLevels } from '../../../engine/report/level_words';
import type { LevelStyle } from '../../../engine/core/output_choices';
import { OPTIONS } from '../../../engine/settings/options';
import { exportFormatOf } from '../../worker/export_form';
import { changeSettings, results, slider, wants } from '../../state/store';
import type { ExportResult } from '../../worker/protocol';
import { Section, Select, Toggle } from '../../controls/controls';
import { count, fileSize } from '../../controls/numbers';
import { RefusedText } from '../../controls/refused_text';
import { firstNoLevel, nextLevel, readLevels } from './level_chain';
import { LevelPreview } from './level_preview';
import { describeVerdict } from './verdict';
import { say, sentence } from '../../language/say';

const STYLES: Record<LevelStyle, string> = {
  files: 'separate files',
  nodes: 'nodes NAME_LOD0, _LOD1 ...',
  msft: 'MSFT_lod',
};

/** The programs that read each style. */
const STYLE_WORDS: Record<LevelStyle, string> = {
  files: 'One additional file for each level: NAME_lod1 and so on.',
  nodes:
    'Unity and Unreal make a level group of nodes with these names; other viewers show all of them at once.',
  msft: 'Babylon.js switches levels by the size on the screen; viewers that do not support this show the first level.',
};

export function LevelsSection({ exported }: { exported: ExportResult | null }) {
  const { lods, lodStyle } = wants.settings.value;
  const { isGltf } = exportFormatOf(wants.settings.value);
  return (
    <Section title="Levels of detail">
      <LevelsField />
      {exported && <FinerLevels {...exported.report} />}
      <LevelButtons />
      {lods.length > 0 && isGltf && (
        <>
          <Select
            label={OPTIONS.lodStyle.label}
            title={OPTIONS.lodStyle.help}
            isBelow
            options={OPTIONS.lodStyle.choices.map((value) => ({ value, text: STYLES[value as LevelStyle] }))}
            value={lodStyle}
            onChange={(value) => changeSettings({ lodStyle: value as LevelStyle })}
          />
          <p class="hint">{say(STYLE_WORDS[lodStyle])}</p>
        </>
      )}
      {exported && <LevelFiles exported={exported} />}
      {lods.length > 0 && (
        <Toggle
          label="See where they change"
          title="Shows each level at the size on the screen at which it takes over"
          checked={wants.levelsShown.value}
          onChange={(isShown) => (wants.levelsShown.value = isShown)}
        />
      )}
      {lods.length > 0 && wants.levelsShown.value && <LevelPreview />}
    </Section>
  );
}

/** The text field for the ratios of further levels, separated by commas. */
function LevelsField() {
  const id = useId();
  const { lods } = wants.settings.value;
  const [last, setLast] = useState<{ text: string; why: string; beside: string } | null>(null);
  // Levels that are changed elsewhere replace the text.
  const typed = last?.beside === lods.join() ? last : null;
  const refused = typed && typed.why !== '' ? typed : null;
  const change = (text: string) => {
    const { faces } = slider.value;
    const wrong = firstNoLevel(text, faces);
    const read = wrong === null ? (readLevels(text, faces) as number[]) : lods;
    const why = wrong === null ? '' : describeNoLevel(wrong, faces);
    setLast({ text, why, beside: read.join() });
    if (wrong === null) changeSettings({ lods: read });
  };
  return (
    <div class="control stacked">
      <label for={id}>{say(OPTIONS.lods.label)}</label>
      <input
        id={id}
        type="text"
        autocomplete="off"
        placeholder="0.25, 10 %, 500"
        title={say('Shares of the faces or numbers of faces, separated by commas')}
        aria-invalid={refused !== null}
        aria-describedby={refused ? `${id}-refused` : undefined}
        value={typed ? typed.text : lods.join(', ')}
        onChange={(event) => change(event.currentTarget.value)}
      />
      <RefusedText id={`${id}-refused`} refused={refused} />
    </div>
  );
}

const describeNoLevel = (word: string, faces: number): string =>
  say('“{word}” is not a level: give shares such as 25 % or 0.25, or numbers of up to {faces} faces.', {
    word,
    faces: count(faces),
  });

/** Why levels do not form a chain: they have more faces than the result before them. */
function FinerLevels({ output, levels = [] }: ExportResult['report']) {
  const written = levels.map(({ file, output: { faces } }) => ({ file, faces }));
  return describeFinerLevels(output?.faces ?? 0, written, `“${OPTIONS.lods.label}”`).map((text) => (
    <p key={text} class="hint warning">
      {sentence(`${text}.`)}
    </p>
  ));
}

function LevelButtons() {
  const { lods } = wants.settings.value;
  const { wanted, faces } = slider.value;
  const next = nextLevel(lods, faces > 0 ? wanted / faces : 1);
  return (
    <div class="buttons">
      <button
        type="button"
        disabled={next < OPTIONS.lods.min || results.history.value === null}
        onClick={() => changeSettings({ lods: [...lods, next] })}
      >
        {say('Add a level')}
      </button>
      {lods.length > 0 && (
        <button type="button" onClick={() => changeSettings({ lods: lods.slice(0, -1) })}>
          {say('Remove the last')}
        </button>
      )}
    </div>
  );
}

/** The files of levels that have one of their own. */
function LevelFiles({ exported }: { exported: ExportResult }) {
  if (exported.levels.length === 0) return null;
  return (
    <ul class="levels level-files">
      {exported.levels.map(({ name, faces, bytes, validation }) => (
        <li key={name}>
          <span class="filename">{name}</span>
          <span class="muted">
            {say('{faces} faces, {size}.', { faces: count(faces), size: fileSize(bytes.length) })}{' '}
            {validation && (
              <span class={validation.errors > 0 ? 'verdict bad' : 'verdict good'}>
                {describeVerdict(validation)}
              </span>
            )}
          </span>
        </li>
      ))}
    </ul>
  );
}
