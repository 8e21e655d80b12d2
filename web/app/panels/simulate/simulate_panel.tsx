/** Step 4: the scenario of both bodies, the accuracy of the simulation, and the display. */

import { useId, useState } from 'preact/hooks';
import { OPTIONS, checkSetting } from '../../../engine/settings/options';
import { SCENARIOS, scenarioWords } from '../../../engine/core/scenarios';
import type { Settings } from '../../../engine/settings/options';
import { scenarioEnds } from '../../state/ends';
import { refusalOf } from '../../state/refusal';
import type { Refusal } from '../../state/refusal';
import { problemOfPins } from '../../state/simulation';
import type { PinProblem } from '../../../engine/motion/pin_problems';
import { pinSource, twin } from '../../state/twin';
import type { PinSource } from '../../state/twin';
import { changeSettings, results, shownMesh, wants } from '../../state/store';
import { Choice, Section, Select, SettingRange, Toggle } from '../../controls/controls';
import { count } from '../../controls/numbers';
import { RefusedText } from '../../controls/refused_text';
import { SettingControls } from '../../controls/setting_controls';
import { ConvergenceCheck } from './convergence_check';
import { SolverSelect } from './solver_select';
import { say } from '../../language/say';

const SCENARIO_CHOICES = SCENARIOS.map(({ name, label }) => ({ value: name, text: label }));

/** The scenario, and the vertices that it pins. */
function describeScenario(scenario: Settings['scenario']): string {
  const ends = scenarioEnds.value;
  if (!ends) return '';
  const { pinned, sentence } = scenarioWords(scenario);
  const what = say(sentence, { end: say(ends.high) });
  const isPinned = pinSource.value !== 'scenario';
  if (isPinned && pinned === '') return say('Falls as far as its pins allow.');
  if (isPinned || pinned === '') return what;
  const pinnedEnds = pinned === 'both' ? say('Both ends') : say(ends[pinned]);
  return `${what} ${say('{ends} held.', { ends: pinnedEnds })}`;
}

const LAYOUTS = [
  { value: 'beside', text: 'Side by side' },
  { value: 'over', text: 'Overlaid' },
] as const;

export function SimulatePanel() {
  const { scenario } = wants.settings.value;
  return (
    <>
      <Section title="Where will it move?">
        <SolverSelect />
      </Section>
      <Section title="Scenario" hint={problemOfPins.value ? undefined : describeScenario(scenario)}>
        {problemOfPins.value && <PinProblemText problem={problemOfPins.value} />}
        <Select
          label="Scenario"
          title={OPTIONS.scenario.help}
          options={SCENARIO_CHOICES}
          value={scenario}
          onChange={(value) => changeSettings({ scenario: value as Settings['scenario'] })}
        />
        <PinSourceSelect />
        <SettingRange name="substeps" />
        <ConvergenceCheck />
      </Section>
      <Section title="View">
        <Choice
          label="Arrangement"
          options={LAYOUTS}
          value={twin.layout.value}
          onChange={(layout) => (twin.layout.value = layout)}
        />
        <Toggle
          label="Original driven by optimized"
          checked={twin.driven.value}
          onChange={(driven) => (twin.driven.value = driven)}
        />
      </Section>
      <More />
      <Waiting />
    </>
  );
}

/** What is to be done where the scenario cannot move the held vertices, or would tear them apart. */
function PinProblemText({ problem }: { problem: PinProblem }) {
  const end = say(scenarioEnds.value!.high);
  return (
    <>
      <p class="hint warning">
        {problem === 'still'
          ? say(
              '{end} is not held, and this scenario moves nothing else, so both meshes stand still. Hold it by scenario, or choose Sway.',
              { end },
            )
          : say(
              'This scenario moves only the held vertices on the side of {end}. They reach across the middle, so they are torn apart. Hold by scenario, or choose Sway.',
              { end },
            )}
      </p>
      <button type="button" onClick={() => (twin.chosenPinSource.value = 'scenario')}>
        {say('Hold by scenario')}
      </button>
    </>
  );
}

function More() {
  return (
    <details class="more">
      <summary>{say('More')}</summary>
      <CollidersText />
      <SettingControls section="simulation" />
      <Toggle
        label="Noise floor also in slow motion"
        checked={twin.alwaysNoise.value}
        onChange={(always) => (twin.alwaysNoise.value = always)}
      />
    </details>
  );
}

function PinSourceSelect() {
  const pins = results.pins.value?.vertices.length ?? 0;
  const options: { value: PinSource; text: string }[] = [
    { value: 'scenario', text: 'By scenario' },
    { value: 'corners', text: 'Top corners' },
  ];
  if (pins > 0) options.push({ value: 'pins', text: say('Pins ({count})', { count: count(pins) }) });
  return (
    <Select
      label="Held in place"
      title="Pinned on the original and transferred to the optimized mesh. “Pins” are those of step 2."
      options={options}
      value={pinSource.value}
      onChange={(source) => (twin.chosenPinSource.value = source as PinSource)}
    />
  );
}

/** A text that does not parse is refused with a sentence, and the colliders stay as they were. */
function CollidersText() {
  const id = useId();
  const [refused, setRefused] = useState<Refusal | null>(null);
  const change = (text: string) => {
    const colliders = text.replaceAll(/\s/g, '');
    const refusal = refusalOf(text, () => checkSetting('colliders', colliders));
    setRefused(refusal);
    if (!refusal) changeSettings({ colliders });
  };
  return (
    <div class="control as-text">
      <label for={id} title={say(OPTIONS.colliders.help)}>
        {say(OPTIONS.colliders.label)}
      </label>
      <input
        id={id}
        type="text"
        spellcheck={false}
        autocomplete="off"
        placeholder={say('ball:x,y,z,R')}
        aria-invalid={refused !== null}
        aria-describedby={refused ? `${id}-refused` : undefined}
        value={refused ? refused.text : wants.settings.value.colliders}
        onChange={(event) => change(event.currentTarget.value)}
      />
      <RefusedText id={`${id}-refused`} refused={refused} />
    </div>
  );
}

function Waiting() {
  if (twin.numbers.value || twin.failure.value) return null;
  return (
    <p class="hint">{shownMesh.value ? say('Starting ...') : say('Waiting for the optimized mesh ...')}</p>
  );
}
