/** The regions whose triangles are kept or locked: painted in the viewport, or given as text. */

import { useId } from 'preact/hooks';
import { LOCKED } from '../../../engine/settings/paint_text';
import { OPTIONS } from '../../../engine/settings/options';
import { clearPaint, shownLevels } from '../../state/paint';
import { changeSettings, isBrushing, results, view, wants } from '../../state/store';
import type { BrushTool } from '../../state/store';
import { setLock, refusedLock } from '../../state/locks';
import { PAINT } from '../../viewer/surface_material';
import { Choice, Range, Section, Select } from '../../controls/controls';
import { RefusedText } from '../../controls/refused_text';
import { count, fixed } from '../../controls/numbers';
import './brush_section.css';
import { say } from '../../language/say';

/** % of the diagonal */
export const BRUSH_RADIUS = { min: 0.5, max: 25 };

const TOOLS: { value: BrushTool | 'off'; text: string; title: string }[] = [
  { value: 'off', text: 'Turn', title: 'The left button turns the view (Esc)' },
  { value: 'keep', text: 'Keep', title: 'Paint where triangles are kept' },
  { value: 'lock', text: 'Lock', title: 'Paint vertices that stay as they are' },
  { value: 'erase', text: 'Erase', title: 'Erase what was painted' },
];

export function BrushSection() {
  const { value: brush } = view.brush;
  return (
    <Section title="Brush">
      <Choice
        label="Brush"
        options={TOOLS}
        value={brush.tool ?? 'off'}
        onChange={(tool) => (view.brush.value = { ...brush, tool: tool === 'off' ? null : tool })}
      />
      {isBrushing.value && <BrushShape />}
      <Painted />
    </Section>
  );
}

function BrushShape() {
  const { value: brush } = view.brush;
  return (
    <>
      <Range
        label="Radius"
        {...BRUSH_RADIUS}
        step={0.5}
        value={brush.radius}
        shown={`${fixed(brush.radius, 1)} %`}
        title="In % of the diagonal ([ and ])"
        onInput={(radius) => (view.brush.value = { ...view.brush.value, radius })}
      />
      {brush.tool === 'keep' && (
        <Range
          label="Soft edge"
          min={0}
          max={1}
          step={0.05}
          value={brush.softness}
          shown={`${Math.round(100 * brush.softness)} %`}
          onInput={(softness) => (view.brush.value = { ...view.brush.value, softness })}
        />
      )}
      <p class="hint">{say('Drag over either mesh to paint the original. Shift erases, Esc ends.')}</p>
    </>
  );
}

function Painted() {
  const levels = shownLevels.value;
  if (!levels) return null;
  const locked = levels.filter((level) => level === LOCKED).length;
  const kept = levels.filter((level) => level > 0).length - locked;
  const words = [
    kept > 0 ? say('{count} kept', { count: count(kept) }) : '',
    locked > 0 ? say('{count} locked', { count: count(locked) }) : '',
  ];
  return (
    <div class="status-row">
      <p class="hint" role="status">
        {kept > 0 && (
          <span class="paint-key" style={{ '--paint': PAINT.keep }}>
            {words[0]}
          </span>
        )}
        {locked > 0 && (
          <span class="paint-key" style={{ '--paint': PAINT.lock }}>
            {words[1]}
          </span>
        )}
      </p>
      <button type="button" class="quiet" aria-label={say('Clear the paint')} onClick={clearPaint}>
        {say('Clear')}
      </button>
    </div>
  );
}

/** The same without a pointer: an attribute of the file, and vertices as text. */
export function NamedLocks() {
  const { keep, pins, lock } = wants.settings.value;
  const names = results.body.value?.pinAttributes ?? [];
  return (
    <>
      {names.length > 0 && (
        <Select
          label={OPTIONS.keep.label}
          title={OPTIONS.keep.help}
          options={[{ value: '', text: 'None' }, ...names.map((name) => ({ value: name, text: name }))]}
          value={keep}
          onChange={(name) => changeSettings({ keep: name })}
        />
      )}
      <LockText />
      <div class="buttons">
        <button
          type="button"
          disabled={pins === ''}
          title={say('Locks the pinned vertices of the Motion step')}
          onClick={() => setLock(lock === '' ? pins : `${lock}+${pins}`)}
        >
          {say('Lock pinned vertices')}
        </button>
        <button type="button" disabled={lock === ''} onClick={() => setLock('')}>
          {say('Unlock')}
        </button>
      </div>
    </>
  );
}

function LockText() {
  const id = useId();
  const refused = refusedLock.value;
  return (
    <div class="control stacked">
      <label for={id}>{say(OPTIONS.lock.label)}</label>
      <input
        id={id}
        type="text"
        spellcheck={false}
        autocomplete="off"
        placeholder={say('low:6 + box:0,0,0,1,1,1')}
        title={say(OPTIONS.pins.help)}
        aria-invalid={refused !== null}
        aria-describedby={refused ? `${id}-refused` : undefined}
        value={refused ? refused.text : wants.settings.value.lock}
        onChange={(event) => setLock(event.currentTarget.value)}
      />
      <RefusedText id={`${id}-refused`} refused={refused} />
    </div>
  );
}
