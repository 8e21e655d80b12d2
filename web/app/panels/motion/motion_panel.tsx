/** Step 2: the elastic model, the material, the pins, and the animation of the modes. */

import { describeResiduals } from '../../../engine/body/health';
import { coarseVerticesOf, describeModels } from '../../../engine/core/mode_set';
import { OPTIONS, resolveModel } from '../../../engine/settings/options';
import type { Settings } from '../../../engine/settings/options';
import { areModesStale, changeSettings, results, view, wants } from '../../state/store';
import { Choice, Range, Section, Toggle } from '../../controls/controls';
import { count } from '../../controls/numbers';
import { SettingControls } from '../../controls/setting_controls';
import { MaterialSelect } from './material_section';
import { PinsSection } from './pins_section';
import { enumerated, say, sayCounted, sentence } from '../../language/say';

export const MODELS: { value: Settings['model']; text: string; title: string }[] = [
  {
    value: 'auto',
    text: 'Auto',
    title: "The paper's Laplacian for its method, otherwise solid where closed and shell where open",
  },
  { value: 'solid', text: 'Solid', title: 'A body filled with material: closed parts only' },
  { value: 'shell', text: 'Shell', title: 'A thin sheet that stretches and bends: physical frequencies' },
  {
    value: 'laplacian',
    text: 'Laplacian',
    title: 'Unit springs along the edges: smooth, nominal frequencies',
  },
];

const DIRECTIONS: { value: Settings['direction']; text: string }[] = [
  { value: 'all', text: 'All' },
  { value: 'x', text: 'X' },
  { value: 'y', text: 'Y' },
  { value: 'z', text: 'Z' },
];

export function MotionPanel() {
  return (
    <>
      <ModelSection />
      <PinsSection />
      <PlaySection />
      <details class="more">
        <summary>{say('More')}</summary>
        <Range
          label="Speed"
          min={0.2}
          max={3}
          step={0.1}
          value={view.speed.value}
          shown={`x${view.speed.value}`}
          onInput={(value) => (view.speed.value = value)}
        />
        <SettingControls section="material" />
        <SettingControls section="modes" />
        {!showsExactToggle() && <ExactToggle />}
      </details>
    </>
  );
}

function ModelSection() {
  const settings = wants.settings.value;
  return (
    <Section title="Model">
      <Choice
        label="Model"
        options={MODELS}
        value={settings.model}
        onChange={(model) => changeSettings({ model, modes: 'auto', modeWeights: [] })}
      />
      {resolveModel(settings) === 'laplacian' && (
        <div class="control">
          <span title={say(OPTIONS.direction.help)}>{say('Direction')}</span>
          <Choice
            label="Direction"
            options={DIRECTIONS}
            value={settings.direction}
            onChange={(direction) => changeSettings({ direction, modes: 'auto', modeWeights: [] })}
          />
        </div>
      )}
      <SolveNotes />
      {showsExactToggle() && <ExactToggle />}
      <MaterialSelect />
    </Section>
  );
}

function PlaySection() {
  return (
    <Section title="Swing">
      <Range
        label="Amplitude"
        min={0}
        max={20}
        step={0.5}
        value={view.amplitude.value}
        shown={`${view.amplitude.value} %`}
        onInput={(value) => (view.amplitude.value = value)}
      />
      <Toggle
        label="Play (Space)"
        checked={view.playing.value}
        onChange={(playing) => (view.playing.value = playing)}
      />
    </Section>
  );
}

/** Whether the modes were computed on a coarser copy, or would be without this choice. */
const showsExactToggle = (): boolean =>
  wants.settings.value.exact || (results.modes.value !== null && coarseVerticesOf(results.modes.value) > 0);

function ExactToggle() {
  return (
    <Toggle
      label={OPTIONS.exact.label}
      checked={wants.settings.value.exact}
      onChange={(exact) => changeSettings({ exact })}
    />
  );
}

/** Which models were used, whether the expected number of rigid motions was found, and how accurate the modes are. */
function SolveNotes() {
  const modes = results.modes.value;
  if (!modes) return null;
  if (areModesStale.value) return <p class="hint">{say('The modes shown are those of earlier settings.')}</p>;
  const total = (key: 'zeroModesExpected' | 'zeroModesFound') =>
    modes.components.reduce((sum, component) => sum + component[key], 0);
  const [expected, found] = [total('zeroModesExpected'), total('zeroModesFound')];
  const coarseVertices = coarseVerticesOf(modes);
  const residuals = coarseVertices > 0 ? [] : describeResiduals(modes.modes);
  const rigid = sayCounted(
    found,
    '{count} rigid motion found, {expected} expected',
    '{count} rigid motions found, {expected} expected',
    { expected },
  );
  const models =
    wants.settings.value.model === 'auto'
      ? enumerated(describeModels(modes.components).split(', ').map(sentence))
      : '';
  const isSound = expected === found && residuals.length === 0;
  const told = `${[rigid, ...residuals.map(sentence)].join('; ')}.`;
  return (
    <>
      {isSound && models !== '' && <p class="hint">{models}</p>}
      {isSound ? (
        <details class="more">
          <summary>{say('How it was solved')}</summary>
          <p class="hint">{told}</p>
        </details>
      ) : (
        <p class="hint warning">
          {models} {told}
        </p>
      )}
      {coarseVertices > 0 && (
        <p class="hint">
          {say('Modes from a copy with {count} vertices, enough to guide collapses.', {
            count: count(coarseVertices),
          })}
        </p>
      )}
    </>
  );
}
