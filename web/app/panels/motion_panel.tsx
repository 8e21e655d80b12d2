/** Step 2: how the body bends, and which of its modes count. */

import { describeSolve } from '../../engine/health';
import { coarseVerticesOf } from '../../engine/mode_set';
import { resolveModel, resolveModes } from '../../engine/options';
import type { Settings } from '../../engine/options';
import { changeSettings, results, view, wants } from '../state/store';
import { Choice, Range, Section, SettingRange, Toggle } from './controls';

const MODELS: { value: Settings['model']; text: string; title: string }[] = [
  {
    value: 'auto',
    text: 'Auto',
    title: "The paper's Laplacian for its method, otherwise solid where closed and shell where open",
  },
  {
    value: 'laplacian',
    text: 'Laplacian',
    title: 'Unit springs along the edges: smooth, nominal frequencies',
  },
  { value: 'shell', text: 'Shell', title: 'A thin sheet that stretches and bends: physical frequencies' },
  { value: 'solid', text: 'Solid', title: 'A body filled with material: closed parts only' },
];

export function MotionPanel() {
  const settings = wants.settings.value;
  return (
    <>
      <Section
        title="Motion"
        hint="Click the mode that looks like the motion you expect; shift-click blends several."
      >
        <Choice
          label="Model"
          options={MODELS}
          value={settings.model}
          onChange={(model) => changeSettings({ model, modes: 'auto' })}
        />
        <Range
          label="Amplitude"
          min={0}
          max={20}
          step={0.5}
          value={view.amplitude.value}
          shown={`${view.amplitude.value} %`}
          onInput={(value) => (view.amplitude.value = value)}
        />
        <Range
          label="Speed"
          min={0.2}
          max={3}
          step={0.1}
          value={view.speed.value}
          shown={`x${view.speed.value}`}
          onInput={(value) => (view.speed.value = value)}
        />
        <Toggle
          label="Play (Space)"
          checked={view.playing.value}
          onChange={(playing) => (view.playing.value = playing)}
        />
      </Section>
      <Section title="Strain that counts" hint="Ranks below the threshold are treated as not strained.">
        <SettingRange name="strainThreshold" />
      </Section>
      <details class="more">
        <summary>More</summary>
        <SettingRange name="modeCount" />
        <SettingRange name="p" />
      </details>
      <ZeroModes />
    </>
  );
}

function ZeroModes() {
  const modes = results.modes.value;
  if (!modes) return null;
  const total = (key: 'zeroModesExpected' | 'zeroModesFound') =>
    modes.components.reduce((sum, component) => sum + component[key], 0);
  const [expected, found] = [total('zeroModesExpected'), total('zeroModesFound')];
  const notes = describeSolve(modes.modes, coarseVerticesOf(modes));
  const text = [`${found} rigid motions found, ${expected} expected`, ...notes].join('; ');
  return <p class={expected === found && notes.length === 0 ? 'hint' : 'hint warning'}>{text}.</p>;
}

/** The guiding modes, from 1. */
export const guidingModes = (): number[] => resolveModes(wants.settings.value);

/** A click takes one mode; with `blend` it joins the others or leaves them. */
export function chooseMode(mode: number, blend: boolean): void {
  const chosen = guidingModes();
  if (!blend) return changeSettings({ modes: [mode], modeWeights: [] });
  const next = chosen.includes(mode)
    ? chosen.filter((other) => other !== mode)
    : [...chosen, mode].sort((a, b) => a - b);
  if (next.length > 0) changeSettings({ modes: next, modeWeights: [] });
}

/** Whether frequencies are only in proportion. */
export const isNominal = (): boolean => resolveModel(wants.settings.value) === 'laplacian';
