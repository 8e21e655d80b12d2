/** Step 3: how the next edge is chosen, and the slider that replays the collapses. */

import { useRef } from 'preact/hooks';
import type { FrequencyFinding, Tried } from '../../../engine/stages/frequency_target';
import { describeRefused } from '../../../engine/report/report';
import { methodChange, methodOf, OPTIONS, readsSetting } from '../../../engine/settings/options';
import type { Settings } from '../../../engine/settings/options';
import { historyKey } from '../../state/keys';
import { changeSettings, results, shownFit, shownMesh, wantedFaces, wants } from '../../state/store';
import { BrushSection, NamedLocks } from './brush_section';
import { Choice, Section, SettingRange, Toggle } from '../../controls/controls';
import { count, fixed } from '../../controls/numbers';
import { SettingControls } from '../../controls/setting_controls';
import { AskVertex } from './why_card';

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

export function ReducePanel() {
  const settings = wants.settings.value;
  return (
    <>
      <Section title="Method">
        <Choice
          label="Method"
          options={METHODS}
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

const ACROSS_SEAMS = 'Collapse across texture seams';

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

/** Why there are more faces than asked for, and what was wished in vain. */
function StopReason() {
  const history = results.history.value;
  if (!history) return null;
  const frequency = shownFit.value?.frequency;
  const shown = (shownMesh.value?.mesh.triangles.length ?? 0) / 3;
  return (
    <>
      {history.note !== '' && <p class="hint warning">{history.note}.</p>}
      {wantedFaces.value < history.floorFaces && (
        <p class="hint warning">
          Stopped at {count(history.floorFaces)} faces: {describeRefused(history.refused)}.
          {history.heldBySeams && ` “${ACROSS_SEAMS}”, under More, goes on.`}
        </p>
      )}
      {frequency && (
        <p class={frequency.isBinding ? 'hint warning' : 'hint'}>{describeFrequency(frequency, shown)}</p>
      )}
    </>
  );
}

function describeFrequency({ isBinding, error, limit, tried }: FrequencyFinding, faces: number): string {
  const off = `the first six frequencies are off by at most ${fixed(error, 2)} %`;
  if (!isBinding) return `With ${count(faces)} faces ${off}.`;
  const failures = tried.filter((one) => one.error > limit && one.faces < faces);
  const nearest = failures.reduce<Tried | null>(
    (most, one) => (most && most.faces > one.faces ? most : one),
    null,
  );
  const fewer = nearest
    ? ` With ${count(nearest.faces)} faces it would be ${fixed(nearest.error, 2)} %.`
    : '';
  return `Stopped at ${count(faces)} faces, where ${off}.${fewer}`;
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
      <div class="track">
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
        <Marks />
      </div>
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

/** Labels nearer to each other than this would overlap, as a share of the slider. */
const LABEL_WIDTH = 0.045;

/** Where the deviation crosses 0.1, 0.5 and 1 %; a click goes there. */
function Marks() {
  const history = results.history.value;
  const found = results.marks.value;
  if (!history || found?.key !== historyKey(wants.settings.value)) return null;
  const { marks } = found;
  const place = (faces: number) => (faces - history.floorFaces) / (history.faces - history.floorFaces);
  return (
    <>
      {marks.map(({ deviation, faces }, i) => {
        const isLabelled = i === 0 || place(marks[i - 1].faces) - place(faces) > LABEL_WIDTH;
        const meaning = `Deviation of at most ${deviation} % before the fit: ${count(faces)} faces`;
        return (
          <button
            key={deviation}
            type="button"
            class="tick"
            style={{ left: `calc(8px + (100% - 16px) * ${place(faces)})` }}
            title={meaning}
            aria-label={meaning}
            onClick={() => (wants.faces.value = faces)}
          >
            {isLabelled ? `${i === 0 ? 'deviation ' : ''}${deviation} %` : ''}
          </button>
        );
      })}
    </>
  );
}
