/** Step 3: how the next edge is chosen, and the slider that replays the collapses. */

import { useRef } from 'preact/hooks';
import { describeRefused } from '../../engine/report';
import { methodChange, OPTIONS } from '../../engine/options';
import type { Settings } from '../../engine/options';
import { changeSettings, results, view, wantedFaces, wants } from '../state/store';
import type { Layout } from '../state/store';
import { BrushSection, NamedLocks } from './brush_section';
import { Choice, Section, SettingRange, Toggle, count, fixed } from './controls';
import './reduce.css';

const METHODS: { value: Settings['method']; text: string; title: string }[] = [
  {
    value: 'limber',
    text: 'Motion',
    title: 'Shape, triangle sizes and strain guide the collapses; then the result is fitted to the modes',
  },
  {
    value: 'paper',
    text: 'Paper',
    title: 'Strain, curvature and triangle shape guide the collapses (Eq. 11 of the paper)',
  },
  { value: 'qem', text: 'Shape only', title: 'Area-weighted quadrics alone' },
];

const LAYOUTS: { value: Layout; text: string }[] = [
  { value: 'both', text: 'Both' },
  { value: 'original', text: 'Original' },
  { value: 'optimized', text: 'Optimized' },
];

export function ReducePanel() {
  const { method, fit } = wants.settings.value;
  return (
    <>
      <Section title="Method">
        <Choice
          label="Method"
          options={METHODS}
          value={method}
          onChange={(value) => changeSettings(methodChange(value))}
        />
        {method !== 'qem' && (
          <>
            <SettingRange name="strainWeight" />
            {method === 'paper' && <SettingRange name="curvatureWeight" />}
            <SettingRange name="qualityWeight" />
            {method === 'limber' && <SettingRange name="sizeWeight" />}
          </>
        )}
        {method === 'limber' && (
          <Toggle
            label={OPTIONS.fit.label}
            checked={fit === 'on'}
            onChange={(on) => changeSettings({ fit: on ? 'on' : 'off' })}
          />
        )}
      </Section>
      <BrushSection />
      <Section title="View">
        <Choice
          label="Compare"
          options={LAYOUTS}
          value={view.layout.value}
          onChange={(layout) => (view.layout.value = layout)}
        />
      </Section>
      <StopReason />
      <details class="more">
        <summary>More</summary>
        <NamedLocks />
      </details>
    </>
  );
}

function StopReason() {
  const history = results.history.value;
  if (!history || wantedFaces.value >= history.floorFaces) return null;
  return (
    <p class="hint warning">
      Stopped at {count(history.floorFaces)} faces: {describeRefused(history.refused)}.
    </p>
  );
}

export function Scrubber() {
  const history = results.history.value;
  const total = history?.faces ?? results.body.value?.inspection.faces ?? 0;
  const floor = history?.floorFaces ?? 0;
  const value = Math.min(total, Math.max(floor, wantedFaces.value));
  const set = (faces: number) => {
    if (Number.isFinite(faces)) wants.faces.value = Math.min(total, Math.max(1, Math.round(faces)));
  };
  const field = useRef<HTMLInputElement>(null);
  return (
    <div class="scrubber">
      <label for="faces">Kept faces</label>
      <input
        id="faces"
        type="range"
        min={floor}
        max={total}
        step={1}
        value={value}
        disabled={!history}
        aria-valuetext={`${count(value)} of ${count(total)} faces`}
        onInput={(event) => set(event.currentTarget.valueAsNumber)}
      />
      <input
        ref={field}
        type="number"
        class="exact"
        aria-label="Kept faces, exact"
        min={1}
        max={total}
        value={value}
        onChange={(event) => set(event.currentTarget.valueAsNumber)}
      />
      <span class="muted ratio">{total > 0 ? `${fixed((100 * value) / total, 1)} %` : ''}</span>
    </div>
  );
}
