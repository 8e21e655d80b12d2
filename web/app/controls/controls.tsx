/** Controls that the panels share. Settings take their texts and ranges from the table of settings. */

import type { ComponentChildren } from 'preact';
import { useId } from 'preact/hooks';
import { OPTIONS } from '../../engine/settings/options';
import type { OptionOf, Settings } from '../../engine/settings/options';
import { changeSettings, wants } from '../state/store';
import { NumberField } from './number_field';
import { useSettingWords } from './setting_words';
import { say } from '../language/say';

/** A setting whose value is a number. */
export type NumberSetting = { [K in keyof Settings]: Settings[K] extends number ? K : never }[keyof Settings];

export function Section(props: { title: string; hint?: string; children: ComponentChildren }) {
  return (
    <section class="section">
      <h2>{say(props.title)}</h2>
      {props.hint && <p class="hint">{say(props.hint)}</p>}
      {props.children}
    </section>
  );
}

interface RangeProps {
  label: string;
  min: number;
  max: number;
  step: number;
  value: number;
  shown?: string;
  title?: string;
  onInput(value: number): void;
}

export function Range({ label, min, max, step, value, shown, title, onInput }: RangeProps) {
  const id = useId();
  return (
    <div class="control" title={title && say(title)}>
      <label for={id}>{say(label)}</label>
      <output for={id}>{shown ?? value}</output>
      <input
        id={id}
        type="range"
        min={min}
        max={max}
        step={step}
        value={value}
        aria-valuetext={shown ?? String(value)}
        onInput={(event) => onInput(event.currentTarget.valueAsNumber)}
      />
    </div>
  );
}

/** The range of a slider, and the conversions between value and position. */
function scaleOf({ slider, step, ...range }: OptionOf<'number' | 'integer'>) {
  const { min, max } = slider ?? range;
  if (!slider?.isLogarithmic) return { min, max, step, toSlider: Number, fromSlider: Number };
  return {
    min: Math.log10(min),
    max: Math.log10(max),
    step: 0.01,
    toSlider: Math.log10,
    fromSlider: (position: number) => Number((10 ** position).toPrecision(2)),
  };
}

/** A setting as a slider over its useful span, with the exact number next to it. */
export function SettingRange({ name }: { name: NumberSetting }) {
  const id = useId();
  const { label, min, max, unit, help, kind, isOffAtZero }: OptionOf<'number' | 'integer'> = OPTIONS[name];
  const value = wants.settings.value[name];
  const isOff = isOffAtZero === true && value === 0;
  const set = (next: number) => {
    const whole = kind === 'integer' ? Math.round(next) : next;
    if (Number.isFinite(next)) changeSettings({ [name]: Math.min(max, Math.max(min, whole)) });
  };
  const scale = scaleOf(OPTIONS[name]);
  const words = useSettingWords(name);
  return (
    <div class="control" title={say(help)}>
      <span class="name">
        <label for={id}>{say(label)}</label>
        {words.button}
      </span>
      <span class="number">
        <NumberField
          aria-label={say('{label}, exact', { label: say(label) })}
          min={min}
          max={max}
          step="any"
          value={isOff ? null : value}
          placeholder={isOff ? say('off') : undefined}
          onEnter={set}
        />
        {unit && !isOff && <span class="unit">{unit.startsWith('%') ? '%' : say(unit)}</span>}
      </span>
      <input
        id={id}
        type="range"
        min={scale.min}
        max={scale.max}
        step={scale.step}
        value={scale.toSlider(value)}
        aria-valuetext={isOff ? say('off') : `${value}${unit ? ` ${say(unit)}` : ''}`}
        onInput={(event) => set(scale.fromSlider(event.currentTarget.valueAsNumber))}
      />
      {words.sentences}
    </div>
  );
}

interface SelectProps {
  label: string;
  options: readonly { value: string; text: string }[];
  value: string;
  title?: string;
  /** whether it is below its label, because its choices are long */
  isBelow?: boolean;
  onChange(value: string): void;
}

/** A drop-down list of choices. */
export function Select({ label, options, value, title, isBelow, onChange }: SelectProps) {
  const id = useId();
  return (
    <div class={isBelow ? 'control stacked' : 'control'} title={title && say(title)}>
      <label for={id}>{say(label)}</label>
      <select id={id} value={value} onChange={(event) => onChange(event.currentTarget.value)}>
        {options.map((option) => (
          <option key={option.value} value={option.value}>
            {say(option.text)}
          </option>
        ))}
      </select>
    </div>
  );
}

interface ChoiceProps<T extends string> {
  label: string;
  options: readonly { value: T; text: string; title?: string }[];
  value: T;
  onChange(value: T): void;
}

/** A few choices as adjacent buttons, one of them pressed. */
export function Choice<T extends string>({ label, options, value, onChange }: ChoiceProps<T>) {
  return (
    <div class="choice" role="group" aria-label={say(label)}>
      {options.map((option) => (
        <button
          key={option.value}
          type="button"
          aria-pressed={option.value === value}
          title={option.title && say(option.title)}
          onClick={() => onChange(option.value)}
        >
          {say(option.text)}
        </button>
      ))}
    </div>
  );
}

export function Toggle(props: {
  label: string;
  title?: string;
  checked: boolean;
  onChange(checked: boolean): void;
}) {
  return (
    <label class="toggle" title={props.title && say(props.title)}>
      <input
        type="checkbox"
        checked={props.checked}
        onChange={(event) => props.onChange(event.currentTarget.checked)}
      />
      <span>{say(props.label)}</span>
    </label>
  );
}
